// SPDX-License-Identifier: Apache-2.0
// What a picture is lit by: requested_lights() and shot_lights() of picture_parts.h, with remarks.
#pragma once
#include <vector>

#include <rakelight/request.h>

namespace rakelight {

/// requested_lights(), with notes of lights that the preset leaves out and of ranges that the cutoff sets.
/// @throws Error bad_file: an invalid light
std::vector<Light> lights_of_picture(const Scene& scene, const PictureRequest& request, const Camera& camera,
                                     Report& report);

}  // namespace rakelight
