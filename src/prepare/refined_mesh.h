// SPDX-License-Identifier: Apache-2.0
// A mesh after its triangles were cut: all arrays follow.
#pragma once
#include <rakelight/scene.h>

#include "geometry/tessellate.h"

namespace rakelight {

/// New vertices have of every attribute the mean of the two that they stand between (normals and tangents are not unit then);
/// smoothing groups follow by FineMesh::source_triangle. Polygons, hints, joint influences and morph targets are gone.
Mesh refined_mesh(const Mesh& coarse, const geometry::FineMesh& fine);

}  // namespace rakelight
