// SPDX-License-Identifier: Apache-2.0
// The preset of the fixed-function pipeline: its settings, and its restrictions of materials and lights.
// docs/shading.md.
#pragma once
#include <rakelight/world/request.h>

namespace rakelight {

inline constexpr std::size_t max_fixed_lights = 8;  ///< OpenGL 1.x: GL_MAX_LIGHTS at least, and with most drivers
inline constexpr float max_fixed_shininess = 128;   ///< OpenGL 1.x: GL_SHININESS

/// Applies the settings of a preset, before explicit ones.
void set_preset(Preset preset, PictureRequest& request);

/// Restricts materials to the preset's pipeline, and removes the environment light and per-part settings beyond it.
/// Materials are unchanged if the request has a non-classical lighting model.
Scene with_preset(Scene scene, const PictureRequest& request);

/// Number of positional and directional lights beyond the preset's limit; ambient lights do not count.
std::size_t lights_beyond_preset(const std::vector<Light>& lights, const PictureRequest& request);
/// Removes these lights.
std::vector<Light> within_preset(std::vector<Light> lights, const PictureRequest& request);

}  // namespace rakelight
