// SPDX-License-Identifier: Apache-2.0
// Splits groups of vertices into the groups that the join rules leave, and appends a vertex where the corners of one differ.
#pragma once
#include "geometry/join_rules.h"

namespace rakelight::geometry {

/// @param selected  [output vertices] which groups to look at; empty: all
/// A degenerate face follows the first voting face of its vertex (else of its mesh there, else of its place), so it never splits
/// anything; a vertex that no face uses follows the first of its place.
void refine_groups(Topology& topology, const AttributeInput& input, const AttributeOptions& options, JoinRule rule,
                   const std::vector<dvec3>& normals, const std::vector<std::uint8_t>& selected, Context& context);

}  // namespace rakelight::geometry
