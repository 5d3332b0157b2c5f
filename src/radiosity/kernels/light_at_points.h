// SPDX-License-Identifier: Apache-2.0
// The scene's lights at points of surfaces, by the lighting text. C headers only.
#pragma once
#include <stdint.h>

#include "lighting/light_parameters.h"

namespace rakelight::radiosity {

/// One light as a point meets it.
struct LightAtPoint {
    float to_light[3];  ///< unit
    float radiance[3];  ///< of a white diffuse surface that faces it
};

namespace radiositylight {
/// @param position  in the space of the light
LightAtPoint light_at_point(const lighting::LightParameters& light, const float (&position)[3]);
}  // namespace radiositylight

}  // namespace rakelight::radiosity
