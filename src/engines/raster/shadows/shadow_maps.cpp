// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shadows/shadow_maps.h"

#include <algorithm>
#include <cmath>

#include "engines/raster/material_jobs.h"
#include "engines/raster/tile.h"
#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

using lighting::LightParameters;

static_assert(shading::shadow_texel_bytes == sizeof(float) + sizeof(std::int32_t));

/// Where a map is drawn to, [shadow_size * shadow_size] each.
struct MapTexels {
    float* nearness;
    std::int32_t* slopes;
};

/// Change of the depth key per texel to the right and down.
dvec2 key_slopes(const ScreenTriangle& s) {
    constexpr double per_texel = 1 << subpixel_bits;
    const double x1 = (s.x1 - s.x0) / per_texel, y1 = (s.y1 - s.y0) / per_texel;
    const double x2 = (s.x2 - s.x0) / per_texel, y2 = (s.y2 - s.y0) / per_texel;
    const double k1 = double(s.key1) - double(s.key0), k2 = double(s.key2) - double(s.key0);
    const double area = x1 * y2 - x2 * y1;
    return area != 0 ? dvec2{(k1 * y2 - k2 * y1) / area, (x1 * k2 - x2 * k1) / area} : dvec2{};
}

/// Of slopes in depth per texel's width.
std::int32_t coded_slopes(float x, float y) {
    static constexpr float most = shading::steepest_slope_on_map;
    const auto code = [](float slope) {
        return std::uint32_t((std::clamp(slope, -most, most) + most) * shading::slope_codes + 0.5f);
    };
    return std::int32_t(code(x) | code(y) << 16);
}

/// Where a map has nothing.
void clear_tile(const PictureCamera& view, const Window& area, const MapTexels& map) {
    const std::int32_t flat = coded_slopes(0, 0);
    for (int y = area.y; y < area.y + area.height; ++y) {
        const std::ptrdiff_t to = std::ptrdiff_t(y) * view.width + area.x;
        std::fill_n(map.nearness + to, area.width, view.orthographic ? shading::nothing_on_parallel_map : 0.0f);
        std::fill_n(map.slopes + to, area.width, flat);
    }
}

/// What a tile's pixels show -> the map.
void put_tile(const TileJob& job, std::size_t tile, const TileScratch& s, const MapTexels& map) {
    const PictureCamera& view = job.front.view;
    const Window area = job.grid.pixels(tile);
    const int left = job.grid.origin_x(tile), top = job.grid.origin_y(tile);
    const ScreenTriangle* const* const list = job.binned.items.data() + job.binned.offsets[tile];
    const double texels = 0.5 * view.width * view.scale_x, per_near = 1 / view.z_near;  // as ShadowView::texels
    // Depth d = near + (1 - key) (far - near), or near / key, where a texel is d / texels wide.
    const double scale = view.orthographic ? -texels * (view.z_far - view.z_near) : -texels;
    clear_tile(view, area, map);
    std::int32_t last = -1;
    dvec2 slopes{};
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x) {
            const auto p = std::size_t((y - top) * tile_size + x - left);
            const std::int32_t shown = s.visible[p];
            const float key = s.depth[p];
            if (shown < 0 || !(key > 0 || view.orthographic)) continue;
            if (shown != last) slopes = key_slopes(*list[shown]) * scale, last = shown;
            const float per_key = view.orthographic ? 1.0f : 1.0f / key;
            const std::ptrdiff_t to = std::ptrdiff_t(y) * view.width + x;
            map.nearness[to] = float(view.orthographic ? -view.distance_of(double(key)) : double(key) * per_near);
            map.slopes[to] = coded_slopes(float(slopes.x) * per_key, float(slopes.y) * per_key);
        }
}

/// Draws one map.
void draw_map(const DrawList& list, const shading::MapCamera& from, const RenderSettings& settings,
              const Kernels& kernels, const GeometryKernels& geometry_kernels, const MapTexels& map,
              PictureCamera& view, Context& context) {
    view = picture_camera_of(list, from.camera, settings);
    const TileGrid grid(settings.width, settings.height, {});
    FrontEnd front{.list = list,
                   .view = view,
                   .settings = settings,
                   .kernels = geometry_kernels,
                   .memory = PictureMemory(context.memory())};
    transform_draws(front, context);
    const Binned binned = set_up_and_bin(front, grid, {}, context);
    front.shading.assign(list.draws.size(), Shading::phong);
    make_material_jobs(front, {});
    const std::vector<LightParameters> no_lights;
    const LightPoints no_points;
    const TileJob job{front, binned, grid, no_lights, kernels, false, no_points};
    context.parallel_for(std::size_t(grid.rows), [&](std::size_t row) {
        const FlushDenormals guard;
        TileScratch scratch;
        for (int column = 0; column < grid.columns && !context.cancelled(); ++column) {
            const std::size_t tile = grid.first_of_row(int(row)) + std::size_t(column);
            if (binned.offsets[tile] == binned.offsets[tile + 1]) {
                clear_tile(view, grid.pixels(tile), map);
                continue;
            }
            find_visible(job, tile, scratch);
            put_tile(job, tile, scratch, map);
        }
    });
    context.throw_if_cancelled();
}

}  // namespace

void ShadowMaps::forget() {
    maps_.clear();
    views_.clear();
    charge_ = {};
    size_ = 0;
}

std::uint64_t ShadowMaps::count() const {
    std::uint64_t count = 0;
    for (const Maps& m : maps_) count += m.cameras.size();
    return count;
}

void ShadowMaps::plan(const DrawList& list, const RenderSettings& settings, Context& context) {
    shading::check_shadow_memory(list.scene.lights, settings, context.memory());
    for (std::size_t i = 0; i < list.scene.lights.size(); ++i)
        if (shading::casts_shadow(list.scene.lights[i]))
            maps_.push_back({.light = i, .cameras = shading::shadow_cameras(list, list.scene.lights[i], settings)});
    const std::uint64_t side = std::uint64_t(settings.shadow_size);
    charge_ = MemoryCharge(context.memory(), count() * side * side * shading::shadow_texel_bytes, "the shadow maps");
}

void ShadowMaps::update(const DrawList& list, const RenderSettings& settings, const Kernels& kernels,
                        const GeometryKernels& geometry_kernels, dvec3 eye, std::vector<LightParameters>& lights,
                        Context& context) {
    if (!shading::has_shadow_maps(list, settings, context.report())) return forget();
    if (size_ != settings.shadow_size || filter_ != settings.shadow_filter) {
        forget();
        plan(list, settings, context);
        const RenderSettings of_map = shading::map_settings(settings.shadow_size);
        const std::size_t texels = std::size_t(settings.shadow_size) * std::size_t(settings.shadow_size);
        for (Maps& m : maps_) {
            m.nearness = std::make_unique_for_overwrite<float[]>(texels * m.cameras.size());
            m.slopes = std::make_unique_for_overwrite<std::int32_t[]>(texels * m.cameras.size());
            for (std::size_t face = 0; face < m.cameras.size(); ++face, ++drawn_)
                draw_map(list, m.cameras[face], of_map, kernels, geometry_kernels,
                         {m.nearness.get() + face * texels, m.slopes.get() + face * texels}, m.view, context);
        }
        size_ = settings.shadow_size, filter_ = settings.shadow_filter;  // all are there: nothing was thrown
    }
    views_.clear();
    for (const Maps& m : maps_) {
        lights[m.light].shadow = std::int32_t(views_.size());
        ShadowView& view = views_.emplace_back();
        static_cast<shading::ShadowFactors&>(view) =
            shading::shadow_factors(m.cameras[0], m.view, m.cameras.size(), settings, eye);
        view.nearness = m.nearness.get();
        view.slopes = m.slopes.get();
    }
}

}  // namespace rakelight::raster
