// SPDX-License-Identifier: Apache-2.0
#include "radiosity/sky_light.h"

#include <algorithm>
#include <cmath>

#include "image/maps/environment.h"
#include "image/maps/mip_chain.h"
#include "math/functions.h"
#include "math/linear.h"
#include "shading/environment.h"
#include "shading/lights/environment_axes.h"

namespace rakelight::radiosity {
namespace {

constexpr int rings = 8, spokes = 8;
constexpr int widest = 128;  ///< [texels] resolution for finding suns
constexpr int coarse_width =
    16;  ///< [texels] resolution for sampled directions, similar to their number per hemisphere

/// Cosine-weighted directions about +Z: centers of equal parts of the disc (Malley's method).
std::array<dvec3, rings * spokes> directions() {
    std::array<dvec3, rings * spokes> out;
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < spokes; ++s) {
            const double squared = (r + 0.5) / rings, radius = std::sqrt(squared);
            const double angle = 2 * pi * (s + double(r) / rings) / spokes;
            out[std::size_t(r * spokes + s)] = {radius * math::cos(angle), radius * math::sin(angle),
                                                std::sqrt(1 - squared)};
        }
    return out;
}

}  // namespace

SkyLight::SkyLight(const Scene& scene, const raytrace::SurfaceRays& rays, double gap, double far_away, Context& context)
    : rays_(rays), gap_(gap), far_away_(far_away) {
    if (!scene.environment || !scene.environment->is_light || !(scene.environment->intensity > 0)) return;
    axes_ = shading::environment_axes(*scene.environment);
    try {
        take_map(scene, context);
    } catch (const Error& error) {
        context.throw_if_cancelled();
        context.report().add(Remark::warning, scene.source, "", "environment left out: " + error.reason());
    }
}

void SkyLight::take_map(const Scene& scene, Context& context) {
    const MipChain chain = shading::sky_of(*scene.environment, context);
    if (chain.levels.empty()) return;
    const auto is_small = [](const MipLevel& level) { return level.width <= widest; };
    const MipLevel& level = *std::ranges::find_if(chain.levels, is_small);
    SkyMap sky{level.width, level.height};
    for (std::size_t i = 0; i < std::size_t(level.width) * std::size_t(level.height); ++i)
        sky.texels.push_back(cast<double>(linear_texel(chain, level, i)) * double(scene.environment->intensity));
    for (const SkySun& sun : take_suns(sky)) {
        const vec3 way = -cast<float>(axes_[0] * sun.direction.x + axes_[1] * sun.direction.y +
                                      axes_[2] * sun.direction.z),
                   light = cast<float>(sun.irradiance / pi);
        lighting::LightParameters p{.kind = lighting::LightKind::directional};
        for (std::size_t k = 0; k < 3; ++k) p.direction[k] = way[k], p.diffuse[k] = light[k];
        suns_.push_back(p);
    }
    sky_ = shrunk(sky, std::min(sky.width, coarse_width), std::min(sky.height, coarse_width / 2));
}

dvec3 SkyLight::radiance(dvec3 d) const {
    const dvec2 uv = equirectangular({dot(axes_[0], d), dot(axes_[1], d), dot(axes_[2], d)});
    const int x = std::clamp(int(uv.x * sky_.width), 0, sky_.width - 1),
              y = std::clamp(int(uv.y * sky_.height), 0, sky_.height - 1);
    return sky_.texels[std::size_t(y) * std::size_t(sky_.width) + std::size_t(x)];
}

dvec3 SkyLight::operator()(const Receiver& r) const {
    if (empty()) return {};
    static const std::array<dvec3, rings* spokes> over = directions();
    const dvec3 u =
        normalize_or(cross(std::fabs(r.normal.y) < 0.7 ? dvec3{0, 1, 0} : dvec3{1, 0, 0}, r.normal), dvec3{1, 0, 0});
    const dvec3 v = cross(r.normal, u), start = r.at + r.face_normal * gap_;
    dvec3 sum{};
    for (const dvec3 d : over) {
        const dvec3 way = normalize_or(u * d.x + v * d.y + r.normal * d.z, r.normal);
        if (dot(way, r.face_normal) > 0 && !rays_.is_blocked(start, start + way * far_away_, 1e-5))
            sum += radiance(way);
    }
    return sum / double(over.size());
}

}  // namespace rakelight::radiosity
