// SPDX-License-Identifier: Apache-2.0
// Cameras, and the lights of KHR_lights_punctual, at the nodes that are placed.
#pragma once
#include "io/gltf/nodes.h"

namespace rakelight::io::gltf {

/// One camera for each node that names one, ordered by the file's camera index, then by node. Broken ones are left out.
void read_cameras(const Document& document, const Nodes& nodes, Scene& scene);

/// One photometric light for each node that names one. Broken ones are left out with a remark.
void read_lights(const Document& document, const Nodes& nodes, Scene& scene);

}  // namespace rakelight::io::gltf
