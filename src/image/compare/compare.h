// SPDX-License-Identifier: Apache-2.0
// Difference metrics of two pictures.
#pragma once
#include <cstddef>
#include <cstdint>

#include <rakelight/image/image.h>

namespace rakelight {

/// Component i of a picture, in the order of its bytes: integers scaled to 0..1, floats unchanged.
double component_at(const Pixels& pixels, std::size_t i);

/// Over all components of all pixels. Integers are scaled to 0..1, floats are unchanged.
struct PictureDifference {
    double max_absolute = 0;             ///< infinity if a NaN or an infinity meets a different value
    double rmse = 0;                     ///< root of the mean squared difference
    double psnr_db = 0;                  ///< -20 log10(rmse), peak 1; +infinity for equal pictures
    std::uint64_t differing = 0;         ///< components that differ by more than the threshold
    double differing_share = 0;          ///< of all components, 0..1
    std::uint64_t differing_pixels = 0;  ///< pixels with such a component
};

/// @param threshold  >= 0; in the same unit (one 8-bit step is 1.0 / 255)
/// @throws Error usage: the pictures differ in width, height or channels. Components may be of different kinds.
PictureDifference compare_pictures(const Pixels& a, const Pixels& b, double threshold = 0);

}  // namespace rakelight
