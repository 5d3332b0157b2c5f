// SPDX-License-Identifier: Apache-2.0
// Parts of validate() for scenes that are known in part.
#pragma once
#include <vector>

#include <rakelight/scene/scene.h>
#include <rakelight/scene/validate.h>

namespace rakelight {

/// validate() without index blocks that the validated scene `known` has in the mesh of the same index.
void validate_changes(const Scene& scene, const Scene& known);

/// The checks of validate() for lights.
/// @param nodes number of nodes of the scene
void validate_lights(const std::vector<Light>& lights, std::size_t nodes);

}  // namespace rakelight
