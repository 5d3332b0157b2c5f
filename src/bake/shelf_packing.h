// SPDX-License-Identifier: Apache-2.0
// Rectangles of charts on shelves, as large as fits.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/vector.h>

namespace rakelight::bake {

struct Packing {
    double scale = 0;            ///< [px/m]
    std::vector<dvec2> place{};  ///< [rectangles] [px] of its upper left corner
};

/// All by one scale, the largest that a bisection finds to fit: sorted by height, laid side by side until a shelf is full ("next
/// fit decreasing height", Coffman et al. 1980, "Performance Bounds for Level-Oriented Two-Dimensional Packing Algorithms").
/// Each stands on whole pixels with `margin` free pixels around it, which neighbors share.
/// @param sizes  [rectangles] [m] finite, >= 0
/// @return none: they do not fit even as points
std::optional<Packing> pack_shelves(std::span<const dvec2> sizes, int width, int height, int margin, Context& context);

}  // namespace rakelight::bake
