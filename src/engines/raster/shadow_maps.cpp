// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shadow_maps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engines/raster/tile.h"
#include "math/flush_denormals.h"
#include "math/functions.h"

namespace rakelight::raster {
namespace {

using lighting::LightKind;
using lighting::LightParameters;

constexpr double largest_scene = 1e30;         ///< [m] diagonal; beyond, maps' numbers leave the range of floats
constexpr double widest_spot = radians(60.0);  ///< half angle; wider ones have six maps
constexpr std::uint64_t bytes_per_texel = sizeof(float) + sizeof(std::int32_t);
constexpr float nothing_parallel = -3e38f;  ///< nearness where nothing is

/// As the faces of kernels/shadow.h: about +x, -x, +y, -y, +z, -z.
constexpr MapAxes cube[6] = {{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},  {{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}},
                             {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},  {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                             {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}};

MapAxes axes_along(dvec3 z) {
    const dvec3 side = std::fabs(z.y) < 0.9 ? dvec3{0, 1, 0} : dvec3{1, 0, 0};
    const dvec3 x = normalize_or(cross(z, side), dvec3{1, 0, 0});
    return {x, cross(x, z), z};
}

dmat4 placed(const MapAxes& a, dvec3 at) {
    dmat4 m;
    m[0] = {a.x.x, a.x.y, a.x.z, 0};
    m[1] = {a.y.x, a.y.y, a.y.z, 0};
    m[2] = {-a.z.x, -a.z.y, -a.z.z, 0};
    m[3] = {at.x, at.y, at.z, 1};
    return m;
}

/// The share of a map that is left when the filter is to stay inside of it: [texels] a side.
double inner_share(const RenderSettings& s) { return 1 - 2.0 * (s.shadow_filter + 2) / s.shadow_size; }

/// Parallel, about everything that is drawn.
MapCamera directional_camera(const Bounds& bounds, dvec3 direction, const RenderSettings& settings) {
    MapCamera out{{}, axes_along(direction), {}};
    const dvec3 middle = (bounds.low + bounds.high) * 0.5;
    double half = 0, depth = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p = {corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                         corner & 4 ? bounds.high.z : bounds.low.z};
        const dvec3 d = p - middle;
        half = std::max({half, std::fabs(dot(d, out.axes.x)), std::fabs(dot(d, out.axes.y))});
        depth = std::max(depth, std::fabs(dot(d, out.axes.z)));
    }
    const double size = std::max({half, depth, 1e-9 * length(middle), 1e-12});
    half = std::max(half, 1e-6 * size), depth = std::max(depth, 1e-6 * size);
    out.eye = middle - out.axes.z * (1.01 * depth);
    out.camera.projection = Projection::orthographic;
    out.camera.half_height = half / inner_share(settings);
    out.camera.near = 0;
    out.camera.far = 2.02 * depth;
    out.camera.to_world = placed(out.axes, out.eye);
    return out;
}

/// In perspective.
/// @param half_angle  [rad] below 90 degrees
MapCamera lamp_camera(const Bounds& bounds, dvec3 position, const MapAxes& axes, double half_angle,
                      const RenderSettings& settings) {
    MapCamera out{{}, axes, position};
    out.camera.vertical_fov_rad = 2 * math::atan2(math::tan(half_angle), inner_share(settings));
    out.camera.near = std::max(1e-6 * bounds.diagonal(), 1e-12);
    out.camera.far = std::numeric_limits<double>::infinity();
    out.camera.to_world = placed(axes, position);
    return out;
}

/// Where a light stands, in double.
struct LightPlace {
    dvec3 position, direction;
};
LightPlace place_of(const DrawList& list, const Light& light) {
    LightPlace out{light.position, light.direction};
    if (light.node != none) {
        const dmat4& m = list.node_to_world[light.node];
        out = {m[3].xyz(), -m[2].xyz()};
    }
    out.direction = normalize_or(out.direction, {0, 0, -1});
    return out;
}

double half_angle_of(const Light& light) {
    const double angle = light.units == LightUnits::classical ? light.cutoff_rad : light.outer_cone_rad;
    return std::max(angle, radians(0.5));
}

bool casts_shadow(const Light& light) { return light.type != LightType::ambient && light.casts_shadow; }

bool has_one_map(const Light& light) {
    return light.type == LightType::directional ||
           (light.type == LightType::spot && half_angle_of(light) <= widest_spot);
}

std::vector<MapCamera> cameras_of(const DrawList& list, const Light& light, const RenderSettings& settings) {
    const LightPlace at = place_of(list, light);
    if (light.type == LightType::directional) return {directional_camera(list.bounds, at.direction, settings)};
    if (has_one_map(light))
        return {lamp_camera(list.bounds, at.position, axes_along(at.direction), half_angle_of(light), settings)};
    std::vector<MapCamera> out;
    for (const MapAxes& axes : cube)
        out.push_back(lamp_camera(list.bounds, at.position, axes, radians(45.0), settings));
    return out;
}

/// The picture's settings as far as a map needs them.
RenderSettings map_settings(const RenderSettings& of) {
    RenderSettings s;
    s.width = s.height = of.shadow_size;
    s.cull = Cull::none;
    s.bump = Bump::none;
    return s;
}

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
    static constexpr float most = steepest_slope_on_map;
    const auto code = [](float slope) {
        return std::uint32_t((std::clamp(slope, -most, most) + most) * slope_codes + 0.5f);
    };
    return std::int32_t(code(x) | code(y) << 16);
}

/// Where a map has nothing.
void clear_tile(const View& view, const Window& area, const MapTexels& map) {
    const std::int32_t flat = coded_slopes(0, 0);
    for (int y = area.y; y < area.y + area.height; ++y) {
        const std::ptrdiff_t to = std::ptrdiff_t(y) * view.width + area.x;
        std::fill_n(map.nearness + to, area.width, view.orthographic ? nothing_parallel : 0.0f);
        std::fill_n(map.slopes + to, area.width, flat);
    }
}

/// What a tile's pixels show -> the map.
void put_tile(const TileJob& job, std::size_t tile, const TileScratch& s, const MapTexels& map) {
    const View& view = job.front.view;
    const Window area = job.grid.pixels(tile);
    const int left = job.grid.origin_x(tile), top = job.grid.origin_y(tile);
    const ScreenTriangle* const* const list = job.binned.items.data() + job.binned.offsets[tile];
    const double texels = 0.5 * view.width * view.scale_x, per_near = 1 / view.near;  // as ShadowView::texels
    // Depth d = near + (1 - key) (far - near), or near / key, where a texel is d / texels wide.
    const double scale = view.orthographic ? -texels * (view.far - view.near) : -texels;
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
void draw_map(const DrawList& list, const MapCamera& from, const RenderSettings& settings, const Kernels& kernels,
              const GeometryKernels& geometry_kernels, const MapTexels& map, View& view, Context& context) {
    view = view_of(list, from.camera, settings);
    const TileGrid grid(settings.width, settings.height, {});
    FrontEnd front{.list = list,
                   .view = view,
                   .settings = settings,
                   .kernels = geometry_kernels,
                   .memory = PictureMemory(context.memory())};
    transform_draws(front, context);
    const Binned binned = set_up_and_bin(front, grid, {}, context);
    front.shading.assign(list.draws.size(), Shading::phong);
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

void set_row(float (&to)[4], dvec3 axis, dvec3 from, dvec3 eye) {
    to[0] = float(axis.x), to[1] = float(axis.y), to[2] = float(axis.z);
    to[3] = float(dot(axis, eye - from));
}

ShadowView view_for(const MapCamera& first, const View& view, std::size_t faces, const RenderSettings& settings,
                    dvec3 eye) {
    ShadowView out{};
    out.size = settings.shadow_size;
    out.faces = std::int32_t(faces);
    out.is_orthographic = view.orthographic;
    set_row(out.to_light[0], first.axes.x, first.eye, eye);
    set_row(out.to_light[1], first.axes.y, first.eye, eye);
    set_row(out.to_light[2], first.axes.z, first.eye, eye);
    if (faces == 6)  // the axes of the world: the kernel turns to the faces itself
        for (std::size_t c = 0; c < 3; ++c) {
            dvec3 axis;
            axis[c] = 1;
            set_row(out.to_light[c], axis, first.eye, eye);
        }
    out.texels = float(0.5 * settings.shadow_size * view.scale_y);
    out.bias = settings.shadow_bias;
    out.filter = settings.shadow_filter;
    return out;
}

}  // namespace

void check_shadow_memory(std::span<const Light> lights, const RenderSettings& settings, const MemoryBudget& memory) {
    if (!settings.shadows) return;
    std::uint64_t maps = 0;
    for (const Light& light : lights)
        if (casts_shadow(light)) maps += has_one_map(light) ? 1 : 6;
    const std::uint64_t side = std::uint64_t(settings.shadow_size), bytes = maps * side * side * bytes_per_texel;
    const std::uint64_t all = memory.limit(), taken = memory.charged();
    const std::uint64_t limit = std::min(all / 2, all > taken ? all - taken : 0);
    if (bytes <= limit) return;
    throw Error(ErrorCode::usage,
                "--shadow-size " + std::to_string(side) + ": " + std::to_string(maps) + " shadow maps of " +
                    std::to_string(side) + " x " + std::to_string(side) + " texels need " + std::to_string(bytes) +
                    " bytes, more than " + std::to_string(limit),
                {}, "make them smaller, or raise the limit with --max-memory");
}

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
    check_shadow_memory(list.scene.lights, settings, context.memory());
    for (std::size_t i = 0; i < list.scene.lights.size(); ++i)
        if (casts_shadow(list.scene.lights[i]))
            maps_.push_back({.light = i, .cameras = cameras_of(list, list.scene.lights[i], settings)});
    const std::uint64_t side = std::uint64_t(settings.shadow_size);
    charge_ = MemoryCharge(context.memory(), count() * side * side * bytes_per_texel, "the shadow maps");
}

void ShadowMaps::update(const DrawList& list, const RenderSettings& settings, const Kernels& kernels,
                        const GeometryKernels& geometry_kernels, dvec3 eye, std::vector<LightParameters>& lights,
                        Context& context) {
    const bool is_wanted = settings.shadows && !list.draws.empty(), fits = list.bounds.diagonal() < largest_scene;
    if (is_wanted && !fits)
        context.report().add(Remark::warning, list.scene.source, {}, "the scene is too large for shadows");
    if (!is_wanted || !fits) return forget();
    if (size_ != settings.shadow_size || filter_ != settings.shadow_filter) {
        forget();
        plan(list, settings, context);
        const RenderSettings of_map = map_settings(settings);
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
        ShadowView& view = views_.emplace_back(view_for(m.cameras[0], m.view, m.cameras.size(), settings, eye));
        view.nearness = m.nearness.get();
        view.slopes = m.slopes.get();
    }
}

}  // namespace rakelight::raster
