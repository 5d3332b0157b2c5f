// SPDX-License-Identifier: Apache-2.0
// Rounding errors of the positions of a mesh, from which the default weld distance follows.
#pragma once
#include <vector>

#include "geometry/input/attribute_input.h"

namespace rakelight::geometry {

/// In world space; low > high: of no point.
struct WorldBox {
    dvec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    void add(dvec3 p) {
        low = min(low, p);
        high = max(high, p);
    }
    void add(const WorldBox& other) {
        low = min(low, other.low);
        high = max(high, other.high);
    }
    double diagonal() const { return length(high - low); }
};

/// [meshes] [m] world space. Two objects meet at a place that each has rounded to floats in its own frame. The error
/// depends on the size of local coordinates and on the distance of the pivot. That distance counts from the world
/// origin or the center of the box, whichever is nearer: parts of a far model are usually placed by a common parent.
/// For quantized positions it is at least half the diagonal of a step's cube.
std::vector<double> rounding_tolerances(const AttributeInput& input, const WorldBox& box, Context& context);

}  // namespace rakelight::geometry
