// SPDX-License-Identifier: Apache-2.0
// Scene lights -> what the lighting text reads.
#pragma once
#include <vector>

#include <rakelight/scene/scene.h>

#include "lighting/light_parameters.h"
#include "math/linear.h"

namespace rakelight::shading {

/// Where a light stands in the world, in double.
struct LightPlace {
    dvec3 position, direction;  ///< unit, the way it shines
};
LightPlace place_of(const Light& light, const std::vector<dmat4>& node_to_world);

/// Ambient lights throw none.
bool casts_shadow(const Light& light);

/// The lights of a scene, placed about the eye, angles as cosines. In the scene's order.
std::vector<lighting::LightParameters> make_lights(const Scene& scene, const std::vector<dmat4>& node_to_world,
                                                   dvec3 eye);

}  // namespace rakelight::shading
