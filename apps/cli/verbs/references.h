// SPDX-License-Identifier: Apache-2.0
// render --ref: each picture is held against a reference picture when it is there.
#pragma once
#include <string>
#include <vector>

#include <rakelight/tools/rows.h>
#include <rakelight_internal/tools/compare_page.h>
#include <rakelight_internal/tools/reference.h>

#include "../run.h"

namespace rakelight::cli {

/// --ref and what goes with it.
std::vector<Option> reference_options();

/// The references of all pictures of a run.
class References {
public:
    /// @throws Error usage: no reference for each picture, a picture that is its own reference, a wrong threshold or name
    References(const Run& run, const std::vector<InputRequest>& requests);

    /// Compares the picture that was made of an input, if that is requested. @throws Error as compare_with_reference()
    void check(std::size_t number, PictureRow& row, Context& context);
    /// Prints what is wrong, one line; returns the exit code.
    int print_failure(const PictureRow& row) const;
    /// Writes the page of all differences, where one is requested.
    void finish(std::vector<PictureRow>& rows);

private:
    std::vector<ReferenceRequest> requests_;  ///< one for each picture, or none
    std::string page_name_;
    ComparisonPage page_;
    bool has_any_ = false;  ///< on the page
    Loudness loudness_;
};

}  // namespace rakelight::cli
