// SPDX-License-Identifier: Apache-2.0
// Clipping, before the division.
#include <array>
#include <utility>

#include "tools/stages/plot.h"

namespace rakelight::stages {

std::vector<Stage> clip_stages(const Sources& of) {
    const Vertices vertices(of);
    Stage s{.id = "clipped",
            .title = "Clipped polygons",
            .text =
                "Triangles that pass the near or the far plane, or leave the guard band (a million pixels round the "
                "picture), are cut to polygons of up to 9 "
                "corners before the division (Sutherland and Hodgman). The sides of the picture only reject what is "
                "wholly outside: rasterization leaves out the rest for less than cutting costs."};
    static constexpr std::pair<unsigned, const char*> planes[] = {{raster::clip_near, "near"},
                                                                  {raster::clip_far, "far"},
                                                                  {raster::clip_guard_left, "guard band left"},
                                                                  {raster::clip_guard_right, "guard band right"},
                                                                  {raster::clip_guard_bottom, "guard band bottom"},
                                                                  {raster::clip_guard_top, "guard band top"},
                                                                  {raster::clip_left, "left"},
                                                                  {raster::clip_right, "right"},
                                                                  {raster::clip_bottom, "bottom"},
                                                                  {raster::clip_top, "top"}};
    const raster::View& view = of.engine.view();
    const raster::ClipVolume volume(view);
    std::array<std::uint64_t, std::size(planes)> passing{}, outside{};
    std::uint64_t clipped = 0;
    Canvas canvas(of.engine.settings().width, of.engine.settings().height, ground);
    for (std::size_t d = 0; d < vertices.draws().size(); ++d) {
        if (!vertices.is_transformed(d)) continue;
        const Mesh& mesh = vertices.mesh(d);
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
            const std::uint32_t* index = mesh.indices.data() + 3 * t;
            const raster::ClipVertex v[3] = {vertices.clip(d, index[0]), vertices.clip(d, index[1]),
                                             vertices.clip(d, index[2])};
            const unsigned codes[3] = {outcode(v[0], volume), outcode(v[1], volume), outcode(v[2], volume)};
            const unsigned any = codes[0] | codes[1] | codes[2], all = codes[0] & codes[1] & codes[2];
            for (std::size_t p = 0; p < std::size(planes); ++p) {
                outside[p] += (all & planes[p].first) != 0;
                passing[p] += all == 0 && (any & planes[p].first) != 0;
            }
            if (all != 0 || any == ~0u || (any & raster::cutting_planes) == 0) continue;
            ++clipped;
            raster::ClipVertex polygon[raster::max_clipped_vertices];
            const std::size_t corners = clip_triangle(v, any & raster::cutting_planes, volume, polygon);
            for (std::size_t k = 0; k < corners; ++k)
                canvas.line(view.screen(polygon[k]), view.screen(polygon[(k + 1) % corners]), red);
            if (s.rows.size() >= listed_rows) continue;
            Json corner_list = Json::array();
            for (std::size_t k = 0; k < corners; ++k)
                corner_list.push_back(
                    {cell(double(polygon[k].x)), cell(double(polygon[k].y)), cell(double(polygon[k].w))});
            s.rows.push_back({vertices.object(d), t, corners, corner_list});
        }
    }
    s.numbers["triangles clipped"] = clipped;
    for (std::size_t p = 0; p < std::size(planes); ++p) {
        s.numbers[std::string("wholly outside of: ") + planes[p].second] = outside[p];
        s.numbers[std::string("passing, not wholly outside: ") + planes[p].second] = passing[p];
    }
    s.columns = {"object", "triangle", "corners", "x, y, w of each"};
    s.rows_note = clipped == 0 ? "Nothing had to be clipped."
                               : "The first " + std::to_string(s.rows.size()) + " of " + std::to_string(clipped) +
                                     " clipped triangles";
    s.pictures.push_back({"clipped",
                          clipped == 0 ? "No polygon was clipped." : "The polygons that are left, on the screen.",
                          std::move(canvas)});
    return {std::move(s)};
}

}  // namespace rakelight::stages
