// SPDX-License-Identifier: Apache-2.0
// World positions that two or more parts draw, and how far apart the parts' normals are there, by pairs of objects.
#pragma once
#include <rakelight/tools/inspect.h>

#include "geometry/faults/place_classes.h"
#include "tools/inspect/seam_normals.h"

namespace rakelight {

struct BorderReport {
    SeamTotals totals;                   ///< except for what is not about angles
    std::vector<BorderSummary> borders;  ///< `mesh_a` and `mesh_b` are parts here
    std::uint64_t borders_left_out = 0;
    /// The seam angle [degrees] at each place that has one (above continuous_deg), by ascending place.
    std::vector<std::pair<std::uint32_t, float>> seams_at;
};

/// Expected O(corners), O(b log b) for the b corners at borders, at most about 150 bytes each. At most 8 parts are
/// paired at a place, with at most 16 different normals each.
BorderReport find_borders(const geometry::PlacedMeshes& placed, const SeamNormals& normals, Context& context);

inline constexpr std::size_t most_borders = 10'000;      ///< listed
inline constexpr std::size_t most_parts_at_place = 8;    ///< paired with each other
inline constexpr std::size_t most_normals_of_part = 16;  ///< at one place

}  // namespace rakelight
