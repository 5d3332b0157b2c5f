// SPDX-License-Identifier: Apache-2.0
// Whether anything of a scene can be seen from any side.
#pragma once
#include <rakelight/scene.h>

namespace rakelight {

/// True when some triangle of some object has an area in the world: finite corners that are not on one line. Ends at
/// the first one, so it costs next to nothing for ordinary models.
bool has_area(const Scene& scene);

/// @throws Error bad_file "nothing to draw ..." with the scene's source where !has_area()
void check_drawable(const Scene& scene);

}  // namespace rakelight
