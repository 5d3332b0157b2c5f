// SPDX-License-Identifier: Apache-2.0
// Which numbers of vertices a picture is colored by.
#pragma once
#include <rakelight/request.h>

namespace rakelight {

/// With the array's name and the range filled in where they were left open. @throws Error usage: as color_by_array()
Coloring completed(const Scene& scene, Coloring coloring);

/// A note of the numbers that a picture in other colors does not show, where there are any.
void note_arrays(const Scene& scene, Report& report);

}  // namespace rakelight
