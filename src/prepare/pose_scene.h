// SPDX-License-Identifier: Apache-2.0
// Skins and morph targets as vertices: what moves in a scene comes to stand.
#pragma once
#include <optional>

#include <rakelight/context.h>
#include <rakelight/prepare.h>
#include <rakelight/scene.h>

#include "geometry/mesh_pose.h"

namespace rakelight {

/// A scene in which all stands but for vertices: those of the meshes of `poses` are in bind pose yet.
struct UnposedScene {
    Scene scene;
    geometry::MeshPoses poses{};
};
/// Vertices of one mesh (which may have no pose), or of all.
void take_pose(UnposedScene& unposed, std::uint32_t number, Context& context);
void take_all_poses(UnposedScene& unposed, Context& context);

/// Of a scene that passed validate().
namespace valid {
Scene posed_scene(Scene scene, Context& context);
/// The same before the vertices move. Memory for them is asked for, and nothing is charged.
UnposedScene unposed_scene(Scene scene, Context& context);
}  // namespace valid

/// Where a scene stands that can move, for questions about places: as posed_scene(), but without normals and tangents of
/// what moves. Nothing: it cannot move, and answers for itself.
std::optional<Scene> posed_outline(const Scene& scene, Context& context);

/// Nodes by Scene::pose, which is gone then; meshes, skins and clips stay.
Scene with_posed_nodes(Scene scene);

}  // namespace rakelight
