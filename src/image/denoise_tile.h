// SPDX-License-Identifier: Apache-2.0
// Data of the denoiser's kernel: a rectangle of the picture as planes with a margin. Plain types, because the kernel is
// compiled per instruction set.
#pragma once
#include <stdint.h>

namespace rakelight::denoise {

inline constexpr int search_radius = 10, patch_radius = 2, variance_radius = 2, firefly_radius = 2;  // [px]
inline constexpr int margin = search_radius + patch_radius + variance_radius + firefly_radius;       // [px]
inline constexpr int tile_width = 64, tile_height = 64;  // [px] of the result; the planes fit the L2 cache
inline constexpr int max_lanes = 16;                     // padding floats per row, read but unused
inline constexpr int stride = tile_width + 2 * margin + max_lanes;
inline constexpr int plane_floats = stride * (tile_height + 2 * margin);

/// Bandwidths of the features; planes are divided by these.
inline constexpr float normal_bandwidth = 0.3f, albedo_bandwidth = 0.5f;

/// Pixel (x, y) of the result is at (y + margin) * stride + x + margin of each plane. Outside of the picture: 0.
struct Tile {
    int32_t width, height;      ///< [px] of the result
    float valid[plane_floats];  ///< 1: inside the picture and not excluded; else 0
    float light[3][plane_floats], variance[3][plane_floats];
    float normal[3][plane_floats], albedo[3][plane_floats], position[3][plane_floats];
    float smooth_variance[3][plane_floats];  ///< computed by the kernel, as the following
    float sum[4][tile_height * tile_width];  ///< of weight * light, and of weights
    float distances[(tile_height + 2 * patch_radius) * stride];
};

// Each: sums of the neighbors of all pixels of the result.
namespace scalar {
void sum_neighbors(Tile& tile);
}
namespace sse2 {
void sum_neighbors(Tile& tile);
}
namespace avx2 {
void sum_neighbors(Tile& tile);
}
namespace avx512 {
void sum_neighbors(Tile& tile);
}

}  // namespace rakelight::denoise
