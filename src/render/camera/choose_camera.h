// SPDX-License-Identifier: Apache-2.0
// Chooses the camera of a picture. See choose_camera() in <rakelight/picture.h>.
#pragma once
#include <functional>

#include <rakelight/picture.h>
#include <rakelight/report.h>
#include <rakelight/scene_queries.h>
#include <rakelight/validate.h>

#include "scene/near_surfaces.h"

namespace rakelight {

/// Functions of public headers for scenes that passed validate(), which the public ones do first.
namespace valid {
/// @param aspect  a number > 0
Camera choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Visibility visibility,
                     Context& context);
}  // namespace valid

/// Warns if the requested up direction has no effect in that view.
void warn_if_up_is_along(dvec3 up, const Camera& camera, const std::string& file, Report& report);

/// A camera of the file, in the world, for a picture of that aspect.
Camera camera_of_file(const Scene& scene, std::size_t index, double aspect);

/// False if the box is entirely outside one plane of the camera's frustum: nothing of it is visible.
bool may_see(const Camera& camera, double aspect, const Bounds& bounds);

/// Why nothing of the box is visible, without a full stop; empty: something may be.
std::string why_blind(const Camera& camera, double aspect, const Bounds& bounds);
/// Warns of a camera that was requested and sees nothing.
void warn_if_blind(const Camera& camera, double aspect, const Bounds& bounds, const std::string& file, Report& report);

/// Near and far as the request says, where it does. @throws Error usage: near is not less than far
void set_asked_depths(Camera& camera, const ViewRequest& view);

/// The camera with square pixels in a picture of another aspect than its own: all that it shows stays in the picture.
Camera adapt_to_aspect(Camera camera, double aspect);

/// Whether a view is that of a camera of the file, moved or not. The scene has one then, or choose_camera() refuses the view.
bool takes_camera_of_file(const Scene& scene, const ViewRequest& view);

/// A horizontal angle alone becomes the vertical one of square pixels; both change `aspect` to that of what is seen.
ViewRequest resolve_angles(ViewRequest view, double& aspect);

/// Half the width and height of the picture: [m] of parallel cameras, else at a distance of 1 m.
dvec2 half_extents(const Camera& camera, double aspect);

/// [m] along the view axis to the nearest surface in the picture of a perspective camera; the limit if none is nearer.
using NearestSurface = std::function<double(const Camera& camera, double limit)>;

/// Near and far about the box as seen along the view. A perspective camera inside the box, or close to it, gets a near of
/// far / 10000, or half the distance of the nearest surface if that is less, but no less than far / 1e8.
void set_depths(Camera& camera, const Bounds& bounds, const NearestSurface& nearest);

/// The axis that a view orbits about: the up axis of its world.
dvec3 axis_of_turns(const ViewRequest& view);

/// @throws Error usage: a placement that no camera can have, whatever the model
void check_placement(const ViewRequest& view);

/// Moves, rotates and zooms a fitted or a file's camera as requested (a fitted one already has its up and view angle).
/// Near and far are then those of the request, else they enclose the box. `file` is for remarks.
Camera place_camera(const Camera& base, bool is_fitted, const ViewRequest& view, double aspect, const Bounds& bounds,
                    const NearestSurface& nearest, const std::string& file, Context& context);

/// Whether near and far of a camera of the file are only defaults: of a perspective one in a world file that gives neither.
bool has_default_depths(const Scene& scene, const Camera& camera);

/// Whether a near plane close to the eye costs a z-buffer its precision. At a distance d one step of a textbook's depth of b bits
/// is d^2 / (near 2^b) m, of its float (which lies between 1/2 and 1) d^2 / (near 2^24) m; of the reversed float it is d / 2^24 m,
/// whatever near is.
bool loses_by_near(Visibility visibility);

/// Nothing is near to a z-buffer that would lose by it. @param surfaces  must stay
NearestSurface nearest_of(const NearSurfaces& surfaces, double aspect, Visibility visibility);

}  // namespace rakelight
