// SPDX-License-Identifier: Apache-2.0
// A mesh after tessellation, with all arrays.
#pragma once
#include <rakelight/scene/scene.h>

#include "geometry/refine/tessellate.h"

namespace rakelight {

/// Attributes of new vertices are the mean of the two end points (normals and tangents are then not unit); smoothing
/// groups follow by FineMesh::source_triangle. Polygons, hints, joint influences and morph targets are removed.
Mesh refined_mesh(const Mesh& coarse, const geometry::FineMesh& fine);

}  // namespace rakelight
