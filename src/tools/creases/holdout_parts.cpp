// SPDX-License-Identifier: Apache-2.0
// Holdout: extruded and lofted machine parts.
#include <algorithm>

#include "math/functions.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

/// Cylinder head with a chamfer, a hexagonal recess, and a shank.
Solid socket_screw() {
    Solid s;
    s.add_revolved(Path(0, -2).to(0.5, -2, 'a').to(0.5, 0, 'b').to(1, 0, 'c').to(1, 0.85, 'd').to(0.85, 1, 'e'), 24);
    const Path hexagon = regular(6, 0.5, 15);
    s.add_flat(ring(0.85, 1, 24), {at_height(hexagon.points(), 1)}, s.new_surface());
    s.add_walls(hexagon, 0.4, 1, false);
    s.add_flat(at_height(hexagon.points(), 0.4), {}, s.new_surface());
    return s;
}

Solid flange() {
    std::vector<Path> holes = {circle({}, 0.8, 32, 'b')};
    for (int k = 0; k < 6; ++k) holes.push_back(circle(polar({}, 1.5, 60 * k + 10), 0.2, 12, 'h'));
    Solid s;
    s.add_extruded(circle({}, 2, 48, 'a'), 0, 0.4, holes);
    return s;
}

/// A pipe around a quarter of a circle, with a bore.
Solid pipe_bend() {
    const auto section = [](double radius, int i) {
        Loop loop;
        for (const dvec3& p : ring(radius, 0, 16)) loop.push_back(around(2 - p.x, i / 32.0, p.y));
        return loop;
    };
    Solid s;
    std::vector<Loop> outer, inner;
    for (int i = 0; i <= 8; ++i) outer.push_back(section(0.6, i)), inner.push_back(section(0.45, i));
    const std::vector<int> labels(16, 'a');
    s.add_loft(outer, labels);
    std::vector<Loop> back(inner.rbegin(), inner.rend());
    s.add_loft(back, labels);
    s.add_band(inner.front(), outer.front(), s.new_surface());
    s.add_band(outer.back(), inner.back(), s.new_surface());
    return s;
}

/// A wire of eight sides wound three times.
Solid spring() {
    std::vector<Loop> sections;
    for (int i = 0; i <= 48; ++i) {
        Loop loop;
        for (const dvec3& p : ring(0.18, 0, 8)) loop.push_back(around(1 - p.x, i / 16.0, p.y + i / 32.0));
        sections.push_back(loop);
    }
    Solid s;
    s.add_loft(sections, std::vector<int>(8, 'a'));
    Loop first = sections.front();
    std::ranges::reverse(first);
    s.add_flat(first, {}, s.new_surface());
    s.add_flat(sections.back(), {}, s.new_surface());
    return s;
}

/// Rounded corners, and bevels around both faces.
Solid phone() {
    const auto section = [](double inset, double z) {
        return at_height(rounded_rectangle(0.7 - inset, 1.4 - inset, 0.25 - inset, 6, true).points(), z);
    };
    Solid s;
    const Loop a = section(0.05, 0), b = section(0, 0.05), c = section(0, 0.15), d = section(0.05, 0.2);
    for (const auto& [low, high] : {std::pair(a, b), std::pair(b, c), std::pair(c, d)})
        s.add_band(low, high, s.new_surface());
    Loop bottom = a;
    std::ranges::reverse(bottom);
    s.add_flat(bottom, {}, s.new_surface());
    s.add_flat(d, {}, s.new_surface());
    return s;
}

/// A round head with a jaw, a waist and a handle with a hole.
Solid wrench() {
    Path p(polar({}, 1, 30));
    p.arc({}, 1, 30, 160, 8, 'a').to(-4, 0.34, 'b').arc({-4, 0}, 0.34, 90, 270, 8, 'b').to(polar({}, 1, 200), 'b');
    p.arc({}, 1, 200, 330, 8, 'd')
        .to(0.2, -0.5, 'e')
        .to(-0.3, -0.5, 'f')
        .to(-0.3, 0.5, 'g')
        .to(0.2, 0.5, 'h')
        .close('i');
    Solid s;
    s.add_extruded(p, 0, 0.5, {circle({-4, 0}, 0.15, 12, 'a')});
    return s;
}

Solid heat_sink() {
    Path p(0, 0);
    p.to(4.2, 0, 0);
    for (int k = 8; k >= 0; --k) {
        const double x = 0.5 * k;
        if (k < 8) p.to(x + 0.2, 0.4, 4 * k + 1);
        p.to(x + 0.2, 2, 4 * k + 2).to(x, 2, 4 * k + 3);
        if (k > 0) p.to(x, 0.4, 4 * k + 4);
    }
    Solid s;
    s.add_extruded(p.close(99), 0, 3);
    return s;
}

/// An angle with a rib in its middle.
Solid gusset() {
    const Path p = Path(0, 0)
                       .to(2, 0, 'a')
                       .to(2, 0.3, 'b')
                       .to(1.5, 0.3, 'c')
                       .to(0.3, 0.3, 'c')
                       .to(0.3, 1.5, 'd')
                       .to(0.3, 2, 'd')
                       .to(0, 2, 'e')
                       .close('f');
    const double z[] = {0, 0.6, 0.8, 1.4};
    Solid s;
    const std::vector<Surface> sides = s.new_surfaces(p.labels());
    const Surface slope = s.new_surface();
    for (int layer = 0; layer < 3; ++layer) {
        const Loop low = at_height(p.points(), z[layer]), high = at_height(p.points(), z[layer + 1]);
        for (std::size_t i = 0; i < low.size(); ++i) {
            const std::size_t next = (i + 1) % low.size();
            if (layer != 1 || (i != 3 && i != 4)) s.add({low[i], low[next], high[next], high[i]}, sides[i]);
        }
        if (layer == 1) s.add({low[3], low[5], high[5], high[3]}, slope);
    }
    const Loop below = at_height(p.points(), z[1]), above = at_height(p.points(), z[2]);
    s.add({below[3], below[4], below[5]}, s.new_surface());
    s.add({above[3], above[5], above[4]}, s.new_surface());
    Loop bottom = at_height(p.points(), z[0]);
    std::ranges::reverse(bottom);
    s.add_flat(bottom, {}, s.new_surface());
    s.add_flat(at_height(p.points(), z[3]), {}, s.new_surface());
    return s;
}

/// Steep and flat flanks by turns.
Solid ratchet() {
    Path p(polar({}, 1, 0));
    for (int k = 0; k < 16; ++k) {
        const double at = 22.5 * (k + 1);
        p.to(polar({}, 0.78, at - 3), 2 * k);
        if (k < 15) p.to(polar({}, 1, at), 2 * k + 1);
    }
    Solid s;
    s.add_extruded(p.close(31), 0, 0.3, {regular(6, 0.35)});
    return s;
}

/// A square bar with a T-shaped groove in each side and a bore.
Solid slotted_bar() {
    std::vector<dvec2> points;
    for (int k = 0; k < 4; ++k)
        for (const dvec2 p : {dvec2{1, -1}, dvec2{1, -0.27}, dvec2{0.82, -0.27}, dvec2{0.82, -0.5}, dvec2{0.66, -0.5},
                              dvec2{0.4, -0.24}, dvec2{0.4, 0.24}, dvec2{0.66, 0.5}, dvec2{0.82, 0.5},
                              dvec2{0.82, 0.27}, dvec2{1, 0.27}})
            points.push_back(k == 0 ? p : k == 1 ? dvec2{-p.y, p.x} : k == 2 ? dvec2{-p.x, -p.y} : dvec2{p.y, -p.x});
    Solid s;
    s.add_extruded(polygon(points), 0, 3, {circle({}, 0.17, 16, 'a')});
    return s;
}

Solid slot_plate() {
    std::vector<Path> slots;
    for (const double x : {-1.2, 0.0, 1.2})
        slots.push_back(Path(x + 0.25, -0.5)
                            .to(x + 0.25, 0.5, 'a')
                            .arc({x, 0.5}, 0.25, 0, 180, 6, 'a')
                            .to(x - 0.25, -0.5, 'a')
                            .arc({x, -0.5}, 0.25, 180, 330, 5, 'a')
                            .close('a'));
    Solid s;
    s.add_extruded(rounded_rectangle(2, 1.2, 0.3, 4, true), 0, 0.3, slots);
    return s;
}

/// A shaft with eight straight keys.
Solid spline_shaft() {
    Path p(polar({}, 1, -8));
    for (int k = 0; k < 8; ++k) {
        const double at = 45 * k;
        p.arc({}, 1, at - 8, at + 8, 2, 4 * k).to(polar({}, 0.8, at + 10), 4 * k + 1);
        p.arc({}, 0.8, at + 10, at + 35, 3, 4 * k + 2);
        if (k < 7) p.to(polar({}, 1, at + 37), 4 * k + 3);
    }
    Solid s;
    s.add_extruded(p.close(31), 0, 3);
    return s;
}

void add_holdout_parts(CreaseModels& to) {
    to.push_back(make_model("socket screw", socket_screw(), {.digits = 4}));
    to.push_back(make_model("flange with six holes", flange(), {.digits = 4}));
    to.push_back(make_model("pipe bend with a bore", pipe_bend(), {.digits = 5}));
    to.push_back(make_model("spring, flat ends", spring(), {.digits = 4}));
    to.push_back(make_model("phone with beveled faces", phone(), {.digits = 5}));
    to.push_back(make_model("wrench", wrench(), {.digits = 3}));
    to.push_back(make_model("heat sink", heat_sink(), {.digits = 3}));
    to.push_back(make_model("angle with a rib", gusset()));
    to.push_back(make_model("ratchet wheel", ratchet(), {.digits = 3}));
    to.push_back(make_model("slotted bar", slotted_bar(), {.bits = 14}));
    to.push_back(make_model("plate with three slots", slot_plate(), {.digits = 3}));
    to.push_back(make_model("spline shaft", spline_shaft(), {.digits = 4}));
}

}  // namespace

constinit const ModelFamily holdout_parts{.add = add_holdout_parts, .is_holdout = true};

}  // namespace rakelight
