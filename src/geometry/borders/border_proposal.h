// SPDX-License-Identifier: Apache-2.0
// The proposed distance for matching borders.
#pragma once
#include <rakelight/geometry/matching_borders.h>

namespace rakelight::geometry {

struct ProposedDistance {
    double distance = 0;  ///< [m] 0: no adjacent borders
    double seam_deg = 0;  ///< largest angle among the examined borders
};

/// Proposes MatchOptions::distance from the gaps of a model. It uses open edges that match one other mesh over their
/// whole length. The gap must be at most half the length of the edge, and must vary by at most a quarter of this
/// length. The result is slightly more than the 98th percentile of the gaps, weighted by length and rounded to two
/// digits. It is 0 if there are no such edges. At most 4096 open edges are examined, evenly distributed.
/// @param options  `distance` is not read
ProposedDistance propose_distance(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context);

}  // namespace rakelight::geometry
