// SPDX-License-Identifier: Apache-2.0
// Transforms of skinned meshes in the bind pose, in which their parts meet.
#pragma once
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "prepare/variants.h"

namespace rakelight {

/// [nodes] object -> world for smoothing. World matrices, but the bind pose for nodes with a skin: joint * inverse bind
/// matrix of one of its joints (glTF 2.0, section 3.7.3.3: the node's own transform is ignored). Skins that share a
/// joint are placed relative to each other by their inverse bind matrices, for any pose of the file's nodes. If the
/// bind pose is singular or non-finite: the node's own matrix.
std::vector<dmat4> bind_pose_matrices(const Scene& scene);

/// Warns if vertices of skinned instances at one place of the bind pose have different joints or weights: the surface
/// will crack there when it moves. Adds a note if the memory budget does not allow the check.
/// @param place result of bind_pose_matrices()
/// @throws Error failed: cancelled
void warn_of_parting_vertices(const Scene& scene, const std::vector<Instance>& instances,
                              const std::vector<dmat4>& place, Context& context);

}  // namespace rakelight
