// SPDX-License-Identifier: Apache-2.0
// Charts of a surface that has no texture coordinates: connected triangles that look along one axis of the world, each flattened
// along it. Unmirrored as seen from outside, v down.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/vector.h>

namespace rakelight::bake {

struct Charts {
    std::vector<std::uint32_t> of_triangle{};  ///< [T]
    std::vector<std::uint8_t> axis{};          ///< [charts] 0..5: +x, -x, +y, -y, +z, -z
    std::vector<dvec2> low{}, high{};          ///< [charts] [m] bounds of flattened()
};

/// A place along an axis of Charts.
dvec2 flattened(dvec3 place, std::uint8_t axis);

/// @param places     [V] in the world
/// @param triangles  [3T] counter-clockwise from outside; triangles are connected where they share two vertices
Charts find_charts(std::span<const dvec3> places, std::span<const std::uint32_t> triangles, Context& context);

}  // namespace rakelight::bake
