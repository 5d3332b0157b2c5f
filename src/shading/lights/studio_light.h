// SPDX-License-Identifier: Apache-2.0
// The light of the built-in studio, made ready when the program was built.
#pragma once
#include "image/maps/environment.h"

namespace rakelight::shading {

/// The bits that make_environment_light() gives for studio_panorama(), which takes it 0.1 s.
/// The web build computes the sharpest map at each call.
EnvironmentLight studio_light(Context& context);

}  // namespace rakelight::shading
