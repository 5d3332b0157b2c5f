// SPDX-License-Identifier: Apache-2.0
// The width of a plane across each of its edges, and the edge at its far side.
#pragma once
#include <vector>

#include "geometry/creases/bent_edges.h"

namespace rakelight::geometry {

constexpr double equal_bends = 0.15;    ///< of a bend: bends that differ by less count as equal
constexpr double parallel_edges = 0.8;  ///< cosine of 37 degrees: edges that are nearly parallel

/// One plane seen from one of its edges.
struct PlaneSide {
    float width = 0;              ///< [m] largest distance of a corner of the plane from the line of the edge
    std::uint32_t far = no_edge;  ///< the farthest edge that is nearly parallel
};

/// [2 * edges] Entry 2 * e + s: the plane of side s of edge e. Only edges between different planes have values.
std::vector<PlaneSide> plane_widths(const BentEdges& bent, const AttributeInput& input, Context& context);

}  // namespace rakelight::geometry
