// SPDX-License-Identifier: Apache-2.0
// Bolts, threads, countersunk holes, rims, plates with holes.
#include <algorithm>
#include <cmath>

#include "math/functions.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

/// A hexagonal head, a round shank with a chamfer at its end.
Solid bolt(int sides) {
    Solid s;
    const Path head = regular(6, 1);
    s.add_walls(head, 0, 0.6);
    s.add_flat(reversed(at_height(head.points(), 0)), {}, s.new_surface());
    s.add_flat(at_height(head.points(), 0.6), {ring(0.5, 0.6, sides)}, s.new_surface());
    s.add_revolved(Path(0.5, 0.6).to(0.5, 2.9, 'a').to(0.4, 3, 'b').to(0, 3, 'c'), sides);
    return s;
}

/// A thread of trapezoids with flat ends across it.
Solid screw_thread(int sides, double turns, double pitch) {
    struct Break {
        double at, radius;
    };
    const Break breaks[] = {{0, 0.85}, {0.15, 0.85}, {0.45, 1}, {0.6, 1}};
    Solid s;
    const std::vector<Surface> surfaces = s.new_surfaces(std::vector<int>{0, 1, 2, 3});
    const auto point = [&](int row, int part, int column) {
        const Break b = breaks[std::size_t(part % 4)];
        const double z = (row + part / 4 + b.at + double(column) / sides) * pitch;
        return around(b.radius, double(column % sides) / sides, z);
    };
    for (int row = -2; row <= int(turns) + 1; ++row)
        for (int part = 0; part < 4; ++part)
            for (int i = 0; i < sides; ++i)
                s.add({point(row, part, i), point(row, part, i + 1), point(row, part + 1, i + 1),
                       point(row, part + 1, i)},
                      surfaces[std::size_t(part)]);
    s.cut({0, 0, 0}, {0, 0, -1});
    s.cut({0, 0, turns * pitch}, {0, 0, 1});
    return s;
}

/// The chamfer of the hole meets the upper side at 45 degrees, as the sides of a hole of eight meet each other.
Solid countersunk_plate(int sides, double chamfer) {
    Solid s;
    const Path plate = rectangle(-1.4, -1.4, 1.4, 1.4);
    const double turn = 0.5 / sides;
    const Loop top = ring(0.6 + chamfer, 0.5, sides, turn), middle = ring(0.6, 0.5 - chamfer, sides, turn),
               bottom = ring(0.6, 0, sides, turn);
    s.add_walls(plate, 0, 0.5);
    s.add_flat(at_height(plate.points(), 0.5), {top}, s.new_surface());
    s.add_flat(reversed(at_height(plate.points(), 0)), {reversed(bottom)}, s.new_surface());
    s.add_band(top, middle, s.new_surface());
    s.add_band(middle, bottom, s.new_surface());
    return s;
}

/// A flat round head with a slot across it.
Solid slotted_head() {
    constexpr double corner = 9, slot = 0.5, top = 0.8;
    Solid s;
    std::vector<double> degs;  // the ends of the slot and steps between them
    for (const double start : {corner, 180 + corner})
        for (int i = 0; i <= 9; ++i) degs.push_back(start + (180 - 2 * corner) * i / 9);
    const auto at = [&](std::size_t i, double z) { return around(1, degs[i % degs.size()] / 360, z); };
    const Surface wall = s.new_surface(), above = s.new_surface();
    Loop bottom;
    for (std::size_t i = 0; i < degs.size(); ++i) {
        bottom.push_back(at(i, 0));
        s.add({at(i, 0), at(i + 1, 0), at(i + 1, slot), at(i, slot)}, wall);
        if (i % 10 != 9) s.add({at(i, slot), at(i + 1, slot), at(i + 1, top), at(i, top)}, wall);
    }
    s.add_flat(reversed(bottom), {}, s.new_surface());
    s.add({at(0, slot), at(9, slot), at(10, slot), at(19, slot)}, s.new_surface());
    for (const std::size_t half : {0u, 10u}) {
        Loop upper;
        for (std::size_t i = half; i < half + 10; ++i) upper.push_back(at(i, top));
        s.add_flat(upper, {}, above);
        s.add({at(half + 9, slot), at(half, slot), at(half, top), at(half + 9, top)}, s.new_surface());
    }
    return s;
}

/// A roller with straight ridges of 90 degrees.
Solid knurled_knob() {
    std::vector<dvec2> points;
    for (int i = 0; i < 60; ++i) points.push_back(polar({}, i % 2 == 0 ? 1 : 0.93, 6 * i));
    Solid s;
    s.add_extruded(polygon(points), 0, 0.8);
    return s;
}

/// The rim of a wheel: hard flanges, a bed that is round from one to the other.
Solid rim() {
    Path p(0.8, 0);
    p.to(1.2, 0, 'a').to(1.2, 0.08, 'b').to(1.1, 0.12, 'c');
    for (int i = 1; i <= 6; ++i) p.to(1.1 - 0.15 * math::sin(pi * i / 6), 0.12 + 0.76 * i / 6, 'd');
    Solid s;
    s.add_revolved(p.to(1.2, 0.92, 'e').to(1.2, 1, 'f').to(0.8, 1, 'g').close('h'), 36);
    return s;
}

Solid honeycomb() {
    std::vector<Path> holes = {regular(6, 0.3)};
    for (int k = 0; k < 6; ++k) holes.push_back(regular(6, 0.3, 0, polar({}, 0.66, 60 * k + 30)));
    Solid s;
    s.add_extruded(regular(6, 1.25, 30), 0, 0.4, holes);
    return s;
}

/// A disk whose radius grows over half a turn and falls back softly: no edge of its rim is hard.
Solid cam() {
    Path p(1, 0);
    for (int i = 1; i < 36; ++i) p.to(polar({}, 1 + 0.15 * (1 - math::cos(radians(10 * i))), 10 * i), 'r');
    Solid s;
    s.add_extruded(p.close('r'), 0, 0.4, {circle({}, 0.3, 16, 'h')});
    return s;
}

/// A quarter of a bent pipe with flat ends.
Solid elbow(int along, int sides) {
    std::vector<Loop> sections;
    for (int i = 0; i <= along; ++i) {
        Loop loop;
        for (const dvec3& p : ring(0.5, 0, sides)) loop.push_back(around(2 - p.x, 0.25 * i / along, p.y));
        sections.push_back(loop);
    }
    Solid s;
    s.add_loft(sections, std::vector<int>(std::size_t(sides), 'a'));
    s.add_flat(reversed(sections.front()), {}, s.new_surface());
    s.add_flat(sections.back(), {}, s.new_surface());
    return s;
}

void add_machine_parts(CreaseModels& to) {
    to.push_back(make_model("hex bolt, shank of 12 sides", bolt(12)));
    to.push_back(make_model("hex bolt, shank of 24 sides, 2 decimals", bolt(24), {.digits = 2}));
    to.push_back(make_model("thread with flat ends", screw_thread(24, 4, 0.35), {.digits = 4}));
    to.push_back(make_model("thread with flat ends, 14 bits", screw_thread(32, 3, 0.3), {.bits = 14}));
    for (const int sides : {8, 16, 32})
        to.push_back(make_model("countersunk hole of " + std::to_string(sides) + " sides",
                                countersunk_plate(sides, sides == 32 ? 0.1 : 0.15), {.digits = 4}));
    to.push_back(make_model("slotted screw head", slotted_head(), {.digits = 4}));
    to.push_back(make_model("knurled knob", knurled_knob(), {.digits = 3}));
    to.push_back(make_model("rim of a wheel", rim(), {.digits = 4}));
    to.push_back(make_model("honeycomb plate", honeycomb(), {.digits = 3}));
    to.push_back(make_model("cam", cam(), {.digits = 4}));
    to.push_back(make_model("pipe elbow of 6 x 12", elbow(6, 12), {.digits = 5}));
    to.push_back(make_model("pipe elbow of 3 x 8", elbow(3, 8), {.digits = 5}));
    to.push_back(make_model("pipe elbow of 6 x 12, other diagonals", elbow(6, 12),
                            {.digits = 4, .diagonals = Diagonals::second}));
}

}  // namespace

constinit const ModelFamily machine_part_models{.add = add_machine_parts};

}  // namespace rakelight
