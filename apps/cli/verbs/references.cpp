// SPDX-License-Identifier: Apache-2.0
#include "references.h"

#include <algorithm>
#include <filesystem>

#include <rakelight/world/values.h>
#include <rakelight_internal/base/exit_code.h>
#include <rakelight_internal/base/text.h>
#include <rakelight_internal/tools/compare_page.h>
#include <rakelight_internal/tools/reference.h>

#include "../inputs.h"
#include "../output_names.h"

namespace rakelight::cli {
namespace {

namespace fs = std::filesystem;
constexpr const char* group = "Reference (exit code 5 beyond the threshold)";

/// The value that was given by one of two names.
std::string_view given_name(const Run& run, const char* name, const char* other) {
    return run.given.first_of({name, other});
}

/// A name for each input, by a template.
std::vector<std::string> names_by_template(const Run& run, const std::vector<InputRequest>& requests,
                                           const std::string& name_template) {
    Run named = run;
    named.picture.output = name_template;
    OutputNames names(named, requests.size());
    std::vector<std::string> all;
    for (const InputRequest& request : requests) all.push_back(names.of(request.picture.input));
    return all;
}

/// One for each picture: by name, by a template, or of the picture's own name in a folder.
std::vector<std::string> reference_names(const Run& run, std::string_view option,
                                         const std::vector<InputRequest>& requests) {
    const std::vector<std::string> given = run.given.words(option);
    if (given.size() > 1) {
        if (given.size() != requests.size())
            throw values::wrong(std::string(option),
                                std::to_string(given.size()) + " references for " + counted(requests.size(), "picture"),
                                "give one for each, a folder, or a name with {model}");
        return given;
    }
    if (means_folder(given[0]) && means_folder(run.picture.output))  // folders below it count too
        return names_by_template(run, requests, given[0]);
    if (means_folder(given[0])) {
        std::vector<std::string> names;
        for (const InputRequest& request : requests)
            names.push_back((fs::path(given[0]) / fs::path(request.picture.output).filename()).string());
        return names;
    }
    if (requests.size() > 1 && given[0].find('{') == std::string::npos)
        throw values::wrong(std::string(option), "several pictures need a reference each",
                            "write for example --ref 'references/{model}.png', or --ref FOLDER");
    return names_by_template(run, requests, given[0]);
}

bool is_same_file(const std::string& a, const std::string& b) {
    std::error_code ignored;
    return fs::path(a).lexically_normal() == fs::path(b).lexically_normal() || fs::equivalent(a, b, ignored);
}

ReferenceRequest request_by_options(const Run& run) {
    ReferenceRequest request;
    if (const std::string_view measure = given_name(run, "ref-measure", "reference-measure"); !measure.empty())
        request.measure = values::word("ref-measure", run.given.word(measure), reference_measure_words);
    if (const std::string_view threshold = given_name(run, "ref-threshold", "reference-threshold"); !threshold.empty())
        request.threshold = values::number("ref-threshold", run.given.word(threshold));
    if (request.measure != ReferenceMeasure::ssim && request.threshold && *request.threshold < 0)
        throw values::wrong("ref-threshold", "must be 0 or more");
    return request;
}

}  // namespace

std::vector<Option> reference_options() {
    using enum apps::Form;
    std::vector<Option> options = {
        {"ref", group, "PICTURE",
         "Compare what was drawn with this picture. For several models a name with {model}, a folder that holds a "
         "picture of each output's name, or --ref once for each",
         list},
        {.name = "ref-measure",
         .group = group,
         .type = "M",
         .help = "Measure to compare by: flip (default), rmse (0 if equal), psnr, ssim (larger is more similar)",
         .words = apps::names_of<reference_measure_words>},
        {"ref-threshold", group, "X",
         "Largest allowed flip or rmse (default 0.01), smallest allowed psnr (default 40 dB) or ssim (default 0.99)"},
        {"ref-diff", group, "FILE",
         "Write where they differ: a picture of the FLIP value of each pixel ({model} as above), or an .html page of "
         "all comparisons"},
    };
    const std::pair<const char*, std::size_t> others[] = {
        {"reference", 0}, {"reference-measure", 1}, {"reference-threshold", 2}};
    for (const auto& [name, of] : others) {
        options.push_back(options[of]);
        options.back().name = name, options.back().is_hidden = true;
    }
    return options;
}

References::References(const Run& run, const std::vector<InputRequest>& requests) : loudness_(run.loudness) {
    const std::string_view option = given_name(run, "ref", "reference");
    if (option.empty()) {
        const std::string_view other = run.given.first_of(
            {"ref-measure", "ref-threshold", "ref-diff", "reference-measure", "reference-threshold"});
        if (!other.empty())
            throw Error(ErrorCode::usage, "needs a reference", {}, "add --ref PICTURE").about(std::string(other));
        return;
    }
    const ReferenceRequest all = request_by_options(run);
    const std::vector<std::string> names = reference_names(run, option, requests);
    const std::string difference = run.given.word("ref-diff");
    const bool has_pictures = !difference.empty() && !is_page(difference);
    const auto differences =
        has_pictures ? names_by_template(run, requests, difference) : std::vector<std::string>(requests.size());
    if (!difference.empty() && !has_pictures) check_comparison_output(page_name_ = difference);
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const std::string& output = requests[i].picture.output;
        if (is_same_file(names[i], output))
            throw values::wrong(std::string(option), "the picture would be written over its reference",
                                "give -o another name");
        if (has_pictures && (is_same_file(differences[i], output) || is_same_file(differences[i], names[i])))
            throw values::wrong("ref-diff", "the difference would be written over the picture or its reference");
        if (has_pictures) check_comparison_output(differences[i]);
        requests_.push_back(all);
        requests_.back().picture = names[i], requests_.back().difference = differences[i];
    }
}

void References::check(std::size_t number, PictureRow& row, Context& context) {
    if (requests_.empty() || context.cancelled()) return;
    row.reference =
        compare_with_reference(row.result.output, requests_[number], page_name_.empty() ? nullptr : &page_, context);
    has_any_ = true;
}

int References::print_failure(const PictureRow& row) const {
    if (!row.reference) return 0;
    const std::string& reference = row.reference->reference;
    const std::string text = to_text(*row.reference);
    if (row.reference->passed) {
        print_note(row.result.output + ": as the reference " + reference + ": " + text, loudness_);
        return 0;
    }
    print_error(Error(ErrorCode::check_failed, "differs from the reference '" + one_line(reference, 160) + "': " + text)
                    .with_file(row.result.output));
    return exit_code(ErrorCode::check_failed);
}

void References::finish(std::vector<PictureRow>& rows) {
    if (page_name_.empty() || !has_any_) return;
    page_.save(page_name_);
    for (PictureRow& row : rows)
        if (row.reference) row.reference->difference = page_name_;
}

}  // namespace rakelight::cli
