// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rakelight/scene.h>

namespace rakelight::radiosity {

/// The scene for vertex-color light: no lights, the environment only as background, the lit pose, no clips.
Scene static_scene(Scene scene);

}  // namespace rakelight::radiosity
