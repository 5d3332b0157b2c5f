// SPDX-License-Identifier: Apache-2.0
// Joins several models in one scene.
#pragma once
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Joins scenes in their order with their own coordinates, lights and cameras. Uses the first environment and the first
/// fog. Mesh::normal_choice records formats whose missing normals are flat. The source is the first one; it is empty if that is a file with Z up, and Z is
/// not up in all.
/// @throws Error as merge_scenes()
Scene join_scenes(const std::vector<Scene>& scenes, Context& context);

}  // namespace rakelight
