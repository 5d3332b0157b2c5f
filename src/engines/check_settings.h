// SPDX-License-Identifier: Apache-2.0
// Checks of settings that every engine and every request for a picture share.
#pragma once
#include <rakelight/engines/engine.h>

#include "scene/faults.h"

namespace rakelight {

/// @throws Error usage: a size, window, number or enumerator that no picture can have
void check_settings(const RenderSettings& settings);

/// Multisampling, which works only with Visibility::z_reversed. The paths of a pixel are no such samples.
inline bool has_pixel_samples(const RenderSettings& s) { return s.samples > 1 && s.method != RayMethod::path; }

/// @param nodes  of the scene that it stands in
/// @throws Error usage: an invalid camera
void check_camera(const Camera& camera, std::size_t nodes, CameraUse use = CameraUse::in_engine);

}  // namespace rakelight
