// SPDX-License-Identifier: Apache-2.0
// Holdout: buildings and the pieces of a chess board.
#include <algorithm>

#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

/// Walls, eaves and a roof of 37 degrees.
Solid house() {
    Solid s;
    s.add_extruded(polygon({{-1, 0}, {1, 0}, {1, 1}, {1.2, 1}, {1.2, 1.1}, {0, 2}, {-1.2, 1.1}, {-1.2, 1}, {-1, 1}}), 0,
                   3);
    s.turn(90, 0, 0);
    return s;
}

/// A roof of four sides of 30 degrees over a wide house.
Solid hipped_roof() {
    Solid s;
    const Path walls = rectangle(-2, -1, 2, 1);
    s.add_walls(walls, 0, 1);
    Loop bottom = at_height(walls.points(), 0);
    std::ranges::reverse(bottom);
    s.add_flat(bottom, {}, s.new_surface());
    const Loop eaves = at_height(rectangle(-2.2, -1.2, 2.2, 1.2).points(), 1);
    Loop hole = at_height(walls.points(), 1), below = eaves;
    std::ranges::reverse(hole), std::ranges::reverse(below);
    s.add_flat(below, {hole}, s.new_surface());
    const dvec3 left{-1, 0, 1.7}, right{1, 0, 1.7};
    s.add({eaves[0], eaves[1], right, left}, s.new_surface());
    s.add({eaves[1], eaves[2], right}, s.new_surface());
    s.add({eaves[2], eaves[3], left, right}, s.new_surface());
    s.add({eaves[3], eaves[0], left}, s.new_surface());
    return s;
}

/// A round tower with six merlons.
Solid rook() {
    constexpr int sides = 24;
    Solid s;
    s.add_revolved(Path(0, 0).to(1, 0, 'a').to(1, 0.3, 'b').to(0.7, 0.4, 'c').to(0.6, 1.4, 'd').to(0.85, 1.6, 'e'),
                   sides);
    const Surface wall = s.new_surface(), floor = s.new_surface();
    const auto quad = [&](double r0, double r1, int i, int j, double z0, double z1, Surface surface) {
        const double a = double(i) / sides, b = double(j) / sides;
        s.add({around(r0, a, z0), around(r1, b, z0), around(r1, b, z1), around(r0, a, z1)}, surface);
    };
    Loop inside;
    for (int k = 0; k < 6; ++k) {
        const Surface inner = s.new_surface(), top = s.new_surface(), ends[] = {s.new_surface(), s.new_surface()};
        for (int i = 4 * k; i < 4 * k + 4; ++i) {
            quad(0.85, 0.85, i, i + 1, 1.6, 1.9, wall);
            const double a = double(i) / sides, b = double(i + 1) / sides;
            if (i >= 4 * k + 2) {
                inside.push_back(around(0.85, a, 1.9));
                continue;
            }
            quad(0.85, 0.85, i, i + 1, 1.9, 2.2, wall);
            quad(0.55, 0.55, i + 1, i, 1.9, 2.2, inner);
            s.add({around(0.55, a, 2.2), around(0.85, a, 2.2), around(0.85, b, 2.2), around(0.55, b, 2.2)}, top);
            if (i == 4 * k) inside.push_back(around(0.85, a, 1.9));
            inside.push_back(around(0.55, a, 1.9));
        }
        inside.insert(inside.end() - 2, around(0.55, (4 * k + 2.0) / sides, 1.9));
        quad(0.55, 0.85, 4 * k, 4 * k, 1.9, 2.2, ends[0]);
        quad(0.85, 0.55, 4 * k + 2, 4 * k + 2, 1.9, 2.2, ends[1]);
    }
    s.add_flat(inside, {}, floor);
    return s;
}

/// A wall with four merlons and a gate with a round arch.
Solid gate() {
    Path p(-3, 0);
    p.to(-1, 0, 0).to(-1, 1.2, 1).arc({0, 1.2}, 1, 180, 0, 8, 1).to(1, 0, 1).to(3, 0, 2).to(3, 4, 3);
    for (int k = 0; k < 4; ++k) {
        const double x = 3 - 1.6 * k;
        p.to(x - 1.2, 4, 10 + 4 * k);
        if (k < 3) p.to(x - 1.2, 3.4, 11 + 4 * k).to(x - 1.6, 3.4, 12 + 4 * k).to(x - 1.6, 4, 13 + 4 * k);
    }
    Solid s;
    s.add_extruded(p.close(99), 0, 0.8);
    return s;
}

/// A slab with an arched top.
Solid tombstone() {
    Solid s;
    s.add_extruded(Path(-0.5, 0).to(0.5, 0, 'a').to(0.5, 1, 'b').arc({0, 1}, 0.5, 0, 180, 10, 'b').close('b'), 0, 0.2);
    s.turn(90, 0, 25);
    return s;
}

/// A ramp of 14 degrees with a walkway on top and a curb.
Solid ramp() {
    Solid s;
    s.add_extruded(polygon({{0, 0}, {8, 0}, {8, 1.15}, {7.9, 1.15}, {7.9, 1}, {4, 1}, {0, 0.01}}), 0, 2);
    return s;
}

/// A pawn: feet with hard rims, a waist and a ball.
Solid pawn() {
    Path p(0, 0);
    p.to(1, 0, 'a').to(1, 0.25, 'b').to(0.85, 0.35, 'c').to(0.85, 0.45, 'd').to(0.5, 0.6, 'e');
    for (int i = 1; i <= 4; ++i) p.to(0.5 - 0.05 * i * (2 - i / 4.0), 0.6 + 0.25 * i, 'f');
    p.to(0.5, 1.65, 'g').to(0.5, 1.72, 'h').to(polar({0, 2.05}, 0.4, -45), 'i').arc({0, 2.05}, 0.4, -45, 75, 6, 'j');
    Solid s;
    s.add_revolved(p.to(0, 2.45, 'j'), 20);
    return s;
}

void add_holdout_buildings(CreaseModels& to) {
    to.push_back(make_model("house with eaves", house(), {.digits = 3}));
    to.push_back(make_model("house with a hipped roof", hipped_roof(), {.digits = 4}));
    to.push_back(make_model("rook", rook(), {.digits = 4}));
    to.push_back(make_model("gate with merlons", gate(), {.digits = 3}));
    to.push_back(make_model("tombstone, turned", tombstone(), {.bits = 12}));
    to.push_back(make_model("ramp of 14 degrees", ramp(), {.digits = 3}));
    to.push_back(make_model("pawn", pawn(), {.digits = 4}));
}

}  // namespace

constinit const ModelFamily holdout_buildings{.add = add_holdout_buildings, .is_holdout = true};

}  // namespace rakelight
