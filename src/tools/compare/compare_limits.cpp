// SPDX-License-Identifier: Apache-2.0
// Whether two pictures are near enough.
#include <rakelight/tools/compare.h>

#include <limits>

#include "tools/compare/compare_numbers.h"

namespace rakelight {
namespace {

struct Limit {
    const char* name;
    std::optional<double> CompareLimits::*limit;
    bool is_least;
    const char* unit;
    double (*value)(const PictureComparison&);
};

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr Limit all_limits[] = {
    {"max-error", &CompareLimits::max_error, false, "", [](const PictureComparison& c) { return c.max_error; }},
    {"max-rmse", &CompareLimits::max_rmse, false, "", [](const PictureComparison& c) { return c.rmse; }},
    {"min-psnr", &CompareLimits::min_psnr_db, true, " dB", [](const PictureComparison& c) { return c.psnr_db; }},
    {"min-ssim", &CompareLimits::min_ssim, true, "", [](const PictureComparison& c) { return c.ssim.value_or(none); }},
    {"max-flip", &CompareLimits::max_flip, false, "", [](const PictureComparison& c) { return c.flip; }},
    {"max-differing", &CompareLimits::max_differing_share, false, " of the pixels",
     [](const PictureComparison& c) { return c.differing_share; }},
};

}  // namespace

std::vector<CheckFailure> check_limits(const PictureComparison& comparison, const CompareLimits& limits) {
    std::vector<CheckFailure> failures;
    for (const Limit& l : all_limits) {
        if (!(limits.*l.limit)) continue;
        const double limit = *(limits.*l.limit), value = l.value(comparison);
        if (value != value)
            failures.push_back({l.name, "pictures with a side under 11 pixels have none"});
        else if (l.is_least ? value < limit : value > limit)
            failures.push_back({l.name, short_digits(value) + l.unit + (l.is_least ? ", less than " : ", more than ") +
                                            short_digits(limit)});
    }
    return failures;
}

}  // namespace rakelight
