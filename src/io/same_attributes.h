// SPDX-License-Identifier: Apache-2.0
// Whether recomputed normals and tangents equal those that a file already has.
#pragma once
#include <algorithm>
#include <cmath>

#include <rakelight/scene/scene.h>

namespace rakelight::io {

/// Two sums of the same terms in two orders, made unit and stored as float, differ by far less. [each number]
inline constexpr float rounding = 4e-6f;

inline bool is_near(float a, float b) { return std::fabs(a - b) <= rounding; }  // false for NaN
inline bool is_near(vec3 a, vec3 b) { return is_near(a.x, b.x) && is_near(a.y, b.y) && is_near(a.z, b.z); }

inline bool same_corners(const Mesh& a, const Mesh& b) {
    return a.positions.size() == b.positions.size() &&
           (a.indices == b.indices ||
            std::equal(a.indices.begin(), a.indices.end(), b.indices.begin(), b.indices.end()));
}

}  // namespace rakelight::io
