// SPDX-License-Identifier: Apache-2.0
// What every engine and every request for a picture refuses.
#pragma once
#include <rakelight/engine.h>

#include "scene/scene_tools.h"

namespace rakelight {

/// @throws Error usage: a size, window, number or enumerator that no picture can have
void check_settings(const RenderSettings& settings);

/// More than one sample a pixel, of an engine's own: they go with Visibility::z_reversed alone. Paths are no such samples.
inline bool has_pixel_samples(const RenderSettings& s) { return s.samples > 1 && s.method != RayMethod::path; }

/// @param nodes  of the scene that it stands in
/// @throws Error usage: a camera that nobody can look through
void check_camera(const Camera& camera, std::size_t nodes, CameraUse use = CameraUse::in_engine);

}  // namespace rakelight
