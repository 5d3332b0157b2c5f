// SPDX-License-Identifier: Apache-2.0
// The random numbers of paths: Sobol points whose digits are scrambled by pixel, so that no number depends on its neighbors,
// on the window or on the thread.
#pragma once
#include <array>
#include <cstdint>

namespace rakelight::raytrace {

/// Four numbers at a time. Over the samples of a pixel each four are a scrambled Sobol sequence (Sobol 1967; directions of Joe & Kuo
/// 2008), scrambled after Owen 1995; fours of different `group` are shuffled against each other. Both by the hash of Burley 2020,
/// "Practical Hash-based Owen Scrambling", sections 3 and 4.
class PathNumbers {
public:
    /// @param x, y  pixel of the whole picture
    PathNumbers(int x, int y, int seed);
    /// @param sample  of the pixel, from 0
    /// @param group   of four dimensions
    /// @return 32 bits each: times 2^-32 a number in [0, 1)
    std::array<std::uint32_t, 4> of(std::uint32_t sample, std::uint32_t group) const;

private:
    std::uint32_t pixel_;
};

/// [0, 1), the upper 24 bits.
inline float unit_float(std::uint32_t bits) { return float(bits >> 8) * 0x1p-24f; }
inline double unit_double(std::uint32_t bits) { return double(bits) * 0x1p-32; }

}  // namespace rakelight::raytrace
