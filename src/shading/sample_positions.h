// SPDX-License-Identifier: Apache-2.0
// Where the samples of a pixel lie in multisampled pictures.
#pragma once
#include <array>
#include <cstddef>
#include <span>

#include <rakelight/math/vector.h>

namespace rakelight::shading {

inline constexpr int most_samples = 8;

/// [1/16 px] from the pixel's center, x to the right, y down.
struct SamplePosition {
    int x, y;
};
inline constexpr int fixed_per_position = 16;  ///< [1/256 px] a step of SamplePosition

/// The standard patterns of 4 and 8 samples: Vulkan specification, "Multisampling", table of standard sample locations;
/// Direct3D 11.1, D3D11_STANDARD_MULTISAMPLE_PATTERN. No two samples share a row or a column; their mean is the center.
inline constexpr std::array<SamplePosition, 4> positions_of_4 = {{{-2, -6}, {6, -2}, {-6, 2}, {2, 6}}};
inline constexpr std::array<SamplePosition, 8> positions_of_8 = {
    {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}}};
inline constexpr std::array<SamplePosition, 1> positions_of_1 = {{{0, 0}}};

/// @param samples  1, 4 or 8
inline std::span<const SamplePosition> sample_positions(int samples) {
    if (samples == 8) return positions_of_8;
    if (samples == 4) return positions_of_4;
    return positions_of_1;
}

/// The mean of n samples' linear colors, each by its alpha: a pixel. Of equal ones it is the color itself, to the bit.
vec4 mean_of_samples(const vec4* colors, std::size_t n);

/// [1/256 px] how far samples are from the center at most, to each side.
inline int sample_reach(int samples) { return samples == 8 ? 7 * 16 : samples == 4 ? 6 * 16 : 0; }

}  // namespace rakelight::shading
