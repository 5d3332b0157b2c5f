// SPDX-License-Identifier: Apache-2.0
// How points hide each other.
#pragma once
#include "engines/raster/marks/mark_coverage.h"
#include "engines/raster/tile.h"

namespace rakelight::raster {

/// Decides which of two points shows in a pixel that both cover: that whose paraboloid is nearer. The paraboloid opens
/// away from the eye, with its vertex at the point. It is a radius deep at the border, so that points at equal depth
/// part at their bisector (Schuetz & Wimmer 2015, "High-Quality Point-Based Rendering Using Fast Single-Pass
/// Interpolation", section 3).
class PointParaboloid {
public:
    /// @param half  [px] the radius of points
    PointParaboloid(const PictureCamera& view, double half)
        : is_parallel_(view.orthographic),
          radius_(2 * half / (view.scale_y * view.height)),
          per_depth_(is_parallel_ ? 1 / (view.z_far - view.z_near) : 1) {}

    /// @param key   reversed depth of the point
    /// @param sunk  MarkShape::sunk()
    double key(double key, double sunk) const {
        return is_parallel_ ? key - radius_ * sunk * per_depth_ : key / (1 + radius_ * sunk);
    }

    bool is_parallel() const { return is_parallel_; }
    /// [key] how deep it is at the border: of a parallel view's keys, else as a share of the key.
    double depth() const { return radius_ * per_depth_; }

private:
    bool is_parallel_;
    double radius_;  ///< [m] in parallel views; else over the distance along the view axis
    double per_depth_;
};

}  // namespace rakelight::raster
