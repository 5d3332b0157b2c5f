// SPDX-License-Identifier: Apache-2.0
// Cameras that a model fills.
#pragma once
#include <optional>
#include <string>

#include <rakelight/scene/scene.h>

namespace rakelight {

class DrawnVertices;

/// Options of a fitted camera.
struct FitOptions {
    /// The world's up direction, which rotates the sides: for Z up the front is at -Y. Nonzero, finite, any length.
    /// Absent: `up`, else +Y.
    std::optional<dvec3> world_up;
    std::optional<dvec3>
        up;  ///< the picture's up vector, nonzero, finite. Absent, or parallel to the view: the side's default
    std::optional<double> vertical_fov_rad;    ///< 0..pi, both exclusive
    std::optional<double> horizontal_fov_rad;  ///< 0..pi, both exclusive; both angles then define the aspect
    bool orthographic = false;
    std::optional<dvec3> direction;             ///< view direction, replaces the side's; nonzero, finite, any length
    double azimuth_rad = 0, elevation_rad = 0;  ///< see orbited()
    double fill = 0.9;                          ///< > 0: share of the picture's smaller side filled by the model
};

/// `v` rotated by the shortest rotation from +Y to `up` (unit); half a turn about Z for -Y.
dvec3 turn_with_up(dvec3 v, dvec3 up);

/// A camera transform orbited about `focal`: to the right about `axis` (unit), then upward about its x axis.
dmat4 orbited(const dmat4& to_world, dvec3 focal, dvec3 axis, double azimuth_rad, double elevation_rad);

/// A camera from a named side, fitted to all drawn vertices: the model fills `fill` of the picture's smaller side and
/// is centered. Perspective with a vertical field of view of 40 degrees by default. Sides: "front" (+Z), "back", "left"
/// (-X), "right", "top" (+Y), "bottom", "isometric", and "default", oblique: from the direction (0.45, 0.35, 1).
/// @throws Error usage for another name.
Camera view_camera(const DrawnVertices& drawn, double aspect, const std::string& side, const FitOptions& options = {});
/// The default camera of models without cameras.
Camera default_camera(const DrawnVertices& drawn, double aspect, const FitOptions& options = {});

}  // namespace rakelight
