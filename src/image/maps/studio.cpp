// SPDX-License-Identifier: Apache-2.0
// The built-in environment: soft boxes in a gray room, by formula.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "image/maps/environment.h"
#include "math/linear.h"

namespace rakelight {
namespace {

/// A rectangular area light on a plane at distance 1, facing the middle of the room.
struct SoftBox {
    SoftBox(dvec3 toward, dvec2 half, double softness_of_edges, double light)
        : n(normalize_or(toward, {0, 1, 0})),
          right(normalize_or(cross(dvec3{0, 1, 1e-3}, n), {1, 0, 0})),
          up(cross(n, right)),
          half_width(half.x),
          half_height(half.y),
          softness(softness_of_edges),
          radiance(light) {}
    dvec3 n, right, up;              ///< unit: from the middle of the room to the box's center, and its horizontal axis
    double half_width, half_height;  ///< [1] on that plane
    double softness;                 ///< [1] half width of the soft edge
    double radiance;
};

/// Smoothstep from -1 to 1.
double smooth_step(double x) {
    const double t = std::clamp(0.5 + 0.5 * x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double radiance_of(const SoftBox& box, dvec3 d) {
    const double along = dot(d, box.n);
    if (!(along > 1e-3)) return 0;
    const double x = std::abs(dot(d, box.right)) / along, y = std::abs(dot(d, box.up)) / along;
    return box.radiance * smooth_step((box.half_width - x) / box.softness) *
           smooth_step((box.half_height - y) / box.softness);
}

}  // namespace

double studio_radiance(dvec3 d) {
    // A white surface facing the key light receives about 1.
    static const SoftBox boxes[] = {
        {{-0.8, 0.75, 0.9}, {0.5, 0.4}, 0.1, 3.2},     // key
        {{1.0, 0.25, 0.6}, {0.35, 0.55}, 0.15, 1.0},   // fill
        {{0.35, 0.55, -1.0}, {0.9, 0.10}, 0.06, 3.6},  // strip behind
        {{0.0, 1.0, -0.05}, {0.6, 0.3}, 0.2, 1.1},     // ceiling
    };
    const double ceiling = 0.27, horizon = 0.32, floor = 0.11;  // walls slightly brighter than the ceiling
    double sum =
        d.y > 0 ? horizon + (ceiling - horizon) * d.y : horizon + (floor - horizon) * smooth_step(-6 * d.y - 1);
    for (const SoftBox& box : boxes) sum += radiance_of(box, d);
    return sum;
}

Pixels studio_panorama() {
    Pixels out{.width = 512, .height = 256, .channels = 1, .component = Component::f32, .is_linear = true};
    out.bytes.resize(out.row_bytes() * std::size_t(out.height));
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const dvec3 d = equirectangular_direction((x + 0.5) / out.width, (y + 0.5) / out.height);
            const float radiance = float(studio_radiance(d));
            std::memcpy(out.row(y) + std::size_t(x) * sizeof radiance, &radiance, sizeof radiance);
        }
    return out;
}

}  // namespace rakelight
