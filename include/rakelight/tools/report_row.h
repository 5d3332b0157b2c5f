// SPDX-License-Identifier: Apache-2.0
// The JSON reports of the program. A report has one row per file; a row has the result and remarks, or the error. The rows
// of a verb are in its header. Reports are in UTF-8, with invalid bytes replaced, and end with a line feed.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>

namespace rakelight {

/// Common members of all rows.
struct ReportRow {
    std::vector<ReportEntry> remarks{};
    /// Report::left_out()
    std::uint64_t remarks_left_out = 0;
    std::optional<Error> error{};
};

}  // namespace rakelight
