// SPDX-License-Identifier: Apache-2.0
// Skins and morph targets as vertices: what moves in a scene comes to stand.
#pragma once
#include <optional>

#include <rakelight/context.h>
#include <rakelight/prepare.h>
#include <rakelight/scene.h>

namespace rakelight {

/// posed_scene() of a scene that passed validate().
namespace valid {
Scene posed_scene(Scene scene, Context& context);
}

/// Where a scene stands that can move, for questions about places: as posed_scene(), but without normals and tangents of
/// what moves. Nothing: it cannot move, and answers for itself.
std::optional<Scene> posed_outline(const Scene& scene, Context& context);

/// Nodes by Scene::pose, which is gone then; meshes, skins and clips stay.
Scene with_posed_nodes(Scene scene);

}  // namespace rakelight
