// SPDX-License-Identifier: Apache-2.0
// What homogeneous clipping is for: the picture that a division without it would make, beside the right one.
#include <algorithm>
#include <cmath>

#include "tools/stages/plot.h"

namespace rakelight::stages {
namespace {

/// x, y and w before the division.
struct Corner {
    double x, y, w;
};
struct Triangle {
    Corner corner[3];
    Code color;
};

constexpr Code mirrored{200, 110, 230}, area{60, 80, 115};
constexpr std::uint64_t filled_triangles = 256;  ///< more are shown by their outlines
constexpr int example_width = 640, example_height = 360;

/// To pixels, for any sign of w.
dvec2 divided(const Corner& c, const Canvas& canvas) {
    return {(c.x / c.w * 0.5 + 0.5) * canvas.width(), (0.5 - c.y / c.w * 0.5) * canvas.height()};
}

int corners_behind(const Triangle& t) {
    return int(std::count_if(std::begin(t.corner), std::end(t.corner), [](const Corner& c) { return c.w <= 0; }));
}

/// The part with w >= near (Sutherland & Hodgman 1974): at most 4 corners.
std::vector<Corner> clipped(const Triangle& t, double near) {
    std::vector<Corner> out;
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner &a = t.corner[i], &b = t.corner[(i + 1) % 3];
        if (a.w >= near) out.push_back(a);
        if ((a.w >= near) == (b.w >= near)) continue;
        const double s = (near - a.w) / (b.w - a.w);
        out.push_back({a.x + (b.x - a.x) * s, a.y + (b.y - a.y) * s, near});
    }
    return out;
}

void draw(Canvas& canvas, const std::vector<dvec2>& p, Code color, bool is_filled) {
    for (std::size_t k = 2; is_filled && k < p.size(); ++k) canvas.fill(p[0], p[k - 1], p[k], color);
    for (std::size_t k = 0; !is_filled && k < p.size(); ++k) canvas.line(p[k], p[(k + 1) % p.size()], color);
}

void draw_divided(Canvas& canvas, const Triangle& t, bool is_filled) {
    const int behind = corners_behind(t);
    std::vector<dvec2> p;
    for (const Corner& c : t.corner) p.push_back(divided(c, canvas));
    const auto tinted = [&](Code tint) {
        return is_filled ? Code{std::uint8_t((t.color.r + tint.r) / 2), std::uint8_t((t.color.g + tint.g) / 2),
                                std::uint8_t((t.color.b + tint.b) / 2)}
                         : tint;
    };
    draw(canvas, p, behind == 0 ? t.color : tinted(behind == 3 ? mirrored : red), is_filled);
}

void draw_clipped(Canvas& canvas, const Triangle& t, double near, bool is_filled) {
    std::vector<dvec2> p;
    for (const Corner& c : clipped(t, near)) p.push_back(divided(c, canvas));
    draw(canvas, p, corners_behind(t) == 0 || is_filled ? t.color : red, is_filled);
}

/// A checkered floor one unit under an eye that looks along it: half of it lies behind.
std::vector<Triangle> floor_under_the_eye() {
    std::vector<Triangle> floor;
    const double aspect = double(example_width) / example_height;
    const auto at = [&](int x, int z) {
        return Corner{(x - 0.5) / aspect, -1, -(z - 0.5)};
    };  // a field of view of 90 degrees
    for (int z = -6; z < 6; ++z)
        for (int x = -6; x < 6; ++x) {
            const Code color = (x + z) % 2 == 0 ? Code{200, 205, 215} : Code{70, 90, 130};
            floor.push_back({{at(x, z), at(x + 1, z), at(x + 1, z + 1)}, color});
            floor.push_back({{at(x, z), at(x + 1, z + 1), at(x, z + 1)}, color});
        }
    return floor;
}

void add_example(Stage& s) {
    Canvas wrong(example_width, example_height, ground), right(example_width, example_height, ground);
    std::vector<Triangle> floor = floor_under_the_eye();
    const auto order = [](const Triangle& t) {
        return corners_behind(t) == 0 ? 1 : corners_behind(t) == 3 ? 2 : 0;
    };  // what crosses lies lowest
    std::stable_sort(floor.begin(), floor.end(),
                     [&](const Triangle& a, const Triangle& b) { return order(a) < order(b); });
    for (const Triangle& t : floor) {
        draw_divided(wrong, t, true);
        draw_clipped(right, t, 0.05, true);
    }
    s.pictures.push_back({"wrap-round-example",
                          "A built-in example, a checkered floor that passes under the eye, divided without clipping: "
                          "what lies behind the eye (violet) hangs upside down in the sky, "
                          "and squares that pass the eye's plane (red) are drawn inside out.",
                          std::move(wrong)});
    s.pictures.push_back({"wrap-round-example-clipped",
                          "The same floor, clipped at the near plane before the division.", std::move(right)});
}

/// The model's triangles, of objects too that are wholly outside.
class ModelTriangles {
public:
    ModelTriangles(const Sources& of, const Vertices& vertices) : of_(of), vertices_(vertices) {}

    template <class Visit>
    void visit(const Visit& visit) const {
        const shading::PictureCamera& view = of_.engine.view();
        for (std::size_t d = 0; d < vertices_.draws().size(); ++d) {
            const Mesh& mesh = vertices_.mesh(d);
            for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
                Triangle t{{}, wire};
                for (std::size_t k = 0; k < 3; ++k) {
                    const dvec3 p = vertices_.camera(d, mesh.indices[i + k]);
                    t.corner[k] = {p.x * view.scale_x, p.y * view.scale_y, -p.z};
                }
                visit(t);
            }
        }
    }

private:
    const Sources& of_;
    const Vertices& vertices_;
};

/// The model's two pictures. @param behind  triangles with a corner behind the eye
void add_model(Stage& s, const Sources& of, const ModelTriangles& triangles, std::uint64_t all, std::uint64_t behind) {
    Canvas wrong(of.engine.settings().width, of.engine.settings().height, ground), right = wrong;
    const std::uint64_t step = all / 150000 + 1;
    const bool fills = behind <= filled_triangles;
    for (const bool with_area : {true, false}) {  // areas first, then the others' outlines over them
        std::uint64_t number = 0;
        triangles.visit([&](Triangle t) {
            const int n = corners_behind(t);
            if (with_area) t.color = area;
            if (with_area != (fills && n > 0)) return;
            if (number++ % step != 0 && (n == 0 || behind > 150000)) return;
            draw_divided(wrong, t, with_area);
            draw_clipped(right, t, of.engine.view().z_near, with_area);
        });
    }
    const std::string note = step > 1 ? " Not all triangles are drawn." : "";
    s.pictures.push_back({"wrap-round",
                          "Divided without clipping: red triangles cross the eye's plane, violet ones are behind the "
                          "eye and should not be here." +
                              note,
                          std::move(wrong)});
    s.pictures.push_back({"wrap-round-clipped",
                          std::string("Clipped at the near plane first: ") + (fills ? "areas are" : "red is") +
                              " the rest of the triangles that cross the eye's plane." + note,
                          std::move(right)});
}

Stage make_wrap_stage(const Sources& of) {
    const Vertices vertices(of);
    Stage s{.id = "wrap-round", .title = "What clipping before the division prevents"};
    if (of.engine.view().orthographic) {
        s.text =
            "In parallel projection w is 1 everywhere: nothing is divided, and nothing can wrap around. In perspective "
            "it can:";
        add_example(s);
        return s;
    }
    s.text =
        "Behind the eye w is negative. Divided by it, a point there comes out in front, mirrored through the middle of "
        "the picture; the edge of a triangle from before the eye to behind it, which in truth runs out of the picture, "
        "would be drawn between the two ends, through the wrong side of infinity: it wraps around. So triangles are "
        "clipped at the near plane first.";
    std::uint64_t crossing = 0, behind = 0, all = 0;
    const ModelTriangles triangles(of, vertices);
    triangles.visit([&](const Triangle& t) {
        const int n = corners_behind(t);
        crossing += n == 1 || n == 2;
        behind += n == 3;
        ++all;
    });
    s.numbers = {{"triangles", all}, {"through the eye's plane", crossing}, {"entirely behind the eye", behind}};
    if (crossing + behind == 0) {
        s.text += " Nothing of this model is behind the eye, so here is a built-in example:";
        add_example(s);
        return s;
    }
    add_model(s, of, triangles, all, crossing + behind);
    if (crossing == 0) add_example(s);
    return s;
}

}  // namespace

constinit const StageKind wrap_stage{make_wrap_stage};

}  // namespace rakelight::stages
