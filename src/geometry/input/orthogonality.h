// SPDX-License-Identifier: Apache-2.0
// How far tangents are from perpendicular to their normals.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <rakelight/geometry/attributes.h>

#include "math/functions.h"
#include "math/linear.h"

namespace rakelight::geometry {

inline dvec3 times_transposed(const dmat3& m, dvec3 v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

/// [degrees] 0..90 between a unit vector and the plane of a unit normal.
inline double skew_deg(dvec3 normal, dvec3 tangent) {
    return 90 - degrees(math::acos(std::min(1.0, std::fabs(dot(normal, tangent)))));
}

struct OrthogonalityLoss {
    double most = 0, sum = 0;
    std::uint64_t count = 0;

    void add(double skew) {
        most = std::max(most, skew);
        sum += skew;
        ++count;
    }
    void tell(MeshAttributes& out) const {
        out.orthogonality_loss_max_deg = most;
        out.orthogonality_loss_mean_deg = count > 0 ? sum / double(count) : 0;
    }
};

}  // namespace rakelight::geometry
