// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rakelight/scene.h>

namespace rakelight::radiosity {

/// What is left of a scene whose light stands in its surfaces: no lights, an environment that is seen alone, the one pose that it
/// was lit in, no clips.
Scene static_scene(Scene scene);

}  // namespace rakelight::radiosity
