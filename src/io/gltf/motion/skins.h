// SPDX-License-Identifier: Apache-2.0
// Skins of the nodes that are placed.
#pragma once
#include "io/gltf/accessors.h"

#include <rakelight/scene/scene.h>

namespace rakelight::io::gltf {

class Meshes;
class Nodes;

/// Gives skinned nodes their skins. A skin whose joints are not part of the scene or whose data is broken is left out
/// with a remark; its meshes are then placed by their node.
void read_skins(Accessors& accessors, Meshes& meshes, const Nodes& nodes, Scene& scene);

}  // namespace rakelight::io::gltf
