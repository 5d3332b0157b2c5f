// SPDX-License-Identifier: Apache-2.0
#include "image/maps/normal_map_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/color.h"

namespace rakelight {
namespace {

constexpr std::size_t texels_wanted = 40'000;

struct Normal {
    double x, y, z;
};

Normal decode(std::uint32_t t) {
    const auto at = [t](int shift) { return 2.0 * double(t >> shift & 255u) / 255 - 1; };
    return {at(0), at(8), at(16)};
}

double length_error(Normal n) { return std::fabs(std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z) - 1); }

/// The vector after decoding its codes as sRGB.
Normal decode_srgb(std::uint32_t t) {
    const auto at = [t](int shift) { return 2.0 * double(linear_from_srgb8(std::uint8_t(t >> shift & 255u))) - 1; };
    return {at(0), at(8), at(16)};
}

/// Of red, green and blue, [codes].
double spread(std::uint32_t t) {
    const std::uint32_t r = t & 255u, g = t >> 8 & 255u, b = t >> 16 & 255u;
    return double(std::max({r, g, b}) - std::min({r, g, b}));
}

struct Sums {
    double errors = 0, srgb_errors = 0, xy = 0, z = 0, spread = 0;
    std::size_t count = 0;
};

void add_row(const std::uint32_t* row, int width, Sums& s) {
    for (int x = 1; x + 1 < width; ++x) {
        s.errors += length_error(decode(row[x]));
        s.xy += 0.5 * (decode(row[x]).x + decode(row[x]).y);
        s.z += decode(row[x]).z;
        s.spread += spread(row[x]);
        s.srgb_errors += length_error(decode_srgb(row[x]));
        ++s.count;
    }
}

}  // namespace

NormalMapCheck check_normal_map(std::span<const std::uint32_t> texels, int width, int height, int stride) {
    NormalMapCheck out;
    if (width < 3 || height < 3) return out;
    out.texels = std::uint64_t(width) * std::uint64_t(height);
    for (int y = 0; y < height; ++y) {
        const std::uint32_t* const row = texels.data() + std::size_t(y) * std::size_t(stride);
        out.below +=
            std::uint64_t(std::count_if(row, row + width, [](std::uint32_t t) { return (t & 0x00800000u) == 0; }));
    }
    const int rows = height - 2, wanted = std::clamp(int(texels_wanted / std::size_t(width)), 1, rows);
    Sums s;
    for (int i = 0; i < wanted; ++i) {
        const auto y = 1 + std::size_t(i) * std::size_t(rows) / std::size_t(wanted);
        add_row(texels.data() + y * std::size_t(stride), width, s);
    }
    const double count = double(s.count);
    out.green = find_green_direction(texels, width, height, stride);
    out.length_error = s.errors / count;
    out.mean_xy = s.xy / count;
    out.mean_z = s.z / count;
    out.mean_spread = s.spread / count;
    out.srgb_length_error = s.srgb_errors / count;
    return out;
}

}  // namespace rakelight
