// SPDX-License-Identifier: Apache-2.0
// Where the viewer's camera stands, and how it moves. No window, no scene: numbers in, numbers out.
#pragma once
#include <optional>

#include <rakelight/math/vector.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/world/request.h>

namespace rakelight::viewer {

/// A camera that looks at a point. Lengths in meters; `focal` never is `position`.
struct Eye {
    dvec3 position{0, 0, 5}, focal{0, 0, 0};
    dvec3 up{0, 1, 0};                           ///< unit; of the picture, not along the view
    double fov_deg = 40;                         ///< vertical
    std::optional<double> horizontal_fov_deg{};  ///< of cameras whose pixels are not square
    bool is_orthographic = false;
    bool operator==(const Eye&) const = default;
};

/// The eye of a camera that choose_camera() gave; it looks at the point of its axis that is nearest to the model's center.
Eye eye_of(const Camera& camera, const Bounds& bounds);

/// Says in a request where the eye is, instead of what it said before of the view; near and far stay. The request's up is the
/// world's where that gives the eye's, so that who reads it knows both; else, of rolled and steep views, the eye's own.
void place(ViewRequest& view, const Eye& eye, dvec3 world_up);

dvec3 forward_of(const Eye& eye);  ///< unit
dvec3 right_of(const Eye& eye);    ///< unit
double distance_of(const Eye& eye);

/// @param radians  right and up, as the pointer moves: the model follows it
void turn_table(Eye& eye, double right_rad, double up_rad, dvec3 world_up);
/// Shoemake 1992, "ARCBALL: A User Interface for Specifying Three-Dimensional Orientation Using a Mouse"; the rotation by the
/// angle between the points on the ball, so that the model follows the pointer.
/// @param from,to  the pointer: the smaller side of the picture goes from -1 to 1, y up
void turn_ball(Eye& eye, dvec2 from, dvec2 to);
/// Pixels by which what lies at the focal point follows the pointer, y down. @param height_px  of the picture
void pan(Eye& eye, double dx_px, double dy_px, double height_px);
/// Distance to the focal point times `factor` (> 0).
void dolly(Eye& eye, double factor);
/// Around the focal point, to the right.
void go_around(Eye& eye, double angle_rad, dvec3 world_up);
void roll(Eye& eye, double angle_rad);
/// Moves the focal point to `target`, the eye with it.
void center_on(Eye& eye, dvec3 target);

/// Walking: the head turns; `up` is world_up again.
void look(Eye& eye, double right_rad, double up_rad, dvec3 world_up);
/// Walking: steps in meters, along the view, to the right, along world_up.
void walk(Eye& eye, double ahead, double right, double up, dvec3 world_up);

/// Rotation about a unit axis, counter-clockwise seen against it.
dvec3 rotated(dvec3 v, dvec3 axis, double angle_rad);

}  // namespace rakelight::viewer
