// SPDX-License-Identifier: Apache-2.0
// Scenes for formats that have no skins, or no placements either.
#pragma once
#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Each placement of a mesh becomes a separate mesh, skinned ones in bind pose. Positions [m, world] are rounded to
/// float, normals are rotated along, and mirrored meshes are wound the other way so that fronts stay fronts. Each node
/// becomes one without a transform. Tangents and morph targets are left out. Normals that are computed from it fit the
/// positions that will be read back.
/// @throws Error bad_file: over the memory limit
/// @param holds_doubles  the format does: positions are floats about an origin where floats alone do not hold them
Scene placed_in_world(const Scene& scene, bool holds_doubles, Context& context);

/// [m] Largest distance that rounding can put between equal positions in such a file: 2^-20 of the largest coordinate,
/// which is eight steps of a float there. Two steps are for the two roundings, the rest for the sums that placed the
/// corners.
double world_rounding(const Scene& scene);

}  // namespace rakelight
