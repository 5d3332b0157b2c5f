// SPDX-License-Identifier: Apache-2.0
// Engines that take meshes in bind pose, with what poses them: from moment to moment they get joints and weights alone.
#pragma once
#include <memory>

#include <rakelight/engine.h>

#include "geometry/mesh_pose.h"

namespace rakelight {

/// What an engine is beside an Engine.
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
