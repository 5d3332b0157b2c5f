// SPDX-License-Identifier: Apache-2.0
// Corners of facets as the vertices of a mesh: corners that are equal to the last bit become one.
#pragma once
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

#include "base/hash_key.h"

namespace rakelight::io::stl {

/// Compared by bits: 0 and -0 are two positions, and equal NaNs are one.
struct Corner {
    std::uint32_t x = 0, y = 0, z = 0;  ///< bits of floats
    std::uint32_t color = 0;            ///< of the facet, in the form of the file; 0: none of its own
    Corner() = default;
    explicit Corner(vec3 p, std::uint32_t facet_color = 0)
        : x(std::bit_cast<std::uint32_t>(p.x)),
          y(std::bit_cast<std::uint32_t>(p.y)),
          z(std::bit_cast<std::uint32_t>(p.z)),
          color(facet_color) {}
    vec3 position() const { return {std::bit_cast<float>(x), std::bit_cast<float>(y), std::bit_cast<float>(z)}; }
    bool operator==(const Corner&) const = default;
};

inline std::uint64_t hash_of(const Corner& c, HashKey key) {
    return folded_product((std::uint64_t(c.x) << 32 | c.y) ^ key.a, (std::uint64_t(c.z) << 32 | c.color) ^ key.b);
}

struct JoinedCorners {
    std::vector<Corner> vertices;        ///< each once, in order of first use
    std::vector<std::uint32_t> indices;  ///< [corners]
    MemoryCharge charge;                 ///< of both
};

/// Corners first, first + 1 ... of the file; `first` is a multiple of 3. Called from several threads.
using ReadCorners = std::function<void(std::size_t first, std::span<Corner> out)>;

/// @param count  of corners, which the file has room for
/// @throws Error bad_file: over the memory limit, more than 2^32 - 2 corners
JoinedCorners join_corners(std::uint64_t count, const ReadCorners& read, Context& context);

}  // namespace rakelight::io::stl
