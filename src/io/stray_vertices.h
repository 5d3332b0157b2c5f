// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include <rakelight/math/vector.h>

namespace rakelight::io {

/// Some vertices are a million times farther out than half of the others: what a flipped bit in an exponent looks like.
bool has_stray_vertices(std::span<const vec3> positions);
inline constexpr const char* stray_vertices_text =
    "some vertices lie a million times farther out than half of the others; the file is probably damaged";

}  // namespace rakelight::io
