// SPDX-License-Identifier: Apache-2.0
// The result of a comparison of a rendered picture with a reference picture.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include <rakelight/scene/words.h>
#include <rakelight/tools/compare.h>

namespace rakelight {

/// The metric of PictureComparison that decides.
enum class ReferenceMeasure : std::uint8_t { flip, psnr, rmse, ssim };
inline constexpr Word<ReferenceMeasure> reference_measure_words[] = {{"flip", ReferenceMeasure::flip},
                                                                     {"psnr", ReferenceMeasure::psnr},
                                                                     {"rmse", ReferenceMeasure::rmse},
                                                                     {"ssim", ReferenceMeasure::ssim}};

/// The comparison of one picture with its reference.
struct ReferenceResult {
    std::string reference{};  ///< file of the reference
    ReferenceMeasure measure = ReferenceMeasure::flip;
    double threshold = 0;           ///< the applied threshold
    std::optional<double> value{};  ///< value of the metric; absent: ssim, and a side has fewer than 11 pixels
    bool passed = false;            ///< the value is within the threshold
    std::string difference{};       ///< the written file, or empty
    PictureComparison comparison{};
};

}  // namespace rakelight
