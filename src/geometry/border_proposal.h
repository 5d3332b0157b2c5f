// SPDX-License-Identifier: Apache-2.0
// Which distance would find borders that run along each other, where nobody says one.
#pragma once
#include <rakelight/matching_borders.h>

namespace rakelight::geometry {

struct ProposedDistance {
    double distance = 0;  ///< [m] 0: no borders run along each other
    double seam_deg = 0;  ///< the largest angle there, of what was asked
};

/// As proposed_border_distance(). At most 4096 edges, spread over all, are asked, so the work beyond the look for open
/// edges is bounded.
ProposedDistance propose_distance(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context);

}  // namespace rakelight::geometry
