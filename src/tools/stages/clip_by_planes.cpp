// SPDX-License-Identifier: Apache-2.0
// Clipping plane by plane, as the textbook does it: each plane of the frustum in turn cuts every polygon that passes
// it.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "tools/stages/plot.h"

namespace rakelight::stages {
namespace {

/// A corner of a polygon in clip space: x, y, w and the distance along the view axis.
struct Corner {
    double x, y, w, distance;
};
using Polygon = std::vector<Corner>;

/// The planes in the order in which they cut. The picture shows distance and one of x and y.
struct CutPlane {
    const char* name;
    bool shows_x;
    double (*inside_by)(const Corner& c, const shading::PictureCamera& view);  ///< >= 0: inside
};
constexpr CutPlane cut_planes[] = {
    {"near", false, [](const Corner& c, const shading::PictureCamera& v) { return c.distance - v.z_near; }},
    {"far", false, [](const Corner& c, const shading::PictureCamera& v) { return v.z_far - c.distance; }},
    {"left", true, [](const Corner& c, const shading::PictureCamera&) { return c.w + c.x; }},
    {"right", true, [](const Corner& c, const shading::PictureCamera&) { return c.w - c.x; }},
    {"bottom", false, [](const Corner& c, const shading::PictureCamera&) { return c.w + c.y; }},
    {"top", false, [](const Corner& c, const shading::PictureCamera&) { return c.w - c.y; }},
};
constexpr std::size_t planes = std::size(cut_planes);

/// Sutherland & Hodgman 1974. `sign` -1 gives the part that is cut off.
Polygon cut(const Polygon& in, const CutPlane& plane, const shading::PictureCamera& view, double sign) {
    Polygon out;
    for (std::size_t i = 0; i < in.size(); ++i) {
        const Corner &a = in[i], &b = in[(i + 1) % in.size()];
        const double da = sign * plane.inside_by(a, view), db = sign * plane.inside_by(b, view);
        if (da >= 0) out.push_back(a);
        if ((da >= 0) == (db >= 0)) continue;
        const double t = da / (da - db);
        out.push_back({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.w + (b.w - a.w) * t,
                       a.distance + (b.distance - a.distance) * t});
    }
    return out;
}

/// What each plane does to all triangles, one plane after the other.
class PlaneByPlane {
public:
    PlaneByPlane(const Sources& of, const Vertices& vertices) : view_(of.engine.view()) {
        const int width = of.engine.settings().width, height = of.engine.settings().height;
        find_extent(vertices);
        for (std::size_t p = 0; p < planes; ++p) {
            const dvec2 reach = {farthest_, cut_planes[p].shows_x ? widest_ : highest_};
            fits_[p] = fit({std::min(0.0, nearest_), -reach.y}, reach, width, height);
            canvases_.emplace_back(width, height, ground);
            draw_plane(p, reach);
        }
        for_each_triangle(vertices, [this](const Polygon& triangle) { run(triangle); });
    }

    struct Counts {
        std::uint64_t reached = 0, cut = 0, outside = 0, corners_before = 0, corners_after = 0;
    };
    const Counts& counts(std::size_t p) const { return counts_[p]; }
    Canvas& canvas(std::size_t p) { return canvases_[p]; }

private:
    template <class Visit>
    static void for_each_triangle(const Vertices& vertices, const Visit& visit) {
        for (std::size_t d = 0; d < vertices.draws().size(); ++d) {
            if (!vertices.is_transformed(d)) continue;
            const Mesh& mesh = vertices.mesh(d);
            for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
                Polygon triangle;
                for (std::size_t k = 0; k < 3; ++k) {
                    const shading::ClipVertex c = vertices.clip(d, mesh.indices[i + k]);
                    triangle.push_back({double(c.x), double(c.y), double(c.w), double(c.distance)});
                }
                const auto finite = [](const Corner& c) {
                    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.distance);
                };
                if (std::all_of(triangle.begin(), triangle.end(), finite)) visit(triangle);
            }
        }
    }

    void find_extent(const Vertices& vertices) {
        for_each_triangle(vertices, [this](const Polygon& triangle) {
            for (const Corner& c : triangle) {
                nearest_ = std::min(nearest_, c.distance);
                farthest_ = std::max(farthest_, c.distance);
                widest_ = std::max(widest_, std::fabs(c.x));
                highest_ = std::max(highest_, std::fabs(c.y));
            }
        });
    }

    void draw_plane(std::size_t p, dvec2 reach) {
        const Fit& f = fits_[p];
        canvases_[p].line(f({0, 0}), f({reach.x, 0}), axis);
        const std::string name = cut_planes[p].name;
        const double side = name == "left" || name == "bottom" ? -1 : 1;
        if (name == "near" || name == "far") {
            const double at = name == "near" ? view_.z_near : view_.z_far;
            canvases_[p].line(f({at, -reach.y}), f({at, reach.y}), frame);
        } else if (view_.orthographic) {
            canvases_[p].line(f({0, side}), f({reach.x, side}), frame);
        } else {
            canvases_[p].line(f({0, 0}), f({reach.x, side * reach.x}), frame);
        }
    }

    void outline(std::size_t p, const Polygon& polygon, Code color) {
        const auto at = [&](const Corner& c) { return fits_[p]({c.distance, cut_planes[p].shows_x ? c.x : c.y}); };
        for (std::size_t k = 0; k < polygon.size(); ++k)
            canvases_[p].line(at(polygon[k]), at(polygon[(k + 1) % polygon.size()]), color);
    }

    void run(Polygon polygon) {
        for (std::size_t p = 0; p < planes && polygon.size() >= 3; ++p) {
            Counts& n = counts_[p];
            const std::size_t inside = std::size_t(std::count_if(polygon.begin(), polygon.end(), [&](const Corner& c) {
                return cut_planes[p].inside_by(c, view_) >= 0;
            }));
            ++n.reached;
            n.corners_before += polygon.size();
            if (inside == 0) ++n.outside;
            if (inside > 0 && inside < polygon.size()) {
                Polygon kept = cut(polygon, cut_planes[p], view_, 1);
                if (++n.cut <= drawn_polygons) {
                    outline(p, cut(polygon, cut_planes[p], view_, -1), red);
                    outline(p, kept, wire);
                }
                polygon = std::move(kept);
            }
            if (inside == 0) polygon.clear();
            n.corners_after += polygon.size();
        }
    }

    static constexpr std::uint64_t drawn_polygons = 50000;
    const shading::PictureCamera& view_;
    double nearest_ = 0, farthest_ = 0, widest_ = 0, highest_ = 0;
    std::array<Fit, planes> fits_;
    std::vector<Canvas> canvases_;
    std::array<Counts, planes> counts_;
};

Stage make_planes_stage(const Sources& of) {
    const Vertices vertices(of);
    Stage s{.id = "clip-planes", .title = "Clipping, plane by plane"};
    s.text =
        "The textbook's way: each plane of the frustum in turn cuts every polygon that crosses it; a triangle may "
        "become a polygon of up to nine corners. The engine clips only at the near and far plane, see above, and "
        "leaves the sides to rasterization. Objects that are entirely outside were dropped before.";
    PlaneByPlane all(of, vertices);
    s.columns = {"plane", "polygons that reach it", "cut", "wholly outside", "corners before", "corners after"};
    for (std::size_t p = 0; p < planes; ++p) {
        const PlaneByPlane::Counts& n = all.counts(p);
        s.rows.push_back({cut_planes[p].name, n.reached, n.cut, n.outside, n.corners_before, n.corners_after});
        if (n.cut == 0) continue;
        s.pictures.push_back({std::string("clip-") + cut_planes[p].name,
                              std::string("Polygons that cross the ") + cut_planes[p].name +
                                  " plane (orange): blue is kept, red is cut off. Distance to the right, " +
                                  (cut_planes[p].shows_x ? "x" : "y") + " up.",
                              std::move(all.canvas(p))});
    }
    s.rows_note = "What each plane does, in this order";
    if (!s.pictures.empty()) return s;
    s.text += " No triangle of this model crosses a plane.";
    const double far = vertices.farthest();
    Space space{.caption = "Distance to the right, x up: everything lies between the planes (orange).",
                .only_transformed = true,
                .place = [&](std::size_t d, std::uint32_t v) {
                    const shading::ClipVertex c = vertices.clip(d, v);
                    return dvec2{double(c.distance), double(c.x)};
                }};
    const bool parallel = of.engine.view().orthographic;
    for (const double side : {-1.0, 1.0})
        space.before.push_back({{0, parallel ? side : 0}, {far, side * (parallel ? 1 : far)}});
    add_plot(s, of, vertices, "clip-planes", space);
    return s;
}

}  // namespace

constinit const StageKind clip_planes_stage{make_planes_stage};

}  // namespace rakelight::stages
