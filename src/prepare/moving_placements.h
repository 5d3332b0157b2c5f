// SPDX-License-Identifier: Apache-2.0
// Placements of meshes whose vertices move: by a skin, or by morph targets.
#pragma once
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>

#include "prepare/variants.h"

namespace rakelight {

bool follows_skin(const Scene& scene, const Node& node, const Mesh& mesh);

/// In the order of nodes and slots; of every topology.
std::vector<Instance> moving_placements(const Scene& scene);

/// Each moving placement shows a mesh that no other placement shows: the last one of a mesh keeps it, others get a copy
/// that shares the arrays.
Scene with_own_meshes(Scene scene, Context& context);

}  // namespace rakelight
