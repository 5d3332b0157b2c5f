// SPDX-License-Identifier: Apache-2.0
// Inspection reports as files: an HTML page, and JUnit XML for build servers.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/image/image.h>
#include <rakelight/tools/inspect.h>
#include <rakelight/tools/rows.h>

namespace rakelight {

/// A heat map on a page.
struct ReportPicture {
    std::string caption{};  ///< below the picture
    Pixels pixels{};
};
/// A heat map with its caption, as 8-bit pixels.
RL_API ReportPicture report_picture(std::string caption, const Frame& frame);

/// An HTML page with the inspection of models: check result, heat maps, seams, faults, objects. The file is
/// self-contained and has no script.
class RL_API InspectionPage {
public:
    /// Appends a model.
    void add(const InspectionRow& row, std::span<const ReportPicture> pictures);
    /// Writes the page.
    /// @throws Error failed
    void save(const std::string& path) const;

private:
    std::string contents_, sections_;
    std::size_t models_ = 0;
};

/// JUnit XML with a test suite for each model. A suite has a test case "load" and a test case for each limit. Failures
/// name the worst object. If a model cannot be read, the test case "load" has an error. Format:
/// https://github.com/testmoapp/junitxml
RL_API std::string to_junit(std::span<const InspectionRow> rows, const CheckLimits& limits);

}  // namespace rakelight
