// SPDX-License-Identifier: Apache-2.0
// Charts for a surface without texture coordinates: connected triangles facing one world axis, projected along it. Not
// mirrored seen from outside, v down.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

namespace rakelight::bake {

struct Charts {
    std::vector<std::uint32_t> of_triangle{};  ///< [T]
    std::vector<std::uint8_t> axis{};          ///< [charts] 0..5: +x, -x, +y, -y, +z, -z
    std::vector<dvec2> low{}, high{};          ///< [charts] [m] bounds of flattened()
};

/// The projection of a position along an axis of Charts.
dvec2 flattened(dvec3 place, std::uint8_t axis);

/// @param places [V] world space
/// @param triangles [3T] counter-clockwise from outside; triangles with two common vertices are connected
Charts find_charts(std::span<const dvec3> places, std::span<const std::uint32_t> triangles, Context& context);

}  // namespace rakelight::bake
