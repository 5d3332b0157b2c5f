// SPDX-License-Identifier: Apache-2.0
// Corner weights of a face, selected at run time.
#pragma once
#include "geometry/input/face_vote.h"

namespace rakelight::geometry {

constexpr bool is_fitted(CornerWeight weight) {
    return weight == CornerWeight::fit || weight == CornerWeight::automatic;
}

/// The weight of the sums that fits begin from, for those that are fits: CornerWeight::fit, automatic.
constexpr CornerWeight sum_weight(CornerWeight weight) { return is_fitted(weight) ? CornerWeight::max : weight; }

/// Those of sum_weight().
/// @param area2 twice the area of the face in world space
inline dvec3 corner_weights(CornerWeight weight, const Placement& placement, const FaceCorners& face, double area2) {
    switch (weight) {
        case CornerWeight::uniform:
            return corner_weights<CornerWeight::uniform>(placement, face, area2);
        case CornerWeight::area:
            return corner_weights<CornerWeight::area>(placement, face, area2);
        case CornerWeight::angle:
            return corner_weights<CornerWeight::angle>(placement, face, area2);
        case CornerWeight::angle_area:
            return corner_weights<CornerWeight::angle_area>(placement, face, area2);
        case CornerWeight::max:
        case CornerWeight::fit:
        case CornerWeight::automatic:
            break;
    }
    return corner_weights<CornerWeight::max>(placement, face, area2);
}

}  // namespace rakelight::geometry
