// SPDX-License-Identifier: Apache-2.0
// The classes of surfaces by which weights of normals are judged.
#pragma once
#include <string>
#include <vector>

#include "tools/bench/normal_shapes.h"

namespace rakelight {

/// What a class is for.
enum class NormalKind { smooth, border, noise, hard };

struct NormalClass {
    std::string name;
    NormalKind kind = NormalKind::smooth;
    KnownSurface surface;
    std::vector<dvec3> corner_normals;  ///< [3 * triangles] exact
    std::vector<std::uint8_t> counts;   ///< [3 * triangles] whether a corner is judged
    double crease_angle_rad = pi;
};

/// @param seed  of the random surfaces and noise
std::vector<NormalClass> normal_classes(std::uint64_t seed);

}  // namespace rakelight
