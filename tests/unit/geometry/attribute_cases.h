// SPDX-License-Identifier: Apache-2.0
// What the tests of the table of hard cases share.
#pragma once
#include <gtest/gtest.h>

#include <utility>

#include "unit/geometry/shapes.h"

namespace rakelight::test {

inline Shape triangle(vec3 a, vec3 b, vec3 c, std::uint32_t object = 0) {
    Shape s;
    s.positions = {a, b, c};
    s.indices = {0, 1, 2};
    s.object = object;
    return s;
}

/// Faces +Z; u to +X, v downwards in the picture.
inline Shape quad() {
    Shape s;
    s.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    s.indices = {0, 1, 2, 0, 2, 3};
    s.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    return s;
}

inline AttributeOptions crease(double deg) {
    AttributeOptions options;
    options.crease_angle_rad = radians(deg);
    return options;
}

inline constexpr TangentMode all_modes[] = {TangentMode::averaged, TangentMode::published, TangentMode::mikktspace};

inline void expect_finite(const MeshAttributes& out) {
    for (const vec3 n : out.normals) EXPECT_NEAR(length(cast<double>(n)), 1, 1e-6);
    for (const vec4 t : out.tangents) {
        EXPECT_NEAR(length(cast<double>(t.xyz())), 1, 1e-6);
        EXPECT_EQ(std::fabs(t.w), 1.0f);
    }
    for (const vec3 b : out.bitangents) EXPECT_NEAR(length(cast<double>(b)), 1, 1e-6);
}

inline Shape inside_out(Shape s) {
    for (std::size_t i = 0; i < s.indices.size(); i += 3) std::swap(s.indices[i + 1], s.indices[i + 2]);
    return s;
}

}  // namespace rakelight::test
