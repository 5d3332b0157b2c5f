// SPDX-License-Identifier: Apache-2.0
// Animations as data: channels of the nodes that are placed.
#pragma once
#include "io/gltf/nodes.h"

namespace rakelight::io::gltf {

/// Channels whose data is broken, or whose target is no property of a node, are left out with a remark; those of nodes
/// outside the scene without one.
void read_animations(Accessors& accessors, const Nodes& nodes, Scene& scene);

}  // namespace rakelight::io::gltf
