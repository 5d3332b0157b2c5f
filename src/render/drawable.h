// SPDX-License-Identifier: Apache-2.0
// Whether anything of a scene is visible from any side.
#pragma once
#include <rakelight/scene/scene.h>

namespace rakelight {

/// True if a triangle of an object has an area in the world (finite corners, not collinear), or if there is a line or
/// point. Stops at the first one, so it costs almost nothing for ordinary models.
bool can_be_seen(const Scene& scene);

/// @throws Error bad_file "nothing to draw ..." with the scene's source where !can_be_seen()
void check_drawable(const Scene& scene);

}  // namespace rakelight
