// SPDX-License-Identifier: Apache-2.0
// Holdout: things of games.
#include <algorithm>
#include <cmath>

#include "math/functions.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

/// A frame and a sunken panel with slanted sides on each of six faces.
Solid crate() {
    const Loop outer = at_height({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 1),
               inner = at_height({{-0.8, -0.8}, {0.8, -0.8}, {0.8, 0.8}, {-0.8, 0.8}}, 1),
               deep = at_height({{-0.74, -0.74}, {0.74, -0.74}, {0.74, 0.74}, {-0.74, 0.74}}, 0.9);
    Solid face;
    face.add_band(outer, inner, face.new_surface());
    face.add_band(inner, deep,
                  std::vector<Surface>{face.new_surface(), face.new_surface(), face.new_surface(), face.new_surface()});
    face.add_flat(deep, {}, face.new_surface());
    Solid s;
    for (const double turn : {0.0, 90.0, 180.0, 270.0}) s.add(face, turned(turn, 0, 0));
    for (const double turn : {90.0, -90.0}) s.add(face, turned(0, turn, 0));
    return s;
}

/// A flat rhombus of a section that gets narrower; the ridges bend by 27 degrees.
Solid blade() {
    const auto section = [](double scale, double z) {
        return Loop{{0.25 * scale, 0, z}, {0, 0.06 * scale, z}, {-0.25 * scale, 0, z}, {0, -0.06 * scale, z}};
    };
    Solid s;
    const Loop low = section(1, 0), high = section(0.3, 3);
    s.add_band(low, high, std::vector<Surface>{s.new_surface(), s.new_surface(), s.new_surface(), s.new_surface()});
    s.add_flat(reversed(low), {}, s.new_surface());
    s.add_flat(high, {}, s.new_surface());
    return s;
}

/// A rounded body and a cabin that gets narrower upwards.
Solid toy_car() {
    Solid s;
    const Path body = rounded_rectangle(2, 0.9, 0.3, 4, true);
    s.add_walls(body, 0, 0.6);
    s.add_flat(reversed(at_height(body.points(), 0)), {}, s.new_surface());
    const Loop foot = at_height({{-1.3, -0.75}, {0.8, -0.75}, {0.8, 0.75}, {-1.3, 0.75}}, 0.6),
               roof = at_height({{-1, -0.6}, {0.3, -0.6}, {0.3, 0.6}, {-1, 0.6}}, 1.15);
    s.add_flat(at_height(body.points(), 0.6), {foot}, s.new_surface());
    s.add_band(foot, roof, std::vector<Surface>{s.new_surface(), s.new_surface(), s.new_surface(), s.new_surface()});
    s.add_flat(roof, {}, s.new_surface());
    return s;
}

Solid toy_brick() {
    Solid s;
    const Path box = rectangle(-1, -1, 1, 1);
    s.add_walls(box, 0, 1.2);
    s.add_flat(reversed(at_height(box.points(), 0)), {}, s.new_surface());
    std::vector<Loop> feet;
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) {
            const Path stud = circle({x, y}, 0.3, 12, 'a');
            feet.push_back(at_height(stud.points(), 1.2));
            s.add_walls(stud, 1.2, 1.4);
            s.add_flat(at_height(stud.points(), 1.4), {}, s.new_surface());
        }
    s.add_flat(at_height(box.points(), 1.2), feet, s.new_surface());
    return s;
}

/// Bottom and sides meet in a hard chine, lengthwise they are smooth.
Solid hull() {
    std::vector<Loop> sections;
    for (int i = 0; i <= 8; ++i) {
        const double t = i / 8.0, b = 1 - 0.85 * t * t, rise = 0.5 * t * t;
        sections.push_back({{0, 6 * t, -0.5 + rise},
                            {0.75 * b, 6 * t, -0.3 + rise},
                            {b, 6 * t, 0.4 + 0.3 * t},
                            {-b, 6 * t, 0.4 + 0.3 * t},
                            {-0.75 * b, 6 * t, -0.3 + rise}});
    }
    Solid s;
    const int labels[] = {0, 1, 2, 3, 4};
    s.add_loft(sections, labels);
    s.add_flat(reversed(sections.front()), {}, s.new_surface());
    s.add_flat(sections.back(), {}, s.new_surface());
    s.flip();
    return s;
}

/// A square turned by 90 degrees on its way up.
Solid twisted_column() {
    std::vector<dvec2> points;
    std::vector<int> labels;
    const dvec2 corners[] = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 3; ++i) {
            const dvec2 a = corners[k], b = corners[(k + 1) % 4];
            points.push_back({a.x + (b.x - a.x) * i / 3, a.y + (b.y - a.y) * i / 3}), labels.push_back(k);
        }
    std::vector<Loop> sections;
    for (int i = 0; i <= 18; ++i) {
        Loop loop;
        for (const dvec3& p : at_height(points, 0.4 * i)) loop.push_back(turned(0, 0, 5 * i)(p));
        sections.push_back(loop);
    }
    Solid s;
    s.add_loft(sections, labels);
    s.add_flat(reversed(sections.front()), {}, s.new_surface());
    s.add_flat(sections.back(), {}, s.new_surface());
    return s;
}

Solid arrow_sign() {
    Solid s;
    s.add_extruded(polygon({{0, -0.3}, {2, -0.3}, {2, -0.8}, {3, 0}, {2, 0.8}, {2, 0.3}, {0, 0.3}, {0.3, 0}}), 0, 0.2);
    s.turn(20, 35, 10);
    return s;
}

/// A disk with a bore and five windows with round corners.
Solid spoked_wheel() {
    std::vector<Path> holes = {circle({}, 0.25, 16, 'a')};
    const Path window = rounded_rectangle(0.25, 0.22, 0.1, 3, true);
    for (int k = 0; k < 5; ++k) {
        const auto place = [&](dvec2 p) {
            const dvec3 q = turned(0, 0, 72 * k)({p.x + 0.9, p.y, 0});
            return dvec2{q.x, q.y};
        };
        Path hole(place(window.points().front()));
        for (std::size_t i = 1; i < window.points().size(); ++i) hole.to(place(window.points()[i]), 'w');
        holes.push_back(hole.close('w'));
    }
    Solid s;
    s.add_extruded(circle({}, 1.4, 40, 'r'), 0, 0.3, holes);
    return s;
}

/// All edges and corners are rounded: nothing is hard.
Solid soft_box() {
    std::vector<Loop> sections;
    const double r = 0.3;
    for (int i = 0; i < 8; ++i) {
        const double a = radians(i < 4 ? -90 + 30 * i : 30 * (i - 4)), radius = r * math::cos(a);
        const bool is_end = i == 0 || i == 7;
        sections.push_back(
            at_height(rounded_rectangle(0.7 + radius, 0.9 + radius, is_end ? 1e-9 : radius, 3, true).points(),
                      (i < 4 ? r : 0.9) + r * math::sin(a)));
    }
    Solid s;
    const Surface skin = s.new_surface();
    for (int i = 0; i < 7; ++i) s.add_band(sections[std::size_t(i)], sections[std::size_t(i) + 1], skin);
    for (const bool is_top : {false, true}) {
        Loop flat = at_height(rectangle(-0.7, -0.9, 0.7, 0.9).points(), is_top ? 1.2 : 0);
        s.add(is_top ? flat : reversed(flat), skin);
    }
    return s;
}

/// A wing that is swept and tapered, with a sharp trailing edge and a flat tip.
Solid wing() {
    std::vector<dvec2> points;
    for (int i = 0; i < 40; ++i) {  // from the tail over the upper side
        const double turn = 2 * pi * i / 40, x = 0.5 + 0.5 * math::cos(turn);
        const double y =
            0.6 * (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
        points.push_back({x, i < 20 ? y : -y});
    }
    std::vector<Loop> sections;
    for (int k = 0; k <= 3; ++k) {
        Loop loop;
        const double scale = 1 - 0.2 * k;
        for (const dvec2& p : points) loop.push_back({scale * p.x + 0.3 * k, scale * p.y, 1.0 * k});
        sections.push_back(loop);
    }
    Solid s;
    s.add_loft(sections, std::vector<int>(40, 'a'));
    for (int k = 0; k < 3; ++k) s.crease(sections[std::size_t(k)][0], sections[std::size_t(k) + 1][0]);
    s.add_flat(reversed(sections.front()), {}, s.new_surface());
    s.add_flat(sections.back(), {}, s.new_surface());
    return s;
}

void add_holdout_objects(CreaseModels& to) {
    to.push_back(make_model("crate with sunken panels", crate(), {.digits = 4}));
    to.push_back(make_model("blade", blade(), {.digits = 4}));
    to.push_back(make_model("toy car", toy_car(), {.digits = 4}));
    to.push_back(make_model("toy brick with studs", toy_brick(), {.digits = 3}));
    to.push_back(make_model("hull with hard chines", hull(), {.digits = 4}));
    to.push_back(make_model("twisted column", twisted_column(), {.digits = 4}));
    to.push_back(make_model("arrow sign, turned", arrow_sign(), {.digits = 3}));
    to.push_back(make_model("wheel with windows", spoked_wheel(), {.digits = 4}));
    to.push_back(make_model("box with round edges and corners", soft_box(), {.digits = 4}));
    to.push_back(make_model("wing", wing(), {.digits = 4}));
}

}  // namespace

constinit const ModelFamily holdout_objects{.add = add_holdout_objects, .is_holdout = true};

}  // namespace rakelight
