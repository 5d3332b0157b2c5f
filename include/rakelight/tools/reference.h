// SPDX-License-Identifier: Apache-2.0
// Comparison of a rendered picture with a reference picture: `rakelight render --ref`.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include <rakelight/base/export.h>
#include <rakelight/scene/words.h>
#include <rakelight/tools/compare.h>

namespace rakelight {

/// The metric of PictureComparison that decides.
enum class ReferenceMeasure : std::uint8_t { flip, psnr, rmse, ssim };
inline constexpr Word<ReferenceMeasure> reference_measure_words[] = {{"flip", ReferenceMeasure::flip},
                                                                     {"psnr", ReferenceMeasure::psnr},
                                                                     {"rmse", ReferenceMeasure::rmse},
                                                                     {"ssim", ReferenceMeasure::ssim}};

/// Default thresholds: mean FLIP and RMSE at most 0.01, PSNR at least 40 dB, SSIM at least 0.99.
RL_API double default_threshold(ReferenceMeasure measure);

/// Options of a comparison with a reference.
struct ReferenceRequest {
    std::string picture{};  ///< file of the reference
    ReferenceMeasure measure = ReferenceMeasure::flip;
    /// Maximum for flip and rmse, minimum for psnr and ssim. Absent: default_threshold().
    std::optional<double> threshold{};
    std::string difference{};  ///< picture file for the FLIP per pixel; empty: it is not written
};

/// Result of compare_with_reference().
struct ReferenceResult {
    std::string reference{};  ///< file of the reference
    ReferenceMeasure measure = ReferenceMeasure::flip;
    double threshold = 0;           ///< the applied threshold
    std::optional<double> value{};  ///< value of the metric; absent: ssim, and a side has fewer than 11 pixels
    bool passed = false;            ///< the value is within the threshold
    std::string difference{};       ///< the written file, or empty
    PictureComparison comparison{};
};

/// Compares a picture file with its reference.
/// @param page not null: gets the comparison
/// @throws Error not_found: no such reference; check_failed: different sizes; bad_file; failed
RL_API ReferenceResult compare_with_reference(const std::string& picture, const ReferenceRequest& request,
                                              ComparisonPage* page, Context& context);

/// The result as text without line feed: "FLIP 0.0312, more than 0.01".
RL_API std::string to_text(const ReferenceResult& result);

}  // namespace rakelight
