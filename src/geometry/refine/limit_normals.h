// SPDX-License-Identifier: Apache-2.0
// Normals of the limit surface at the vertices of the last level, one for each side of a crease.
#pragma once
#include "geometry/refine/subdivision_levels.h"

namespace rakelight::geometry {

/// Fills out.normals and out.normal_of.
/// @param points  [vertices of the level] not yet on the limit surface
/// @param out     with its vertices
void add_limit_normals(Scheme scheme, const Level& level, const std::vector<dvec3>& points, LimitSurface& out,
                       Context& context);

}  // namespace rakelight::geometry
