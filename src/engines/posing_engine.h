// SPDX-License-Identifier: Apache-2.0
// Engines that take meshes in bind pose: for each moment they get only joints and weights.
#pragma once
#include <memory>

#include <rakelight/engine.h>

#include "geometry/mesh_pose.h"

namespace rakelight {

/// Implemented by such engines in addition to Engine.
class PosingEngine {
public:
    virtual ~PosingEngine() = default;
    /// As Engine::prepare(). @param poses  of the scene's meshes whose vertices are in bind pose; null: none are
    virtual void prepare_unposed(Scene scene, std::shared_ptr<const geometry::MeshPoses> poses, Context& context) = 0;
};

/// Vertices of one mesh as they stand, charged to the budget.
void take_posed_arrays(Mesh& mesh, const geometry::MeshPose& pose, Context& context);
/// Of all that have a pose.
Scene with_posed_arrays(Scene scene, const geometry::MeshPoses& poses, Context& context);

}  // namespace rakelight
