// SPDX-License-Identifier: Apache-2.0
// A scene as a format without placements holds it: every object at its place, in float.
#pragma once
#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Each placement of a mesh as a mesh of its own: positions [m, world] rounded to float, normals turned along, mirrored
/// ones wound the other way round, so that fronts stay fronts; a node without a place of its own for each node.
/// Tangents and morph targets are left out. Normals that are computed from it fit the positions that will be read back.
/// @throws Error bad_file: over the memory limit
Scene placed_in_world(const Scene& scene, Context& context);

/// [m] What rounding on the way to such a file can make of one place: 2^-20 of the largest coordinate, eight steps of a
/// float there: one for each of the two roundings, the rest for the sums that placed the corners.
double world_rounding(const Scene& scene);

}  // namespace rakelight
