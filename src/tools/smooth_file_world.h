// SPDX-License-Identifier: Apache-2.0
// Scenes as formats hold them that have no skins, or no placements either.
#pragma once
#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Each placement of a mesh as a mesh of its own, skinned ones in bind pose: positions [m, world] rounded to float,
/// normals turned along, mirrored ones wound the other way round, so that fronts stay fronts; a node without a place of
/// its own for each node. Tangents and morph targets are left out. Normals that are computed from it fit the positions
/// that will be read back.
/// @throws Error bad_file: over the memory limit
/// @param holds_doubles  the format does: positions are floats about an origin where floats alone do not hold them
Scene placed_in_world(const Scene& scene, bool holds_doubles, Context& context);

/// [m] What rounding on the way to such a file can make of one place: 2^-20 of the largest coordinate, eight steps of a
/// float there: one for each of the two roundings, the rest for the sums that placed the corners.
double world_rounding(const Scene& scene);

}  // namespace rakelight
