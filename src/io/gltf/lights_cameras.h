// SPDX-License-Identifier: Apache-2.0
// Cameras, and the lights of KHR_lights_punctual, at the nodes that are placed.
#pragma once
#include "io/gltf/nodes.h"

namespace rakelight::io::gltf {

/// One camera for each node that names one, ordered by the file's camera index, then by node. Broken ones are left out.
/// @return [scene.cameras] the file's index
std::vector<std::uint32_t> read_cameras(const Document& document, const Nodes& nodes, Scene& scene);

/// One photometric light for each node that names one. Broken ones are left out with a remark.
/// @return [scene.lights] the file's index
std::vector<std::uint32_t> read_lights(const Document& document, const Nodes& nodes, Scene& scene);

}  // namespace rakelight::io::gltf
