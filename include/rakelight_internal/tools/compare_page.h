// SPDX-License-Identifier: Apache-2.0
// Comparisons of pictures (<rakelight/tools/compare.h>) as an HTML page.
#pragma once
#include <string>
#include <vector>

#include <rakelight/base/export.h>

namespace rakelight {

class ComparedPictures;
struct CompareOptions;

/// Whether a name has the ending of a page (.html, .htm). All other names are difference pictures.
RL_API bool is_page(const std::string& path);
/// Checks the name of a difference picture or page before the comparison.
/// @throws Error usage, failed
RL_API void check_comparison_output(const std::string& path);

/// Titles of a comparison on a page.
struct PageTitles {
    std::string title{}, a{}, b{};  ///< `title`: the heading. `a`, `b`: the names of the two pictures
};

/// An HTML page with comparisons: a wipe slider between the two pictures, their difference, the metrics. The file is
/// self-contained.
class RL_API ComparisonPage {
public:
    /// Appends a comparison.
    /// @param gain for DifferenceKind::absolute, > 0
    void add(const PageTitles& titles, const ComparedPictures& pictures, const CompareOptions& options, double gain);
    /// Writes the page.
    /// @throws Error failed
    void save(const std::string& path) const;

private:
    std::vector<std::string> titles_;
    std::string legend_, sections_;
};

}  // namespace rakelight
