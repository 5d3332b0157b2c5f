// SPDX-License-Identifier: Apache-2.0
// Clip space, and what clipping makes of the triangles before the division.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/format_text.h"
#include "engines/raster/geometry/clip.h"
#include "tools/stages/plot.h"

namespace rakelight::stages {
namespace {

Stage make_clip_space_stage(const Sources& of) {
    const Vertices vertices(of);
    Stage s{.id = "clip-space",
            .title = "Clip space, before the division",
            .text =
                "x and y are scaled so that the frustum's sides become the planes x = +-w and y = +-w: in perspective, "
                "where w is the "
                "distance along the view axis, a frustum of 90 degrees. Here the engine goes from double to single "
                "precision. Clipping is done here, because "
                "behind the eye w is negative, and a division would wrap such points round to the front."};
    const shading::PictureCamera& view = of.engine.view();
    const bool parallel = view.orthographic;
    const double far = std::min(view.z_far, vertices.farthest()), w = parallel ? 1 : view.z_near;
    Space space{.caption = std::string(parallel ? "Distance" : "w") +
                           " to the right, y up; in orange the planes y = +-w and the near plane.",
                .only_transformed = true,
                .place = [&](std::size_t d, std::uint32_t v) {
                    const shading::ClipVertex c = vertices.clip(d, v);
                    return dvec2{double(c.distance), double(c.y)};
                }};
    space.behind.push_back({{0, 0}, {far, 0}, axis});
    for (const double y : {-1.0, 1.0}) space.before.push_back({{0, parallel ? y : 0}, {far, y * (parallel ? 1 : far)}});
    space.before.push_back({{view.z_near, -w}, {view.z_near, w}});
    add_plot(s, of, vertices, "clip-space", space);
    add_table(s, vertices, true, {"x", "y", "w", "distance"}, [&](std::size_t d, std::uint32_t v) {
        const shading::ClipVertex c = vertices.clip(d, v);
        return std::vector<double>{double(c.x), double(c.y), double(c.w), double(c.distance)};
    });
    return s;
}

constexpr std::pair<unsigned, const char*> planes[] = {{raster::clip_near, "near"},
                                                       {raster::clip_far, "far"},
                                                       {raster::clip_guard_left, "guard band left"},
                                                       {raster::clip_guard_right, "guard band right"},
                                                       {raster::clip_guard_bottom, "guard band bottom"},
                                                       {raster::clip_guard_top, "guard band top"},
                                                       {raster::clip_left, "left"},
                                                       {raster::clip_right, "right"},
                                                       {raster::clip_bottom, "bottom"},
                                                       {raster::clip_top, "top"}};

/// What the engine's planes do to the triangles of the objects that may be seen.
struct EngineClipping {
    std::array<std::uint64_t, std::size(planes)> passing{},
        outside{};  ///< triangles; passing: not wholly outside of anything
    std::uint64_t clipped = 0;
};

/// Calls visit(draw, triangle, corners, count) for each polygon that is left of a triangle that was cut.
template <class Visit>
EngineClipping clip_all(const Sources& of, const Vertices& vertices, const Visit& visit) {
    EngineClipping result;
    const raster::ClipVolume volume(of.engine.view());
    for (std::size_t d = 0; d < vertices.draws().size(); ++d) {
        if (!vertices.is_transformed(d)) continue;
        const Mesh& mesh = vertices.mesh(d);
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
            const std::uint32_t* index = mesh.indices.data() + 3 * t;
            const shading::ClipVertex v[3] = {vertices.clip(d, index[0]), vertices.clip(d, index[1]),
                                              vertices.clip(d, index[2])};
            const unsigned codes[3] = {outcode(v[0], volume), outcode(v[1], volume), outcode(v[2], volume)};
            const unsigned any = codes[0] | codes[1] | codes[2], all = codes[0] & codes[1] & codes[2];
            for (std::size_t p = 0; p < std::size(planes); ++p) {
                result.outside[p] += (all & planes[p].first) != 0;
                result.passing[p] += all == 0 && (any & planes[p].first) != 0;
            }
            if (all != 0 || std::count(codes, codes + 3, raster::outside_all) > 0 ||
                (any & raster::cutting_planes) == 0)
                continue;
            ++result.clipped;
            shading::ClipVertex polygon[raster::max_clipped_vertices];
            visit(d, t, polygon, clip_triangle(v, any & raster::cutting_planes, volume, polygon));
        }
    }
    return result;
}

/// The triangles that are not cut, where they lie on the screen.
void add_screen_plot(Stage& s, const Sources& of, const Vertices& vertices) {
    const shading::PictureCamera& view = of.engine.view();
    add_plot(s, of, vertices, "clipped",
             {.only_transformed = true,
              .place =
                  [&](std::size_t d, std::uint32_t v) {
                      const shading::ClipVertex c = vertices.clip(d, v);
                      const dvec2 p = double(c.distance) < view.z_near ? dvec2{std::nan(""), 0} : view.screen(c);
                      return dvec2{p.x, -p.y};  // y is down already
                  },
              .fixed = Fit{}});
}

Stage make_clipped_stage(const Sources& of) {
    const Vertices vertices(of);
    Stage s{.id = "clipped", .title = "Clipped polygons"};
    s.text =
        "Triangles that cross the near or the far plane, or leave the guard band (a million pixels around the "
        "picture), are clipped to polygons of up to 9 corners before the division (Sutherland and Hodgman). The sides "
        "of the picture only reject triangles that are entirely outside: rasterization skips the rest at less cost "
        "than clipping.";
    const shading::PictureCamera& view = of.engine.view();
    add_screen_plot(s, of, vertices);
    Canvas& canvas = s.pictures.back().canvas;
    const EngineClipping all = clip_all(
        of, vertices, [&](std::size_t d, std::size_t t, const shading::ClipVertex* polygon, std::size_t corners) {
            for (std::size_t k = 0; k < corners; ++k)
                canvas.line(view.screen(polygon[k]), view.screen(polygon[(k + 1) % corners]), red);
            if (s.rows.size() >= listed_rows) return;
            Cell::List list;
            for (std::size_t k = 0; k < corners; ++k)
                list.push_back({cell(double(polygon[k].x)), cell(double(polygon[k].y)), cell(double(polygon[k].w))});
            s.rows.push_back({vertices.object(d), t, corners, list});
        });
    s.pictures.back().caption =
        (all.clipped == 0 ? "No triangle was clipped: these are on the screen unchanged."
                          : "On the screen: the rest of clipped triangles in red, the others in blue.") +
        s.pictures.back().caption;
    s.numbers["triangles clipped"] = all.clipped;
    for (std::size_t p = 0; p < std::size(planes); ++p) {
        s.numbers[std::string("entirely outside of: ") + planes[p].second] = all.outside[p];
        s.numbers[std::string("crossing, not entirely outside: ") + planes[p].second] = all.passing[p];
    }
    s.columns = {"object", "triangle", "corners", "x, y, w of each"};
    s.rows_note = all.clipped == 0 ? "Nothing had to be clipped."
                                   : format_text("The first {} of {} clipped triangles", s.rows.size(), all.clipped);
    return s;
}

}  // namespace

constinit const StageKind clip_space_stage{make_clip_space_stage}, clipped_stage{make_clipped_stage};

}  // namespace rakelight::stages
