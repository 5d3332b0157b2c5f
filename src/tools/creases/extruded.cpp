// SPDX-License-Identifier: Apache-2.0
// Fillets, gears, beams, roofs: outlines drawn along an axis.
#include "math/functions.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

Solid extruded(const Path& outline, double height, const std::vector<Path>& holes = {}) {
    Solid s;
    s.add_extruded(outline, 0, height, holes);
    return s;
}

Solid gear(int teeth) {
    Path p(polar({}, 0.8, -9));
    for (int k = 0; k < teeth; ++k) {
        const double at = 360.0 * k / teeth;
        p.to(polar({}, 1, at - 4.5), 4 * k).to(polar({}, 1, at + 4.5), 4 * k + 1).to(polar({}, 0.8, at + 9), 4 * k + 2);
        if (k + 1 < teeth) p.to(polar({}, 0.8, at + 360.0 / teeth - 9), 4 * k + 3);
    }
    return extruded(p.close(4 * teeth), 0.4, {circle({}, 0.4, 20, 'h')});
}

/// Corners are arcs that meet the sides at an angle, so their borders are hard.
Solid hard_fillet_box() {
    Path p(1, -0.6);
    const dvec2 centers[] = {{0.6, 0.6}, {-0.6, 0.6}, {-0.6, -0.6}, {0.6, -0.6}};
    for (int k = 0; k < 4; ++k) {
        const double at = 90 * k;
        p.to(polar(centers[k], 0.4, at), 2 * k);
        const dvec2 hollow = polar(centers[k], 0.5657, at + 45);  // the corner, around which it is hollow
        p.arc(hollow, 0.4, at + 270, at + 180, k == 3 ? 3 : 4, 2 * k + 1);
    }
    return extruded(p.close(7), 1.5);
}

/// The strips of its corners are 12, 30, 18, 30 degrees wide.
Solid uneven_fillet_box() {
    Path p(1, -0.6);
    const dvec2 centers[] = {{0.6, 0.6}, {-0.6, 0.6}, {-0.6, -0.6}, {0.6, -0.6}};
    for (int k = 0; k < 4; ++k)
        for (const double turn : {0, 12, 42, 60, 90})
            if (k < 3 || turn < 90) p.to(polar(centers[k], 0.4, 90 * k + turn), 'a');
    return extruded(p.close('a'), 1.5);
}

Solid bracket(int strips) {
    Path p(0, 0);
    p.to(2, 0, 'a').to(2, 0.3, 'b').to(0.5, 0.3, 'c').arc({0.5, 0.5}, 0.2, 270, 180, strips, 'c');
    return extruded(p.to(0.3, 2, 'c').to(0, 2, 'd').close('e'), 1);
}

Solid beam() {
    return extruded(polygon({{-1, -1},
                             {1, -1},
                             {1, -0.8},
                             {0.1, -0.7},
                             {0.1, 0.7},
                             {1, 0.8},
                             {1, 1},
                             {-1, 1},
                             {-1, 0.8},
                             {-0.1, 0.7},
                             {-0.1, -0.7},
                             {-1, -0.8}}),
                    5);
}

Solid stairs() {
    Path p(0, 0);
    p.to(4, 0, 0);
    for (int k = 0; k < 4; ++k) p.to(4 - k, 0.6 * (k + 1), 2 * k + 1).to(3 - k, 0.6 * (k + 1), 2 * k + 2);
    return extruded(p.close(99), 2);
}

/// Two planes that bend by `deg` on top.
Solid roof(double deg) {
    const double rise = math::tan(radians(deg / 2));
    return extruded(polygon({{-1, 0}, {1, 0}, {1, 0.5}, {0, 0.5 + rise}, {-1, 0.5}}), 3);
}

/// A flat and a slope of `deg`.
Solid wedge(double deg) {
    return extruded(polygon({{0, 0}, {4, 0}, {4, 0.4 + 2 * math::tan(radians(deg))}, {2, 0.4}, {0, 0.4}}), 2);
}

Solid arch() {
    Path p(-1.5, 0);
    p.to(-1, 0, 'a').arc({}, 1, 180, 0, 12, 'b').to(1.5, 0, 'c').arc({}, 1.5, 0, 180, 12, 'd');
    Path closed(p.points().front());
    for (std::size_t i = 1; i + 1 < p.points().size(); ++i) closed.to(p.points()[i], p.labels()[i - 1]);
    return extruded(closed.close('d'), 0.8);
}

Path keyhole() {
    return Path(0.15, -0.8)
        .to(polar({}, 0.35, -64.6), 'a')
        .arc({}, 0.35, -64.6, 244.6, 14, 'b')
        .to(-0.15, -0.8, 'c')
        .close('d');
}

/// A round shaft with a flat side.
Solid d_shaft() { return extruded(Path(polar({}, 1, 40)).arc({}, 1, 40, 320, 20, 'a').close('b'), 3); }

Solid heart() {
    Path p(0, -1.2);  // its straight sides touch the circles
    p.to(polar({0.5, 0}, 0.6, -50.11), 'a').arc({0.5, 0}, 0.6, -50.11, 146.4427, 8, 'a');
    p.arc({-0.5, 0}, 0.6, 33.5573, 230.11, 8, 'b');
    return extruded(p.close('b'), 0.5);
}

void add_fillets(CreaseModels& to) {
    for (const int strips : {2, 3, 4, 8})
        to.push_back(make_model("box, fillets of " + std::to_string(strips) + " strips",
                                extruded(rounded_rectangle(1, 1, 0.2, strips, true), 1.5), {.digits = 4}));
    to.push_back(make_model("box, wide fillets of 5 strips", extruded(rounded_rectangle(1, 1, 0.6, 5, true), 1.5),
                            {.digits = 4}));
    to.push_back(make_model("box, hollow corners with hard borders", hard_fillet_box(), {.digits = 4}));
    to.push_back(make_model("box, fillets of uneven strips", uneven_fillet_box(), {.digits = 4}));
    to.push_back(make_model("stadium", extruded(rounded_rectangle(2, 0.7, 0.7, 6, true), 0.5), {.digits = 3}));
    for (const int strips : {3, 6})
        to.push_back(
            make_model("bracket, fillet of " + std::to_string(strips) + " strips", bracket(strips), {.digits = 4}));
}

void add_extruded(CreaseModels& to) {
    add_fillets(to);
    to.push_back(make_model("gear of 12 teeth", gear(12)));
    to.push_back(make_model("gear of 12 teeth, 2 decimals", gear(12), {.digits = 2}));
    to.push_back(make_model("beam with sloped flanges", beam(), {.digits = 4}));
    to.push_back(make_model("stairs", stairs(), {.digits = 3}));
    to.push_back(make_model("roof of 25 degrees", roof(25), {.digits = 4}));
    to.push_back(make_model("roof of 15 degrees", roof(15), {.digits = 4}));
    to.push_back(make_model("wedge of 20 degrees", wedge(20), {.digits = 4}));
    to.push_back(make_model("wedge of 10 degrees", wedge(10), {.digits = 4}));
    to.push_back(make_model(
        "rail with slopes of 34 degrees",
        extruded(polygon({{0, 0}, {3, 0}, {3, 0.4}, {2.7, 0.6}, {2.7, 1}, {0.3, 1}, {0.3, 0.6}, {0, 0.4}}), 5),
        {.digits = 4}));
    to.push_back(make_model(
        "octagonal bar of uneven sides",
        extruded(polygon({{1, -0.8}, {1, 0.8}, {0.8, 1}, {-0.8, 1}, {-1, 0.8}, {-1, -0.8}, {-0.8, -1}, {0.8, -1}}), 2),
        {.digits = 4}));
    to.push_back(make_model("keystone", extruded(polygon({{0, 0}, {2, 0}, {1.8, 1}, {0.2, 1}}), 1), {.digits = 4}));
    to.push_back(make_model("arch", arch(), {.digits = 4}));
    to.push_back(
        make_model("plate with a keyhole", extruded(rectangle(-1, -1.4, 1, 1), 0.3, {keyhole()}), {.digits = 4}));
    to.push_back(make_model("round shaft with a flat", d_shaft(), {.digits = 4}));
    to.push_back(make_model("heart", heart(), {.digits = 4}));
}

}  // namespace

constinit const ModelFamily extruded_models{.add = add_extruded};

}  // namespace rakelight
