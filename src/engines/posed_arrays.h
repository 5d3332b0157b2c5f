// SPDX-License-Identifier: Apache-2.0
// Scenes in bind pose, for engines that pose vertices themselves: Engine::prepare_unposed().
#pragma once
#include <memory>

#include <rakelight/engines/engine.h>

#include "geometry/pose/mesh_pose.h"

namespace rakelight {

/// Vertices of one mesh as they stand, charged to the budget.
void take_posed_arrays(Mesh& mesh, const geometry::MeshPose& pose, Context& context);
/// Of all that have a pose.
Scene with_posed_arrays(Scene scene, const geometry::MeshPoses& poses, Context& context);

}  // namespace rakelight
