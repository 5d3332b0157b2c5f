// SPDX-License-Identifier: Apache-2.0
// Whether anything of a scene can be seen from any side.
#pragma once
#include <rakelight/scene.h>

namespace rakelight {

/// True when some triangle of some object has an area in the world: finite corners that are not on one line; or when
/// there is a line or point. Ends at the first one, so it costs next to nothing for ordinary models.
bool can_be_seen(const Scene& scene);

/// @throws Error bad_file "nothing to draw ..." with the scene's source where !can_be_seen()
void check_drawable(const Scene& scene);

}  // namespace rakelight
