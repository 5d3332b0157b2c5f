// SPDX-License-Identifier: Apache-2.0
#include <rakelight/image/colormap.h>

#include <algorithm>
#include <span>

#include "math/color.h"

namespace rakelight {
namespace {

// Display colors 0xrrggbb at equal steps, interpolated linearly in display values. The error against the original 256
// colors is at most 5 of 255 (turbo 12).

// Nathaniel J. Smith and Stefan van der Walt 2015 (CC0).
constexpr std::uint32_t viridis[] = {0x440154, 0x481769, 0x472a7a, 0x433d84, 0x3d4e8a, 0x355e8d,
                                     0x2e6d8e, 0x297b8e, 0x23898e, 0x1f978b, 0x21a585, 0x2eb37c,
                                     0x46c06f, 0x65cb5e, 0x89d548, 0xb0dd2f, 0xd8e219, 0xfde725};
constexpr std::uint32_t magma[] = {0x000004, 0x090720, 0x1a1042, 0x311165, 0x4a1079, 0x621980,
                                   0x792282, 0x912b81, 0xaa337d, 0xc23b75, 0xd9466b, 0xec5860,
                                   0xf7725c, 0xfc8e64, 0xfeaa74, 0xfec68a, 0xfde2a3, 0xfcfdbf};
constexpr std::uint32_t inferno[] = {0x000004, 0x0a0722, 0x1e0c45, 0x380962, 0x510e6c, 0x69166e,
                                     0x801f6c, 0x982766, 0xb0315b, 0xc63d4d, 0xd94d3d, 0xe9612b,
                                     0xf47918, 0xfa9407, 0xfcb014, 0xf8cd37, 0xf2ea69, 0xfcffa4};
constexpr std::uint32_t plasma[] = {0x0d0887, 0x2f0596, 0x4903a0, 0x6100a7, 0x7801a8, 0x8e0ca4,
                                    0xa21d9a, 0xb42e8d, 0xc43e7f, 0xd24f71, 0xde6164, 0xe97257,
                                    0xf3854b, 0xf99a3e, 0xfdaf31, 0xfdc627, 0xf8df25, 0xf0f921};
// Anton Mikhailov 2019, "Turbo, An Improved Rainbow Colormap for Visualization", by the polynomials given there.
constexpr std::uint32_t turbo[] = {0x23171b, 0x493ca8, 0x4664ea, 0x368df9, 0x28b4e8, 0x26d4c8,
                                   0x35eca1, 0x54fa7d, 0x7efd5d, 0xacf546, 0xd7e235, 0xf7c52a,
                                   0xffa022, 0xff781c, 0xea4f14, 0xc62a0b, 0xa11202, 0x900c00};
// Kenneth Moreland 2009, "Diverging Color Maps for Scientific Visualization", by its equations from (59, 76, 192) to (180, 4, 38).
constexpr std::uint32_t coolwarm[] = {0x3b4cc0, 0x4e68d7, 0x6282ea, 0x779af7, 0x8db0fe, 0xa3c2ff,
                                      0xb8d0f9, 0xccd9ee, 0xdddddd, 0xecd3c6, 0xf5c4ad, 0xf7b194,
                                      0xf49a7b, 0xec7f63, 0xde614c, 0xcb3e38, 0xb40426};
constexpr std::uint32_t gray[] = {0x000000, 0xffffff};

std::span<const std::uint32_t> stops_of(ColorMap map) {
    switch (map) {
        case ColorMap::viridis:
            return viridis;
        case ColorMap::magma:
            return magma;
        case ColorMap::inferno:
            return inferno;
        case ColorMap::plasma:
            return plasma;
        case ColorMap::turbo:
            return turbo;
        case ColorMap::coolwarm:
            return coolwarm;
        case ColorMap::gray:
            return gray;
    }
    return gray;
}

}  // namespace

vec3 color_of(ColorMap map, double t) {
    if (!(t == t)) return linear_from_srgb(vec3{0.5f, 0.5f, 0.5f});
    const std::span<const std::uint32_t> stops = stops_of(map);
    const double at = std::clamp(t, 0.0, 1.0) * double(stops.size() - 1);
    const std::size_t below = std::min(std::size_t(at), stops.size() - 2);
    const double part = at - double(below);
    const auto component = [&](int shift) {
        const double low = double(stops[below] >> shift & 0xffu), high = double(stops[below + 1] >> shift & 0xffu);
        return float((low + (high - low) * part) / 255);
    };
    return linear_from_srgb(vec3{component(16), component(8), component(0)});
}

}  // namespace rakelight
