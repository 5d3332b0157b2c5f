// SPDX-License-Identifier: Apache-2.0
// Point rendering: splats for points with normals, and point sizes from the spacing.
#pragma once
#include <cstddef>
#include <optional>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Meshes with more points get no splats.
inline constexpr std::size_t max_splats = 6'000'000;
/// With more points, each becomes a square of two triangles instead of a splat of twelve.
inline constexpr std::size_t max_raised = 300'000;

/// Converts points with normals to splats (scene/splat_mesh.h) perpendicular to their normals, large enough to close
/// the sampled surface (surfels: Pfister et al. 2000, "Surfels"). Overlapping splats show the nearest center. They are
/// two-sided and lit like surfaces by every engine. Points without a normal stay points in a separate mesh. Without
/// normals and colors, normals are estimated from neighbors if the points lie on a surface.
/// @throws Error bad_file: over the memory limit; failed: cancelled
Scene splat_points(Scene scene, Context& context);

/// [m] in world space: the diameter of discs that close the surface sampled by the scene's points, for the densest
/// mesh; nothing without points, or if all are at one place.
std::optional<double> point_diameter(const Scene& scene, Context& context);

}  // namespace rakelight
