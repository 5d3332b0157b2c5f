// SPDX-License-Identifier: Apache-2.0
// What matching and measuring of borders begin with.
#pragma once
#include <rakelight/matching_borders.h>

#include "geometry/border_edges.h"

namespace rakelight::geometry {

/// @throws Error usage: an option out of its range; bad_file: a mesh without normals
void check_matching(std::span<const AttributeMesh> meshes, const MatchOptions& options);

/// The open edges of some meshes. Not to be copied: `placed` is looked into from elsewhere.
struct BorderSurface {
    BorderSurface(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context);
    PlacedMeshes placed;
    std::vector<std::uint32_t> open_corners;
    std::vector<BorderEdge> edges;
};

}  // namespace rakelight::geometry
