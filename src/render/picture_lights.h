// SPDX-License-Identifier: Apache-2.0
// What a picture is lit by.
#pragma once
#include <optional>
#include <vector>

#include <rakelight/world/request.h>

namespace rakelight {

/// The lights of a shot: those of requested_lights(), with notes of lights that the preset leaves out and of ranges that the
/// cutoff sets.
/// @param is_view  as in ShotOptions: absent for radiosity by the default rig
/// @throws Error bad_file: an invalid light
std::optional<std::vector<Light>> lights_of_shot(const Scene& scene, const PictureRequest& request,
                                                 const Camera& camera, bool is_view, Report& report);

}  // namespace rakelight
