// SPDX-License-Identifier: Apache-2.0
// Shelf packing of chart rectangles at the largest possible scale.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

namespace rakelight::bake {

struct Packing {
    double scale = 0;            ///< [px/m]
    std::vector<dvec2> place{};  ///< [rectangles] [px] of its upper left corner
};

/// Finds the largest common scale by bisection. Rectangles are sorted by height and placed side by side until a shelf
/// is full ("next fit decreasing height", Coffman et al. 1980, "Performance Bounds for Level-Oriented Two-Dimensional
/// Packing Algorithms"). Each starts at whole pixels with `margin` free pixels around it, shared by neighbors.
/// @param sizes  [rectangles] [m] finite, >= 0
/// @return absent: they do not fit even as points
std::optional<Packing> pack_shelves(std::span<const dvec2> sizes, int width, int height, int margin, Context& context);

}  // namespace rakelight::bake
