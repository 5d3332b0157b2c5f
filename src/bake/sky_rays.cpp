// SPDX-License-Identifier: Apache-2.0
#include "bake/sky_rays.h"

#include <algorithm>
#include <cmath>

#include "bake/low/tangent_frame.h"
#include "math/functions.h"

namespace rakelight::bake {
namespace {

constexpr double offset = 1e-5;  ///< of HIGH's diagonal: how far above the triangle rays start

/// Steele et al. 2014, "Fast Splittable Pseudorandom Number Generators": the output of SplitMix64. 0..1, 1 exclusive.
double random(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    z ^= z >> 31;
    return double(z >> 11) * 0x1p-53;
}

}  // namespace

double open_sky(const HighSurface& high, const HighPoint& point, int side, double reach, std::uint64_t seed) {
    const TangentFrame frame = unit_frame(point.normal, dvec3{1, 0, 0}, 1);
    const dvec3 from = point.place + point.face * (offset * high.diagonal());
    const std::uint64_t first = seed * (2ull * std::uint64_t(side) * std::uint64_t(side));
    int open = 0, all = 0;
    for (int i = 0; i < side * side; ++i) {
        const std::uint64_t number = first + 2ull * std::uint64_t(i);
        const double square = (i / side + random(number)) / side, turn = (i % side + random(number + 1)) / side;
        const double radius = std::sqrt(square), angle = 2 * pi * turn;
        const dvec3 direction = frame.tangent * (radius * math::cos(angle)) +
                                frame.bitangent * (radius * math::sin(angle)) +
                                frame.normal * std::sqrt(std::max(0.0, 1 - square));
        if (dot(direction, point.face) <= 0) continue;
        ++all;
        open += !high.is_blocked(from, from + direction * reach);
    }
    return all > 0 ? double(open) / all : 1;
}

}  // namespace rakelight::bake
