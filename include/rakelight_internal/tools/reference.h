// SPDX-License-Identifier: Apache-2.0
// Comparison of a rendered picture with a reference picture: `rakelight render --ref`.
#pragma once
#include <optional>
#include <string>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/tools/reference_result.h>
#include <rakelight_internal/tools/compare_page.h>

namespace rakelight {

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

/// Compares a picture file with its reference.
/// @param page not null: gets the comparison
/// @throws Error not_found: no such reference; check_failed: different sizes; bad_file; failed
RL_API ReferenceResult compare_with_reference(const std::string& picture, const ReferenceRequest& request,
                                              ComparisonPage* page, Context& context);

/// The result as text without line feed: "FLIP 0.0312, more than 0.01".
RL_API std::string to_text(const ReferenceResult& result);

}  // namespace rakelight
