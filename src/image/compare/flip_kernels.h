// SPDX-License-Identifier: Apache-2.0
// The filters of FLIP for a viewing distance.
#pragma once
#include <vector>

namespace rakelight::flip {

/// Centered one-dimensional weights, 2 r + 1 of them.
using Kernel = std::vector<double>;

/// Contrast sensitivity, Andersson et al. 2020. The blue-yellow filter is a sum of two Gaussians and not separable, so
/// it is a weighted sum of two separable filters.
struct ContrastKernels {
    Kernel achromatic, red_green, blue_yellow[2];  ///< each sums to 1
    double blue_yellow_share[2];                   ///< weight of each Gaussian; sum 1
    int radius;                                    ///< [px] of all four
};
ContrastKernels contrast_kernels(double pixels_per_degree);

/// Detection of edges and points.
struct FeatureKernels {
    Kernel gaussian;  ///< sums to 1
    Kernel edge;      ///< first derivative: positive weights sum to 1, negative to -1
    Kernel point;     ///< second derivative, normalized in the same way
    int radius;       ///< [px]
};
FeatureKernels feature_kernels(double pixels_per_degree);

}  // namespace rakelight::flip
