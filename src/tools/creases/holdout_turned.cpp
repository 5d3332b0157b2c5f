// SPDX-License-Identifier: Apache-2.0
// Holdout: turned parts and vessels.
#include <algorithm>

#include "math/functions.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

Solid pulley() {
    Solid s;
    s.add_revolved(Path(0.3, 0)
                       .to(1.2, 0, 'a')
                       .to(1.2, 0.1, 'b')
                       .to(0.8, 0.3, 'c')
                       .to(0.8, 0.4, 'd')
                       .to(1.2, 0.6, 'e')
                       .to(1.2, 0.7, 'f')
                       .to(0.5, 0.7, 'g')
                       .to(0.5, 1.1, 'h')
                       .to(0.3, 1.1, 'i')
                       .close('j'),
                   32);
    return s;
}

/// The inner ring of a ball bearing.
Solid bearing_ring() {
    Path p(0.8, 0);
    p.to(1, 0, 'a')
        .to(polar({1.1, 0.3}, 0.224, 243.5), 'b')
        .arc({1.1, 0.3}, 0.224, 243.5, 116.5, 6, 'c')
        .to(1, 0.6, 'd');
    Solid s;
    s.add_revolved(p.to(0.8, 0.6, 'e').close('f'), 40);
    return s;
}

/// Twelve hollow flutes that meet in sharp edges; the column swells.
Solid fluted_column() {
    std::vector<dvec2> points;
    std::vector<int> labels;
    for (int k = 0; k < 12; ++k)
        for (int i = 0; i < 4; ++i) {
            const double t = i / 4.0;
            points.push_back(polar({}, 1 - 0.36 * t * (1 - t), 30 * (k + t))), labels.push_back(k);
        }
    Solid s;
    std::vector<Loop> sections;
    for (const auto& [scale, z] :
         {std::pair(1.0, 0.0), std::pair(1.02, 2.0), std::pair(0.98, 4.0), std::pair(0.88, 6.0)}) {
        Loop loop;
        for (const dvec2& p : points) loop.push_back({scale * p.x, scale * p.y, z});
        sections.push_back(loop);
    }
    s.add_loft(sections, labels);
    Loop bottom = sections.front();
    std::ranges::reverse(bottom);
    s.add_flat(bottom, {}, s.new_surface());
    s.add_flat(sections.back(), {}, s.new_surface());
    return s;
}

Solid bell_nozzle() {
    Path p(0.3, 0);
    const auto outer = [](double z) { return 0.36 + 0.35 * z - 0.05 * z * z; };
    p.to(outer(0), 0, 'a');
    for (int i = 1; i <= 8; ++i) p.to(outer(0.25 * i), 0.25 * i, 'b');
    p.to(outer(2) - 0.06, 2, 'c');
    for (int i = 7; i > 0; --i) p.to(outer(0.25 * i) - 0.06, 0.25 * i, 'd');
    Solid s;
    s.add_revolved(p.close('d'), 36);
    return s;
}

/// Ten round lobes that meet in hollow edges.
Solid star_knob() {
    Path p(polar({}, 0.9, 0));
    for (int k = 0; k < 10; ++k)
        for (int i = 1; i <= 5 - (k == 9); ++i) {
            const double t = i / 5.0;
            p.to(polar({}, 0.9 + 0.8 * t * (1 - t), 36 * (k + t)), k);
        }
    Solid s;
    s.add_extruded(p.close(9), 0, 0.6, {circle({}, 0.25, 16, 'a')});
    return s;
}

Solid mug() {
    Path p(0, 0);
    p.to(0.9, 0, 'a')
        .to(0.9, 1.9, 'b')
        .arc({0.84, 1.9}, 0.06, 0, 180, 4, 'b')
        .to(0.78, 0.3, 'b')
        .arc({0.58, 0.3}, 0.2, 0, -90, 3, 'b');
    Solid s;
    s.add_revolved(p.to(0, 0.1, 'b'), 28);
    return s;
}

Solid barrel() {
    const auto radius = [](double z) { return 1 - 0.2 * (z - 1) * (z - 1); };
    Path p(0, 0);
    p.to(radius(0), 0, 'a').to(radius(0.3), 0.3, 'b');
    p.to(radius(0.3) + 0.05, 0.3, 'c').to(radius(0.5) + 0.05, 0.5, 'd').to(radius(0.5), 0.5, 'e');
    for (const double z : {0.75, 1.0, 1.25, 1.5}) p.to(radius(z), z, 'f');
    p.to(radius(1.5) + 0.05, 1.5, 'g').to(radius(1.7) + 0.05, 1.7, 'h').to(radius(1.7), 1.7, 'i');
    Solid s;
    s.add_revolved(p.to(radius(2), 2, 'j').to(0, 2, 'k'), 14);
    return s;
}

/// Two caps of spheres that meet in a rim.
Solid lens() {
    Path p(0, -0.268);
    for (int i = 1; i <= 5; ++i) p.to(2 * math::sin(radians(6 * i)), 1.732 - 2 * math::cos(radians(6 * i)), 'a');
    for (int i = 4; i > 0; --i) p.to(2 * math::sin(radians(6 * i)), 2 * math::cos(radians(6 * i)) - 1.732, 'b');
    Solid s;
    s.add_revolved(p.to(0, 0.268, 'b'), 20);
    return s;
}

/// Flat inside, round outside.
Solid finger_ring() {
    Solid s;
    s.add_revolved(Path(1, -0.25).arc({1, 0}, 0.25, -90, 90, 6, 'a').close('b'), 32);
    return s;
}

Solid rocket() {
    Path p(0, 0);
    p.to(0.35, 0, 'a').to(0.5, -0.3, 'b').to(0.65, -0.3, 'c').to(0.5, 0.2, 'd').to(0.5, 3, 'e');
    for (int i = 1; i <= 6; ++i)
        p.to(i == 6 ? 0 : -1.5 + 2 * math::cos(radians(41.41 * i / 6)), 3 + 2 * math::sin(radians(41.41 * i / 6)), 'e');
    Solid s;
    s.add_revolved(p, 18);
    return s;
}

/// A bar cut at a slant.
Solid slanted_bar() {
    Solid s;
    s.add_extruded(circle({}, 0.5, 18, 'a'), 0, 4);
    s.cut({0, 0, 3}, {0.6, 0, 0.8});
    return s;
}

/// Three skirts on a trunk.
Solid fir() {
    Solid s;
    s.add_revolved(Path(0, 0)
                       .to(0.2, 0, 'a')
                       .to(0.2, 0.6, 'b')
                       .to(1, 0.5, 'c')
                       .to(0.35, 1.4, 'd')
                       .to(0.8, 1.3, 'e')
                       .to(0.25, 2.1, 'f')
                       .to(0.6, 2, 'g')
                       .to(0, 3, 'h'),
                   10);
    return s;
}

void add_holdout_turned(CreaseModels& to) {
    to.push_back(make_model("pulley with a V groove", pulley(), {.digits = 4}));
    to.push_back(make_model("bearing ring", bearing_ring(), {.bits = 14}));
    to.push_back(make_model("fluted column", fluted_column(), {.digits = 4}));
    to.push_back(make_model("bell nozzle", bell_nozzle(), {.digits = 4}));
    to.push_back(make_model("star knob", star_knob(), {.digits = 3}));
    to.push_back(make_model("mug", mug(), {.digits = 4}));
    to.push_back(make_model("barrel with hoops", barrel(), {.digits = 4}));
    to.push_back(make_model("lens with a sharp rim", lens(), {.digits = 5}));
    to.push_back(make_model("finger ring", finger_ring(), {.digits = 4, .diagonals = Diagonals::random}));
    to.push_back(make_model("rocket", rocket(), {.bits = 14}));
    to.push_back(make_model("bar cut at a slant", slanted_bar(), {.digits = 4}));
    to.push_back(make_model("fir of three skirts", fir(), {.digits = 3}));
}

}  // namespace

constinit const ModelFamily holdout_turned{.add = add_holdout_turned, .is_holdout = true};

}  // namespace rakelight
