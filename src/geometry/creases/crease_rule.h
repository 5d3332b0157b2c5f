// SPDX-License-Identifier: Apache-2.0
// The rule of automatic creases: one decision for each edge.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/creases/bent_edges.h"
#include "geometry/creases/plane_widths.h"

namespace rakelight::geometry {

/// [degrees] Thresholds move by so much at most, into gaps between the bends of the model.
constexpr double thresholds_move_deg = 2;

/// Why an edge is hard or soft.
enum class CreaseReason : std::uint8_t {
    plane,      ///< soft: in one plane, or a small bend
    steep,      ///< hard: a large bend
    fan,        ///< single triangles of equal bends: hard if these are large and the surface is small
    triangles,  ///< soft: single triangles
    tangent,    ///< soft: a plane runs into a fillet
    chamfer,    ///< hard: two equal bends
    chain,      ///< three or more equal bends: hard over `round_most_deg`
    loose,      ///< bends of one order, planes of similar widths
    planes,     ///< hard: two planes
};

struct CreaseDecision {
    CreaseReason reason = CreaseReason::plane;
    bool is_hard = false;
};

/// [edges]
std::vector<CreaseDecision> apply_crease_rule(const BentEdges& bent, const AttributeInput& input,
                                              const std::vector<PlaneSide>& widths, Context& context);

}  // namespace rakelight::geometry
