// SPDX-License-Identifier: Apache-2.0
// A picture held against a reference picture after it was made: `rakelight render --ref`.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include <rakelight/compare.h>
#include <rakelight/export.h>
#include <rakelight/tools/words.h>

namespace rakelight {

/// Which number of PictureComparison decides.
enum class ReferenceMeasure : std::uint8_t { flip, psnr, rmse, ssim };
inline constexpr Word<ReferenceMeasure> reference_measure_words[] = {{"flip", ReferenceMeasure::flip},
                                                                     {"psnr", ReferenceMeasure::psnr},
                                                                     {"rmse", ReferenceMeasure::rmse},
                                                                     {"ssim", ReferenceMeasure::ssim}};

/// What passes where nobody says: a mean FLIP or an RMSE of at most 0.01, a PSNR of at least 40 dB, an SSIM of at least 0.99.
RL_API double usual_threshold(ReferenceMeasure measure);

/// What a picture is held against.
struct ReferenceRequest {
    std::string picture{};  ///< file of the reference
    ReferenceMeasure measure = ReferenceMeasure::flip;
    std::optional<double> threshold{};  ///< most of flip and rmse, least of psnr and ssim; absent: the usual one
    std::string difference{};           ///< picture file for the FLIP of each pixel; empty: none
};

/// What came of it.
struct ReferenceResult {
    std::string reference{};  ///< file of the reference
    ReferenceMeasure measure = ReferenceMeasure::flip;
    double threshold = 0;           ///< that was held
    std::optional<double> value{};  ///< absent: ssim of pictures with a side under 11 pixels
    bool passed = false;            ///< the value is within it
    std::string difference{};       ///< file that was written, or empty
    PictureComparison comparison{};
};

/// Compares a picture file with its reference.
/// @param page  takes the comparison up where it is not null
/// @throws Error not_found: no such reference, with the advice how to make it; check_failed: their sizes differ; bad_file, failed
RL_API ReferenceResult compare_with_reference(const std::string& picture, const ReferenceRequest& request,
                                              ComparisonPage* page, Context& context);

/// "FLIP 0.0312, more than 0.01": a line without its end. @return what is said of a result, whether it passed or not
RL_API std::string to_text(const ReferenceResult& result);

}  // namespace rakelight
