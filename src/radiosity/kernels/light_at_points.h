// SPDX-License-Identifier: Apache-2.0
// Evaluates the scene's lights at surface points with the shared lighting code. C headers only.
#pragma once
#include <stdint.h>

#include "lighting/light_parameters.h"

namespace rakelight::radiosity {

/// One light at a point.
struct LightAtPoint {
    float to_light[3];  ///< unit
    float radiance[3];  ///< of a white diffuse surface facing the light
};

namespace radiositylight {
/// @param position  in the space of the light
LightAtPoint light_at_point(const lighting::LightParameters& light, const float (&position)[3]);
}  // namespace radiositylight

}  // namespace rakelight::radiosity
