// SPDX-License-Identifier: Apache-2.0
#include <rakelight_internal/tools/compare_page.h>
#include <rakelight_internal/tools/reference.h>

#include <filesystem>
#include <iterator>

#include "base/format_text.h"
#include "tools/compare/compare_numbers.h"

namespace rakelight {
namespace {

/// How a measure is one of compare's limits.
struct Measure {
    ReferenceMeasure measure;
    const char *title, *unit;
    double usual;
    bool is_least;
    std::optional<double> CompareLimits::*limit;
};
constexpr Measure measures[] = {
    {ReferenceMeasure::flip, "FLIP", "", 0.01, false, &CompareLimits::max_flip},
    {ReferenceMeasure::psnr, "PSNR", " dB", 40, true, &CompareLimits::min_psnr_db},
    {ReferenceMeasure::rmse, "RMSE", "", 0.01, false, &CompareLimits::max_rmse},
    {ReferenceMeasure::ssim, "SSIM", "", 0.99, true, &CompareLimits::min_ssim},
};

/// Rows and words stand at the numbers of their measures: row_of() and rows.cpp take them so.
constexpr bool are_in_order() {
    for (std::size_t i = 0; i < std::size(measures); ++i)
        if (std::size_t(measures[i].measure) != i || reference_measure_words[i].value != measures[i].measure)
            return false;
    return std::size(measures) == std::size(reference_measure_words) &&
           std::size(measures) == std::size_t(ReferenceMeasure::ssim) + 1;
}
static_assert(are_in_order());

const Measure& row_of(ReferenceMeasure measure) { return measures[std::size_t(measure)]; }

std::optional<double> value_of(const PictureComparison& c, ReferenceMeasure measure) {
    switch (measure) {
        case ReferenceMeasure::flip:
            return c.flip;
        case ReferenceMeasure::psnr:
            return c.psnr_db;
        case ReferenceMeasure::rmse:
            return c.rmse;
        case ReferenceMeasure::ssim:
            return c.ssim;
    }
    return {};
}

Pixels read_reference(const std::string& picture, const ReferenceRequest& request, Context& context) {
    std::error_code ignored;
    if (!std::filesystem::exists(request.picture, ignored))
        throw Error(ErrorCode::not_found, "there is no such reference", {},
                    "look at '" + one_line(picture, 160) + "', and if it is right, copy it to '" +
                        one_line(request.picture, 160) + "'")
            .with_file(request.picture);
    try {
        return read_picture(request.picture, context);
    } catch (const Error& error) {
        throw error.with_file(request.picture);
    }
}

std::string name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string size_of(const Pixels& p) { return format_text("{} x {}", p.width, p.height); }

}  // namespace

double default_threshold(ReferenceMeasure measure) { return row_of(measure).usual; }

ReferenceResult compare_with_reference(const std::string& picture, const ReferenceRequest& request,
                                       ComparisonPage* page, Context& context) {
    context.progress("compare", 0);
    Pixels reference = read_reference(picture, request, context), made = read_picture(picture, context);
    if (made.width != reference.width || made.height != reference.height)
        throw Error(ErrorCode::check_failed,
                    "the picture has " + size_of(made) + " pixels, its reference '" + one_line(request.picture, 160) +
                        "' has " + size_of(reference),
                    {}, format_text("draw it with 'resolution' {},{}", reference.width, reference.height))
            .naming({"resolution"})
            .with_file(picture);
    const CompareOptions options;
    const ComparedPictures pictures(std::move(made), std::move(reference), options, context);
    const std::string base = name_of(request.picture) == name_of(picture) ? "reference" : name_of(request.picture);
    if (page) page->add({name_of(picture) + " and its reference", name_of(picture), base}, pictures, options, 10);
    ReferenceResult result{.reference = request.picture,
                           .measure = request.measure,
                           .threshold = request.threshold.value_or(default_threshold(request.measure)),
                           .value = value_of(pictures.comparison(), request.measure),
                           .comparison = pictures.comparison()};
    if (!request.difference.empty()) {
        save_difference(pictures, DifferenceKind::flip, 1, request.difference);
        result.difference = request.difference;
    }
    CompareLimits limits;
    limits.*row_of(request.measure).limit = result.threshold;
    result.passed = check_limits(result.comparison, limits).empty();
    return result;
}

std::string to_text(const ReferenceResult& r) {
    const Measure& m = row_of(r.measure);
    if (!r.value) return std::string(m.title) + ": pictures with a side under 11 pixels have none";
    const char* than =
        r.passed ? (m.is_least ? ", at least " : ", at most ") : (m.is_least ? ", less than " : ", more than ");
    return std::string(m.title) + " " + short_digits(*r.value) + m.unit + than + short_digits(r.threshold);
}

}  // namespace rakelight
