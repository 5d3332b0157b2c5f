// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/shadow_cameras.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/format_text.h"
#include "math/functions.h"
#include "shading/lights/lights.h"

namespace rakelight::shading {
namespace {

constexpr double widest_spot = radians(60.0);  ///< half angle; wider ones have six maps

/// As the faces of lighting/shadow/shadow.glsl: about +x, -x, +y, -y, +z, -z.
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
        const dvec3 d = bounds.corner(corner) - middle;
        half = std::max({half, std::fabs(dot(d, out.axes.x)), std::fabs(dot(d, out.axes.y))});
        depth = std::max(depth, std::fabs(dot(d, out.axes.z)));
    }
    const double size = std::max({half, depth, 1e-9 * length(middle), 1e-12});
    half = std::max(half, 1e-6 * size), depth = std::max(depth, 1e-6 * size);
    out.eye = middle - out.axes.z * (1.01 * depth);
    out.camera.projection = Projection::orthographic;
    out.camera.half_height = half / inner_share(settings);
    out.camera.z_near = 0;
    out.camera.z_far = 2.02 * depth;
    out.camera.to_world = placed(out.axes, out.eye);
    return out;
}

/// In perspective.
/// @param half_angle  [rad] below 90 degrees
MapCamera lamp_camera(const Bounds& bounds, dvec3 position, const MapAxes& axes, double half_angle,
                      const RenderSettings& settings) {
    MapCamera out{{}, axes, position};
    out.camera.vertical_fov_rad = 2 * math::atan2(math::tan(half_angle), inner_share(settings));
    out.camera.z_near = std::max(1e-6 * bounds.diagonal(), 1e-12);
    out.camera.z_far = std::numeric_limits<double>::infinity();
    out.camera.to_world = placed(axes, position);
    return out;
}

double half_angle_of(const Light& light) {
    const double angle = light.units == LightUnits::classical ? light.cutoff_rad : light.outer_cone_rad;
    return std::max(angle, radians(0.5));
}

bool has_one_map(const Light& light) {
    return light.type == LightType::directional ||
           (light.type == LightType::spot && half_angle_of(light) <= widest_spot);
}

void set_row(float (&to)[4], dvec3 axis, dvec3 from, dvec3 eye) {
    to[0] = float(axis.x), to[1] = float(axis.y), to[2] = float(axis.z);
    to[3] = float(dot(axis, eye - from));
}

}  // namespace

std::uint64_t shadow_map_count(const Light& light) { return !casts_shadow(light) ? 0 : has_one_map(light) ? 1 : 6; }

void check_shadow_memory(std::span<const Light> lights, const RenderSettings& settings, const MemoryBudget& memory) {
    if (!settings.shadows) return;
    std::uint64_t maps = 0;
    for (const Light& light : lights) maps += shadow_map_count(light);
    const std::uint64_t side = std::uint64_t(settings.shadow_size), bytes = maps * side * side * shadow_texel_bytes;
    const std::uint64_t all = memory.limit(), taken = memory.charged();
    const std::uint64_t limit = std::min(all / 2, all > taken ? all - taken : 0);
    if (bytes <= limit) return;
    throw Error(
        ErrorCode::usage,
        format_text("{} shadow maps of {} x {} texels need {} bytes, more than {}", maps, side, side, bytes, limit), {},
        "make them smaller, or raise 'max-memory'")
        .about("shadow-size", {"max-memory"});
}

bool has_shadow_maps(const DrawList& list, const RenderSettings& settings, Report& report) {
    if (!settings.shadows || list.draws.empty()) return false;
    if (list.bounds.diagonal() < 1e30) return true;
    report.add(Remark::warning, list.scene.source, {}, "the scene is too large for shadows");
    return false;
}

RenderSettings map_settings(int size) {
    RenderSettings s;
    s.width = s.height = size;
    s.cull = Cull::none;
    s.bump = Bump::none;
    return s;
}

std::vector<MapCamera> shadow_cameras(const DrawList& list, const Light& light, const RenderSettings& settings) {
    const LightPlace at = place_of(light, list.node_to_world);
    if (light.type == LightType::directional) return {directional_camera(list.bounds, at.direction, settings)};
    if (has_one_map(light))
        return {lamp_camera(list.bounds, at.position, axes_along(at.direction), half_angle_of(light), settings)};
    std::vector<MapCamera> out;
    for (const MapAxes& axes : cube)
        out.push_back(lamp_camera(list.bounds, at.position, axes, radians(45.0), settings));
    return out;
}

ShadowFactors shadow_factors(const MapCamera& first, const PictureCamera& view, std::size_t faces,
                             const RenderSettings& settings, dvec3 eye) {
    ShadowFactors out{};
    out.size = settings.shadow_size;
    out.faces = std::int32_t(faces);
    out.is_orthographic = view.orthographic;
    set_row(out.to_light[0], first.axes.x, first.eye, eye);
    set_row(out.to_light[1], first.axes.y, first.eye, eye);
    set_row(out.to_light[2], first.axes.z, first.eye, eye);
    if (faces == 6)  // the axes of the world: the text turns to the faces itself
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

}  // namespace rakelight::shading
