// SPDX-License-Identifier: Apache-2.0
#include "engines/posed_arrays.h"

#include <utility>

#include "scene/charge_arrays.h"

namespace rakelight {

// The interface takes a share of the poses; this engine needs none of it.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
void Engine::prepare_unposed(Scene scene, std::shared_ptr<const geometry::MeshPoses> poses, Context& context) {
    prepare(poses ? with_posed_arrays(std::move(scene), *poses, context) : std::move(scene), context);
}

void take_posed_arrays(Mesh& mesh, const geometry::MeshPose& pose, Context& context) {
    const Mesh unposed = mesh;
    geometry::PosedArrays arrays = geometry::posed_arrays(pose, context);
    mesh.positions = std::move(arrays.positions), mesh.normals = std::move(arrays.normals);
    mesh.tangents = std::move(arrays.tangents);
    charge_new_arrays(mesh, unposed, context);
}

Scene with_posed_arrays(Scene scene, const geometry::MeshPoses& poses, Context& context) {
    for (const auto& [number, pose] : poses) {
        context.throw_if_cancelled();
        take_posed_arrays(scene.meshes[number], pose, context);
    }
    return scene;
}

}  // namespace rakelight
