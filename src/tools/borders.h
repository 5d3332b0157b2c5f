// SPDX-License-Identifier: Apache-2.0
// World positions that two or more objects draw, and how far apart the objects' normals are there.
#pragma once
#include <rakelight/inspect.h>

namespace rakelight {

/// Which positions are drawn by several objects, compared in double and exactly (-0 is +0).
struct SharedPositions {
    std::uint64_t positions = 0;
    std::vector<BorderSummary> borders;  ///< the largest angle first, at most `max_borders`
    std::uint64_t borders_left_out = 0;
    static constexpr std::size_t max_borders = 1000;
};

/// @param scene   prepared: its meshes have normals
/// @param objects node of each object
/// O(V log V), 16 bytes a vertex.
SharedPositions find_borders(const Scene& scene, const std::vector<std::uint32_t>& objects, Context& context);

}  // namespace rakelight
