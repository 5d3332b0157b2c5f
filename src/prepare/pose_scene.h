// SPDX-License-Identifier: Apache-2.0
// Applies skins and morph targets: static scenes from animated ones.
#pragma once
#include <optional>

#include <rakelight/context.h>
#include <rakelight/prepare.h>
#include <rakelight/scene.h>

#include "geometry/mesh_pose.h"

namespace rakelight {

/// A static scene, except for the meshes of `poses`, whose vertices are still in bind pose.
struct UnposedScene {
    Scene scene;
    geometry::MeshPoses poses{};
};
/// Poses the vertices of one mesh (which may have no pose), or of all.
void take_pose(UnposedScene& unposed, std::uint32_t number, Context& context);
void take_all_poses(UnposedScene& unposed, Context& context);

/// For validated scenes.
namespace valid {
Scene posed_scene(Scene scene, Context& context);
/// The same before vertices are posed. Their memory is checked, but not charged.
UnposedScene unposed_scene(Scene scene, Context& context);
}  // namespace valid

/// The posed positions of a scene, for spatial queries: as posed_scene(), but without normals and tangents of animated
/// meshes. Nothing: the scene is static.
std::optional<Scene> posed_outline(const Scene& scene, Context& context);

/// Applies Scene::pose to the nodes and removes it; meshes, skins and clips stay.
Scene with_posed_nodes(Scene scene);

}  // namespace rakelight
