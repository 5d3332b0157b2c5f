// SPDX-License-Identifier: Apache-2.0
// The grid on the ground below a model.
#pragma once
#include <rakelight/engines/engine.h>
#include <rakelight/scene/scene_queries.h>

#include "shading/picture_camera.h"

namespace rakelight {

/// 1, 2 or 5 times a power of ten: the largest that is not above `least`, which is more than 0 and finite.
double step_of_scale(double least);

class GroundGrid {
public:
    /// @param up      unit, world
    /// @param bounds  of the model; not empty
    /// @param dark    lines are drawn dark, for light backgrounds
    GroundGrid(const shading::PictureCamera& view, dvec3 up, const Bounds& bounds, bool dark);

    /// What is drawn over a pixel: linear color and alpha. @param depth  [m] of what the pixel shows
    vec4 at(int x, int y, double depth) const;

    double step() const { return step_; }  ///< [m] from line to line

private:
    struct Lines {
        double cover, major, axis;  ///< 0..1: of all lines, of each tenth power, of the one through the origin
    };
    Lines lines(double at, double change) const;

    shading::PixelRays rays_;
    dvec3 eye_, forward_, up_, across_[2], middle_;
    bool is_parallel_;
    double near_, height_, step_, major_, reach_, tolerance_;
    vec3 color_, axis_color_[2];
};

}  // namespace rakelight
