// SPDX-License-Identifier: Apache-2.0
// Structural similarity of two pictures.
#pragma once
#include <optional>

#include "image/compare/display_picture.h"

namespace rakelight {

/// Mean SSIM of the luma of two pictures of one size: -1..1, exactly 1 for equal ones. Windows lie entirely inside the
/// picture; nullopt for pictures with a side of fewer than 11 pixels. Bit-identical for any number of threads. Source:
/// Wang, Bovik, Sheikh, Simoncelli 2004, "Image Quality Assessment: From Error Visibility to Structural Similarity",
/// eq. 13 and 17: 11 x 11 Gaussian of sigma 1.5, K1 = 0.01, K2 = 0.03, no downsampling first. The paper uses gray
/// pictures; luma is that of the authors' code, 0.299 R + 0.587 G + 0.114 B of the sRGB codes (BT.601).
std::optional<double> mean_ssim(const DisplayPicture& a, const DisplayPicture& b, Context& context);

}  // namespace rakelight
