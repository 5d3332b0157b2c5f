// SPDX-License-Identifier: Apache-2.0
// Splits groups of vertices into the groups that the join rules leave, and appends a vertex where the corners of one differ.
#pragma once
#include "geometry/groups/join_rules.h"

namespace rakelight::geometry {

/// A degenerate face follows the first voting face of its vertex (else of its mesh there, else of its place), so it
/// never splits anything. A vertex that no face uses follows the first of its place.
/// @param bins the corners of each group to examine
/// @param scratch  source of memory; null: allocate
/// @return whether normals may cancel in a group that was made: two of its faces look away from each other by 89 degrees or more
bool refine_groups(Topology& topology, const AttributeInput& input, const JoinRules& rules, const CornerBins& bins,
                   Context& context, GeneralScratch* scratch = nullptr);

}  // namespace rakelight::geometry
