// SPDX-License-Identifier: Apache-2.0
// Up to where lines and points still lie on the surface that a ray meets. They are as wide as pixels demand and cross the surface, so
// that half of them is behind it where it is seen at a slant.
#pragma once
#include <array>

#include <rakelight/engines/engine.h>

#include "shading/picture_camera.h"

namespace rakelight::raytrace {

/// Along a ray.
struct MarkLimit {
    float points = 0, lines = 0;
};

class MarkLimits {
public:
    /// @param view  must outlive this
    MarkLimits(const shading::PictureCamera& view, const RenderSettings& settings);

    /// @param corners     of a triangle, about the eye, as the origin is
    /// @param t           where the ray meets it
    /// @param is_primary  its marks are strips of the picture: raster/marks/tile_marks.h has the same tolerance
    MarkLimit on_triangle(const std::array<dvec3, 3>& corners, float t, vec3 origin, vec3 direction,
                          bool is_primary) const;

private:
    /// How much changes over a pixel of the surface, and over all of it: 1 / distance in perspective, else distance.
    struct Change {
        double per_pixel, whole;
    };
    Change on_screen(const std::array<dvec3, 3>& corners, dvec3 normal, dvec3 origin, dvec3 direction) const;
    Change in_space(const std::array<dvec3, 3>& corners, dvec3 normal, double t, dvec3 origin, dvec3 direction) const;
    double key(double away) const;

    const shading::PictureCamera& view_;
    dvec3 ahead_, along_x_, along_y_;  ///< the view axis; PixelRays
    double point_reach_, line_reach_;  ///< [px] from the middle of a mark to the last pixel that it covers
    double pixel_;                     ///< [m] at 1 m
};

}  // namespace rakelight::raytrace
