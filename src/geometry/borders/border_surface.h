// SPDX-License-Identifier: Apache-2.0
// The common first step of matching and measuring borders.
#pragma once
#include <rakelight/geometry/matching_borders.h>

#include "geometry/borders/border_edges.h"

namespace rakelight::geometry {

/// @throws Error usage: an option out of range; bad_file: a mesh without normals
void check_matching(std::span<const AttributeMesh> meshes, const MatchOptions& options);

/// The open edges of some meshes. Not copyable: other objects keep references to `placed`.
struct BorderSurface {
    BorderSurface(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context);
    PlacedMeshes placed;
    std::vector<std::uint32_t> open_corners;
    std::vector<BorderEdge> edges;
};

}  // namespace rakelight::geometry
