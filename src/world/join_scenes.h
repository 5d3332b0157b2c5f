// SPDX-License-Identifier: Apache-2.0
// Several models as one scene.
#pragma once
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// All of the scenes in one, each where its own coordinates say, in their order, with their lights and cameras. The first
/// environment and the first fog that there are count. Meshes of a format that means flat faces say so themselves.
/// @throws Error as merge_scenes()
Scene join_scenes(const std::vector<Scene>& scenes, Context& context);

}  // namespace rakelight
