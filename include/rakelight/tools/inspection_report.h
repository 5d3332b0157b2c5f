// SPDX-License-Identifier: Apache-2.0
// Inspections as files: a page for people, and JUnit's XML for build servers.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <rakelight/export.h>
#include <rakelight/image.h>
#include <rakelight/inspect.h>
#include <rakelight/tools/rows.h>

namespace rakelight {

/// A heat map of a page.
struct ReportPicture {
    std::string caption{};  ///< below the picture
    Pixels pixels{};
};
/// A heat map with its caption, as 8-bit pixels.
RL_API ReportPicture report_picture(std::string caption, const Frame& frame);

/// Models on one page, one after the other: whether they pass, heat maps, seams, faults, objects. One file of HTML that refers to nothing
/// outside of it and has no script.
class RL_API InspectionPage {
public:
    /// Adds a model below those that are there.
    void add(const InspectionRow& row, std::span<const ReportPicture> pictures);
    /// The whole page. @throws Error failed
    void save(const std::string& path) const;

private:
    std::string contents_, sections_;
    std::size_t models_ = 0;
};

/// A test suite for each model, with a test case "load" and one for each limit: failures say which object is worst. A model that
/// cannot be read is an error of "load".
/// Format: https://github.com/testmoapp/junitxml
RL_API std::string to_junit(std::span<const InspectionRow> rows, const CheckLimits& limits);

}  // namespace rakelight
