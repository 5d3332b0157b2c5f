// SPDX-License-Identifier: Apache-2.0
// Points as what can be seen of them: small pieces of surface where they have normals, and a size by their spacing.
#pragma once
#include <cstddef>
#include <optional>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Points of a mesh of more are not made into pieces of surface.
inline constexpr std::size_t max_splats = 6'000'000;
/// Of more each is a square of two triangles in place of a splat, which has twelve.
inline constexpr std::size_t max_raised = 300'000;

/// Meshes of points with normals become splats (scene/splat_mesh.h) in the plane of their normals, as large as closes a surface that
/// the points lie in (surface elements: Pfister et al. 2000, "Surfels"). Where they overlap the nearest center shows. They are lit as
/// surfaces are, by every engine, and both sides of them show. Points without a normal stay points, in a mesh of their
/// own. Where there are neither normals nor colors, normals are found from neighbors, if the points lie in a surface.
/// @throws Error bad_file: over the memory limit; failed: cancelled
Scene splat_points(Scene scene, Context& context);

/// [m] in the world: the diameter of discs that close a surface that the scene's points lie in, of the densest mesh; nothing where
/// there are no points, or all lie in one place.
std::optional<double> point_diameter(const Scene& scene, Context& context);

}  // namespace rakelight
