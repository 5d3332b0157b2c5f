// SPDX-License-Identifier: Apache-2.0
// Normals of a mesh in the world, for files that have no placements.
#pragma once
#include <cmath>

#include "math/linear.h"
#include "scene/is_normal.h"

namespace rakelight {

/// Transformed by the cofactor matrix, negated for mirroring matrices; unit. Under the identity, unit normals stay
/// bit-identical. One that is none (is_normal()) becomes zero.
class PlacedNormals {
public:
    explicit PlacedNormals(const dmat4& place)
        : turn_(cofactor(upper_left(place))),
          sign_(determinant(upper_left(place)) < 0 ? -1.0 : 1.0),
          is_identity_(upper_left(place) == upper_left(dmat4{})) {}
    vec3 operator()(vec3 normal) const {
        if (!is_normal(normal)) return {};
        const dvec3 n = cast<double>(normal);
        if (is_identity_ && std::fabs(dot(n, n) - 1) < 1e-6) return normal;
        return cast<float>(normalize_or(turn_ * n * sign_, dvec3{0, 0, 1}));
    }
    bool is_mirrored() const { return sign_ < 0; }

private:
    dmat3 turn_;
    double sign_;
    bool is_identity_;
};

}  // namespace rakelight
