// SPDX-License-Identifier: Apache-2.0
// The preset of the fixed-function pipeline: what it sets, and what it makes of materials and lights. docs/shading.md.
#pragma once
#include <rakelight/request.h>

namespace rakelight {

inline constexpr std::size_t max_fixed_lights = 8;  ///< OpenGL 1.x: GL_MAX_LIGHTS at least, and with most drivers
inline constexpr float max_fixed_shininess = 128;   ///< OpenGL 1.x: GL_SHININESS

/// The settings that go with a preset, before those that are given.
void set_preset(Preset preset, PictureRequest& request);

/// Materials as the pipeline of the request's preset has them, no light from all around, and nothing of a part's own that goes
/// beyond it. Materials stay where the request names a lighting model beyond the classical ones.
Scene with_preset(Scene scene, const PictureRequest& request);

/// How many lights there are beyond those that the request's preset has: of a place or a direction; ambient light is no such.
std::size_t lights_beyond_preset(const std::vector<Light>& lights, const PictureRequest& request);
/// Without those.
std::vector<Light> within_preset(std::vector<Light> lights, const PictureRequest& request);

}  // namespace rakelight
