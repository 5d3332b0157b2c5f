// SPDX-License-Identifier: Apache-2.0
// Guesses the up axis of models in formats that do not define it.
#pragma once
#include <string>

#include <rakelight/scene/scene.h>

namespace rakelight {

/// Whether files of that name have no up axis: STL, PLY, OBJ, OFF and lists of points.
bool has_no_up_axis(const std::string& path);

/// Why the model looks as if +Z were up, for people; empty: it does not, or it is unclear. Reported only if one of the
/// six sides of its box differs from the others:
/// - it is at least a quarter as high in z as it is wide, and stands on a flat base. The triangles of a base face along
///   Z and lie in the lowest 1 % of z. Their areas fill at least a quarter of that side of the box, and at least three
///   times as much of it as triangles do of any other side;
/// - its coordinates are those of a survey: x and y are more than ten times the model's size from zero, z is not.
std::string why_z_is_up(const Scene& scene);
/// The same for +Y, by its base alone.
std::string why_y_is_up(const Scene& scene);

}  // namespace rakelight
