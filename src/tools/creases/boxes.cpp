// SPDX-License-Identifier: Apache-2.0
// Chamfered, tapered, twisted and stacked boxes; cut stones.
#include <algorithm>

#include "math/functions.h"
#include "math/linear.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

Loop rectangle_at(double half_x, double half_y, double z) {
    return at_height(rectangle(-half_x, -half_y, half_x, half_y).points(), z);
}
/// Bands between loops, each of whose squares is a surface of its own, with flat ends.
Solid stacked(const std::vector<Loop>& sections) {
    Solid s;
    for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
        std::vector<Surface> sides;
        for (std::size_t k = 0; k < sections[i].size(); ++k) sides.push_back(s.new_surface());
        s.add_band(sections[i], sections[i + 1], sides);
    }
    s.add_flat(reversed(sections.front()), {}, s.new_surface());
    s.add_flat(sections.back(), {}, s.new_surface());
    return s;
}

/// Six sides, twelve chamfers, eight corners.
Solid chamfered_box(double c) {
    Solid s;
    const auto at = [&](int axis, int side, int p, int q) {
        double v[3];
        v[axis] = side, v[(axis + 1) % 3] = p * (1 - c), v[(axis + 2) % 3] = q * (1 - c);
        return dvec3{v[0], v[1], v[2]};
    };
    const auto add = [&](Loop loop) {
        if (dot(cross(loop[1] - loop[0], loop[2] - loop[0]), loop[0] + loop[1] + loop[2]) < 0)
            std::ranges::reverse(loop);
        s.add(loop, s.new_surface());
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int i : {-1, 1}) {
            add({at(axis, i, -1, -1), at(axis, i, 1, -1), at(axis, i, 1, 1), at(axis, i, -1, 1)});
            for (const int j : {-1, 1}) {  // between `axis` on side i and the next axis on side j
                const int next = (axis + 1) % 3;
                add({at(axis, i, j, -1), at(axis, i, j, 1), at(next, j, 1, i), at(next, j, -1, i)});
            }
        }
    for (const int x : {-1, 1})
        for (const int y : {-1, 1})
            for (const int z : {-1, 1}) add({at(0, x, y, z), at(1, y, z, x), at(2, z, x, y)});
    return s;
}

/// Only the upper rim is chamfered. @param deg  between chamfer and top
Solid top_chamfer(double width, double deg) {
    const double in = width * math::cos(radians(deg)), down = width * math::sin(radians(deg));
    return stacked({rectangle_at(1, 0.7, 0), rectangle_at(1, 0.7, 1 - down), rectangle_at(1 - in, 0.7 - in, 1)});
}

/// The upper end is turned, so that no side is flat.
Solid twisted_box(double deg) {
    Loop top = rectangle_at(1, 1, 2);
    for (dvec3& p : top) p = turned(0, 0, deg)(p);
    return stacked({rectangle_at(1, 1, 0), top});
}

/// A small box on a large one.
Solid pedestal() {
    Solid s;
    s.add_band(rectangle_at(1, 1, 0), rectangle_at(1, 1, 0.5), s.new_surfaces(std::vector<int>{0, 1, 2, 3}));
    s.add_flat(reversed(rectangle_at(1, 1, 0)), {}, s.new_surface());
    s.add_flat(rectangle_at(1, 1, 0.5), {rectangle_at(0.6, 0.5, 0.5)}, s.new_surface());
    s.add_band(rectangle_at(0.6, 0.5, 0.5), rectangle_at(0.6, 0.5, 1.3), s.new_surfaces(std::vector<int>{0, 1, 2, 3}));
    s.add_flat(rectangle_at(0.6, 0.5, 1.3), {}, s.new_surface());
    return s;
}

/// Half a ball on a cube.
Solid dome_on_cube() {
    Solid s;
    s.add_band(rectangle_at(1, 1, 0), rectangle_at(1, 1, 1), s.new_surfaces(std::vector<int>{0, 1, 2, 3}));
    s.add_flat(reversed(rectangle_at(1, 1, 0)), {}, s.new_surface());
    s.add_flat(rectangle_at(1, 1, 1), {ring(0.8, 1, 20)}, s.new_surface());
    Path p(0.8, 1);
    p.arc({0, 1}, 0.8, 0, 72, 4, 'a');
    s.add_revolved(p.to(0, 1.8, 'a'), 20);
    return s;
}

/// A cut stone with a rectangular outline and cut corners.
Solid step_cut() {
    const auto outline = [](double x, double y, double cut, double z) {
        return at_height({{x, -y + cut},
                          {x, y - cut},
                          {x - cut, y},
                          {-x + cut, y},
                          {-x, y - cut},
                          {-x, -y + cut},
                          {-x + cut, -y},
                          {x - cut, -y}},
                         z);
    };
    return stacked({outline(0.25, 0.12, 0.06, -0.7), outline(0.8, 0.55, 0.2, -0.25), outline(1, 0.7, 0.25, 0),
                    outline(1, 0.7, 0.25, 0.06), outline(0.85, 0.57, 0.21, 0.22), outline(0.6, 0.4, 0.15, 0.34)});
}

Solid pyramid(double height) {
    Solid s;
    const Loop base = rectangle_at(1, 1, 0);
    s.add_flat(reversed(base), {}, s.new_surface());
    for (std::size_t i = 0; i < 4; ++i) s.add({base[i], base[(i + 1) % 4], {0, 0, height}}, s.new_surface());
    return s;
}

/// A tapered box with a groove along its top.
Solid grooved_box() {
    Solid s;
    s.add_extruded(polygon({{-1.2, 0}, {1.2, 0}, {1, 1}, {0.3, 1}, {0.15, 0.7}, {-0.15, 0.7}, {-0.3, 1}, {-1, 1}}), 0,
                   2);
    s.turn(12, 40, -25);
    return s;
}

void add_boxes(CreaseModels& to) {
    for (const int percent : {5, 15, 30})
        to.push_back(make_model("chamfered box, " + std::to_string(percent) + " %", chamfered_box(percent / 100.0)));
    Solid box = chamfered_box(0.15);
    box.turn(20, 40, 60);
    to.push_back(make_model("chamfered box, turned, 4 decimals", box, {.digits = 4}));
    to.push_back(make_model("chamfered box, turned, 12 bits", box, {.bits = 12}));
    for (const int deg : {30, 45, 60})
        to.push_back(
            make_model("box, chamfer of " + std::to_string(deg) + " degrees", top_chamfer(0.15, deg), {.digits = 4}));
    to.push_back(make_model("box, wide chamfer of 15 degrees", top_chamfer(0.5, 15), {.digits = 4}));
    to.push_back(
        make_model("tapered box", stacked({rectangle_at(1, 0.8, 0), rectangle_at(0.7, 0.5, 1.5)}), {.digits = 4}));
    to.push_back(make_model("box twisted by 3 degrees", twisted_box(3), {.digits = 4}));
    to.push_back(make_model("box on a box", pedestal(), {.digits = 3}));
    to.push_back(make_model("dome on a cube", dome_on_cube(), {.digits = 4}));
    to.push_back(make_model("stone of step cut", step_cut(), {.digits = 3}));
    to.push_back(make_model("pyramid", pyramid(0.9)));
    to.push_back(make_model("grooved box, turned", grooved_box(), {.digits = 4}));
}

}  // namespace

constinit const ModelFamily box_models{.add = add_boxes};

}  // namespace rakelight
