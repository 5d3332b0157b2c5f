// SPDX-License-Identifier: Apache-2.0
// How far rounding may have moved the places of a mesh: what the default weld distance is made of.
#pragma once
#include <vector>

#include "geometry/attribute_input.h"

namespace rakelight::geometry {

struct Box {
    dvec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    void add(dvec3 p) {
        low = min(low, p);
        high = max(high, p);
    }
    void add(const Box& other) {
        low = min(low, other.low);
        high = max(high, other.high);
    }
    double diagonal() const { return length(high - low); }
};

/// [m] in the world, [meshes]. Two objects meet where each has rounded the common place to floats in a frame of its
/// own: by the size of its local coordinates (far from a pivot that lies outside the model, little in the small parts
/// of a wide scene) and by that of the pivot itself. The pivot counts from the world's origin or from the center of the
/// box, whichever is nearer: a model that stands far away has parts that were placed beside one another by a common
/// parent. Where positions are quantized, half the diagonal of a step's cube if that is more.
std::vector<double> rounding_tolerances(const AttributeInput& input, const Box& box, Context& context);

}  // namespace rakelight::geometry
