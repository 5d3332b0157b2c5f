// SPDX-License-Identifier: Apache-2.0
// The seven primitive modes of glTF as lists of triangles, lines or points (glTF 2.0 specification, section 3.7.2.1).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/scene/scene.h>

namespace rakelight::io::gltf {

/// The values are glTF's `mode`.
enum class PrimitiveMode : std::uint8_t {
    points,
    lines,
    line_loop,
    line_strip,
    triangles,
    triangle_strip,
    triangle_fan
};

Topology topology_of(PrimitiveMode mode);

/// How many indices `corners` corners become. No overflow for corners < 2^61.
std::uint64_t expanded_size(PrimitiveMode mode, std::uint64_t corners);

/// Indices as a list: strips and fans become triangles of the winding that the specification gives, loops and strips of
/// lines become pairs. Corners that are left over (a triangle list of 7) are dropped; `left_over` says how many.
/// Empty where there are too few corners for one primitive.
struct Expanded {
    std::vector<std::uint32_t> indices;
    std::uint64_t left_over = 0;
};
Expanded expand(PrimitiveMode mode, std::vector<std::uint32_t> corners);

}  // namespace rakelight::io::gltf
