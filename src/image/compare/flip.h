// SPDX-License-Identifier: Apache-2.0
// FLIP: perceived difference between two pictures when alternating between them.
#pragma once
#include <vector>

#include "image/compare/display_picture.h"

namespace rakelight {

inline constexpr double flip_pixels_per_degree = 67;  ///< a 0.7 m wide display of 3840 pixels seen from 0.7 m
inline constexpr double flip_least_ppd = 1, flip_most_ppd = 1000;

/// The mean FLIP error over the pixels of two pictures of one size, 0..1; 0 for equal ones. Edge pixels are replicated
/// outside of the picture. Bit-identical for any number of threads. Source: Andersson, Nilsson, Akenine-Moeller,
/// Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference Evaluator for Alternating Images" (the form for pictures of
/// low dynamic range).
/// @param pixels_per_degree flip_least_ppd..flip_most_ppd, per degree of visual angle
/// @param map null, or output of each pixel's error: [height * width], 0..1
double mean_flip(const DisplayPicture& a, const DisplayPicture& b, double pixels_per_degree, Context& context,
                 std::vector<float>* map = nullptr);

}  // namespace rakelight
