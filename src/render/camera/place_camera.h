// SPDX-License-Identifier: Apache-2.0
// Moves, rotates and zooms a chosen camera as a view requests.
#pragma once
#include "render/camera/camera_depths.h"

namespace rakelight {

/// Warns if the requested up direction has no effect in that view.
void warn_if_up_is_along(dvec3 up, const Camera& camera, const std::string& file, Report& report);

/// The axis that a view orbits about: the up axis of its world.
dvec3 axis_of_turns(const ViewRequest& view);

/// @throws Error usage: a placement that no camera can have, whatever the model
void check_placement(const ViewRequest& view);

/// Moves, rotates and zooms a fitted or a file's camera as requested (a fitted one already has its up and view angle).
/// Near and far are then those of the request, else they enclose the box. `file` is for remarks.
Camera place_camera(const Camera& base, bool is_fitted, const ViewRequest& view, double aspect, const Bounds& bounds,
                    const NearestSurface& nearest, const std::string& file, Context& context);

/// Near and far about the box as seen along the view. A perspective camera inside the box, or close to it, gets a near of
/// far / 10000, or half the distance of the nearest surface if that is less, but no less than far / 1e8.
void set_depths(Camera& camera, const Bounds& bounds, const NearestSurface& nearest);

}  // namespace rakelight
