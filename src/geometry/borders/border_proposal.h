// SPDX-License-Identifier: Apache-2.0
// The proposed distance for matching borders.
#pragma once
#include <rakelight/geometry/matching_borders.h>

namespace rakelight::geometry {

struct ProposedDistance {
    double distance = 0;  ///< [m] 0: no adjacent borders
    double seam_deg = 0;  ///< largest angle among the examined borders
};

/// As proposed_border_distance(). Examines at most 4096 evenly distributed edges, so the work is bounded after open
/// edges are found.
ProposedDistance propose_distance(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context);

}  // namespace rakelight::geometry
