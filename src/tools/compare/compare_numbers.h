// SPDX-License-Identifier: Apache-2.0
// The numbers of a comparison as people read them, in tables and on pages.
#pragma once
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <rakelight/tools/compare.h>

namespace rakelight {

/// Six digits, "inf".
inline std::string short_digits(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

/// Name and value of each, in the order of all outputs.
inline std::vector<std::pair<std::string, std::string>> numbers_of(const PictureComparison& c) {
    return {{"max error", short_digits(c.max_error)}, {"RMSE", short_digits(c.rmse)},
            {"PSNR [dB]", short_digits(c.psnr_db)},   {"SSIM", c.ssim ? short_digits(*c.ssim) : "-"},
            {"FLIP", short_digits(c.flip)},           {"differing", short_digits(100 * c.differing_share) + " %"}};
}

}  // namespace rakelight
