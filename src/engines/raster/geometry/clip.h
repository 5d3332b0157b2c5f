// SPDX-License-Identifier: Apache-2.0
// Clipping in homogeneous space, before the division: a triangle through the eye plane must not wrap round.
#pragma once
#include <cstddef>

#include "engines/raster/kernels/clip_planes.h"
#include "shading/picture_camera.h"

namespace rakelight::raster {

using shading::ClipVertex, shading::PictureCamera, shading::picture_camera_of;

/// Limits of the clip volume of a view, in the numbers that ClipVertex holds.
struct ClipVolume {
    explicit ClipVolume(const PictureCamera& view);
    double z_near, z_far;    ///< of ClipVertex::distance
    float guard_x, guard_y;  ///< |x| <= guard_x w
};

/// Which planes the vertex lies outside of. A vertex with a non-finite coordinate is outside of all.
unsigned outcode(const ClipVertex& v, const ClipVolume& volume);

/// A plane adds one vertex to a convex polygon; rounding may leave slivers that are not quite convex, of which it can add one
/// for each two: 3, 4, 6, 9, 13, 19, 28.
inline constexpr std::size_t max_clipped_vertices = 28;

/// Cuts a triangle by the planes in `planes` (Sutherland & Hodgman 1974). New vertices are computed from the inner to the
/// outer end of an edge, so that two triangles that share the edge get the same one.
/// @return vertices written to `out` (0: nothing is left), in the winding of the input
std::size_t clip_triangle(const ClipVertex (&triangle)[3], unsigned planes, const ClipVolume& volume,
                          ClipVertex (&out)[max_clipped_vertices]);

}  // namespace rakelight::raster
