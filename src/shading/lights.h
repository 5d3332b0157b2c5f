// SPDX-License-Identifier: Apache-2.0
// Scene lights -> what the lighting text reads.
#pragma once
#include <vector>

#include <rakelight/scene.h>

#include "lighting/light_parameters.h"
#include "math/linear.h"

namespace rakelight::shading {

/// The lights of a scene, placed about the eye, angles as cosines. In the scene's order.
std::vector<lighting::LightParameters> make_lights(const Scene& scene, const std::vector<dmat4>& node_to_world,
                                                   dvec3 eye);

}  // namespace rakelight::shading
