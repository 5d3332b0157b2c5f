// SPDX-License-Identifier: Apache-2.0
// Where skinned meshes stand before any bone moves: that is where their parts meet.
#pragma once
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>

#include "prepare/variants.h"

namespace rakelight {

/// [nodes] object -> world for smoothing: world matrices, but for nodes with a skin the bind pose, joint * inverse bind
/// matrix of one of its joints (glTF 2.0, section 3.7.3.3: the node's own transform does not count). Skins that share a
/// joint stand to one another as their inverse bind matrices say, in whatever pose the file's nodes are. A bind pose
/// that is not finite or is flat: the node's own.
std::vector<dmat4> bind_pose_matrices(const Scene& scene);

/// Warns when vertices of skinned instances that stand at one place in the bind pose follow different joints or
/// weights: however smooth the normals, the surface will open there when it moves. A note where the memory budget does
/// not let it look.
/// @param place  what bind_pose_matrices() gave
/// @throws Error failed: cancelled
void warn_of_parting_vertices(const Scene& scene, const std::vector<Instance>& instances,
                              const std::vector<dmat4>& place, Context& context);

}  // namespace rakelight
