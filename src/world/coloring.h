// SPDX-License-Identifier: Apache-2.0
// Resolves the coloring of a picture by a vertex attribute.
#pragma once
#include <rakelight/world/request.h>

namespace rakelight {

/// Fills in the array's name and the range if they are not given.
/// @throws Error usage: as color_by_array()
Coloring completed(const Scene& scene, Coloring coloring);

/// Adds a note if the scene has attributes that the picture does not show.
void note_arrays(const Scene& scene, Report& report);

}  // namespace rakelight
