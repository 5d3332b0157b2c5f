// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/light_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rakelight::shading {
namespace {

/// Room for rounding of positions and distances in the kernels: [1] of the range, [1] of the light's distance.
constexpr float range_margin = 1e-3f, distance_margin = 1e-5f;

/// A plane with the square's pixels on its positive side.
struct SidePlane {
    float nx, ny, nz, offset;
};

/// Through two corners of a square, in the order in which the third stays on the positive side.
SidePlane side_plane(const PictureCamera& view, dvec3 a, dvec3 b, dvec3 inside) {
    const dvec3 along = view.orthographic ? view.camera_to_world[2].xyz() : a;
    dvec3 n = normalize_or(cross(along, b - a), dvec3{});
    const dvec3 at = view.orthographic ? a : dvec3{};
    if (dot(n, inside - at) < 0) n = -n;
    return {float(n.x), float(n.y), float(n.z), float(-dot(n, at))};
}

}  // namespace

LightReach::LightReach(const std::vector<lighting::LightParameters>& lights) : lights_(lights) {
    for (const lighting::LightParameters& light : lights) {
        const bool has_place = light.kind == lighting::LightKind::point || light.kind == lighting::LightKind::spot;
        const bool ends = has_place && light.inverse_range > 0;
        const float x = light.position[0], y = light.position[1], z = light.position[2];
        x_.push_back(x), y_.push_back(y), z_.push_back(z);
        radius_.push_back(ends ? (1 + range_margin) / light.inverse_range +
                                     distance_margin * (std::fabs(x) + std::fabs(y) + std::fabs(z))
                               : std::numeric_limits<float>::infinity());
        ending_ += ends;
    }
}

void LightReach::in_square(const PictureCamera& view, int left, int top, int size,
                           std::vector<std::uint32_t>& to) const {
    const PixelRays rays = pixel_rays(view, left, top);
    const double low = -2, high = size + 1;  // a pixel of margin: samples lie about the centers
    const dvec3 corner[4] = {rays.at(low, low), rays.at(high, low), rays.at(high, high), rays.at(low, high)};
    const dvec3 middle = rays.at((low + high) / 2, (low + high) / 2);
    SidePlane side[4];
    for (std::size_t k = 0; k < 4; ++k) side[k] = side_plane(view, corner[k], corner[(k + 1) % 4], middle);
    to.clear();
    for (std::size_t i = 0; i < radius_.size(); ++i) {
        bool reaches = true;
        for (const SidePlane& s : side)
            reaches = reaches && !(s.nx * x_[i] + s.ny * y_[i] + s.nz * z_[i] + s.offset < -radius_[i]);
        if (reaches) to.push_back(std::uint32_t(i));
    }
}

bool LightReach::touches(const LightBox& box, std::size_t i) const {
    const float at[3] = {x_[i], y_[i], z_[i]};
    float squared = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const float outside = std::max({box.low[c] - at[c], at[c] - box.high[c], 0.0f});
        squared += outside * outside;
    }
    return !(squared > radius_[i] * radius_[i]);
}

void LightReach::in_box(const LightBox& box, const std::vector<std::uint32_t>* among,
                        std::vector<lighting::LightParameters>& to) const {
    to.clear();
    const std::size_t count = among ? among->size() : lights_.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = among ? (*among)[k] : k;
        if (touches(box, i)) to.push_back(lights_[i]);
    }
}

}  // namespace rakelight::shading
