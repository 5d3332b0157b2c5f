// SPDX-License-Identifier: Apache-2.0
// Instances of skinned or morphed meshes.
#pragma once
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "prepare/variants.h"

namespace rakelight {

bool follows_skin(const Scene& scene, const Node& node, const Mesh& mesh);

/// In the order of nodes and slots; of every topology.
std::vector<Instance> moving_placements(const Scene& scene);

/// Gives each animated instance its own mesh: the last one keeps the mesh, others get a copy that shares the arrays.
Scene with_own_meshes(Scene scene, Context& context);

}  // namespace rakelight
