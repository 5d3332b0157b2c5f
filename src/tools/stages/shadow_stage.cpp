// SPDX-License-Identifier: Apache-2.0
// Shadows: how much of each light reaches the visible surfaces, and what the light sees: its shadow map.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/material_names.h"
#include "tools/stages/paint.h"

namespace rakelight::stages {
namespace {

constexpr int map_side = 320;       ///< [px] most of a face of a map
constexpr Code beside{44, 52, 84};  ///< nothing that is lit: not to be taken for shadow

/// [m] along the map's axis from the light (parallel: about the eye); not finite where nothing is.
double distance_on_map(const raster::ShadowMapView& map, std::size_t texel) {
    const double nearness = double(map.nearness[texel]);
    if (map.is_orthographic != 0) return nearness > -1e38 ? -nearness : std::numeric_limits<double>::infinity();
    return nearness > 0 ? 1 / nearness : std::numeric_limits<double>::infinity();
}

/// The faces of a map side by side, three in a row.
Picture map_picture(const raster::ShadowMapView& map, const std::string& number, const std::string& light) {
    const auto size = std::size_t(map.size), faces = std::size_t(map.faces);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t t = 0; t < faces * size * size; ++t)
        if (const double d = distance_on_map(map, t); std::isfinite(d))
            low = std::min(low, d), high = std::max(high, d);
    const int side = std::min(map_side, map.size), columns = faces == 6 ? 3 : 1, gap = faces == 6 ? 4 : 0;
    Canvas canvas(columns * (side + gap) - gap, int(faces) / columns * (side + gap) - gap, {60, 66, 80});
    for (int face = 0; face < int(faces); ++face)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto u = std::size_t(x) * size / std::size_t(side), v = std::size_t(y) * size / std::size_t(side);
                const double d = distance_on_map(map, (std::size_t(face) * size + v) * size + u);
                const Code color =
                    !std::isfinite(d) ? beside : gray(high > low ? 1 - 0.85 * (d - low) / (high - low) : 1);
                canvas.set(face % columns * (side + gap) + x, face / columns * (side + gap) + y, color);
            }
    return {"shadow-map-" + number,
            "What " + light + " sees: light is near, dark is far" +
                (faces == 6 ? "; above along +x, -x, +y, below along -y, +z, -z." : "."),
            std::move(canvas)};
}

/// Of the pixels that are lit: how many, mean share, wholly in shadow, wholly in light.
Cell::List seen_cells(const std::vector<float>& seen) {
    std::uint64_t lit = 0, none_of_it = 0, all_of_it = 0;
    double sum = 0;
    for (const float share : seen) {
        if (share < 0) continue;
        ++lit, sum += double(share), none_of_it += share == 0, all_of_it += share > 1 - 1e-6f;
    }
    return {lit, lit > 0 ? sum / double(lit) : 0, none_of_it, lit - none_of_it - all_of_it, all_of_it};
}

Stage make_shadow_stage(const Sources& of) {
    Stage s{.id = "shadows", .title = "Shadows"};
    s.text =
        "Before the picture, each light draws a shadow map: the distance of the nearest surface. A pixel compares the "
        "plane of its triangle with the texels around its place on the map; the fraction of uncovered ones multiplies "
        "the light's diffuse and specular terms. Faces that face away from the light get none of it. Height maps with "
        "the setting bump-self-shadow also darken the hollows of their relief here. Ambient light has no shadow. With "
        "flat and Gouraud shading, surfaces cast shadows but receive none.";
    const std::vector<raster::ShadowMapView> maps = of.engine.shadow_maps();
    const RenderSettings& settings = of.engine.settings();
    s.numbers = {{"texels per side", settings.shadow_size},
                 {"filter radius [texels]", settings.shadow_filter},
                 {"bias", double(settings.shadow_bias)}};
    if (maps.empty()) s.numbers = {{"shadow maps", 0}};
    s.columns = {"light", "maps", "texels per meter", "lit pixels", "mean share", "in shadow", "in part", "in light"};
    for (std::size_t i = 0; i < of.pixels.seen.size(); ++i) {
        const Light& light = of.engine.list().scene.lights[i];
        const std::int32_t map = !maps.empty() ? of.engine.lights()[i].shadow : -1;
        const std::string number = std::to_string(i), name = "light " + number_and_name(light, i);
        const std::vector<float>& seen = of.pixels.seen[i];
        Cell::List row = {name, map >= 0 ? maps[std::size_t(map)].faces : 0,
                          map >= 0 ? double(maps[std::size_t(map)].texels) : 0.0};
        for (const Cell& v : seen_cells(seen)) row.push_back(v);
        s.rows.push_back(std::move(row));
        if (light.type == LightType::ambient) continue;
        s.pictures.push_back(
            {"shadow-" + number,
             "How much of " + name + " reaches the surface: black nothing, white all; blue: it lights nothing there.",
             paint(of, [&](std::size_t p) { return seen[p] < 0 ? beside : gray(double(seen[p])); })});
        if (map >= 0) s.pictures.push_back(map_picture(maps[std::size_t(map)], number, name));
    }
    s.rows_note =
        "Pixels that the light would reach without occluders, and the fraction of it that does; texels per meter on "
        "the map, for lamps at a distance of 1 m";
    return s;
}

bool has_shadows(const Sources& of) { return !of.pixels.seen.empty(); }

}  // namespace

constinit const StageKind shadow_stage{make_shadow_stage, has_shadows};

}  // namespace rakelight::stages
