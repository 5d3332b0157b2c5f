// SPDX-License-Identifier: Apache-2.0
// Limits of an inspection (<rakelight/tools/inspect.h>): whether a model keeps to them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <rakelight/base/export.h>

namespace rakelight {

struct Inspection;

/// Quality limits of a model. max_seam_deg needs InspectOptions::borders, all other limits need
/// InspectOptions::surfaces. Seams along matched borders count like seams at shared positions.
struct CheckLimits {
    /// [degrees] Absent: not checked. Allow for the error of 8-bit normals, which is up to half a degree. Below 180, a
    /// zero or non-finite normal (SeamTotals::missing_normals) violates the limit: no angle can be measured there.
    std::optional<double> max_seam_deg = 1;
    /// true: the requirement is checked. Meaning of each: docs/inspect.md.
    bool no_degenerate = false, no_t_junctions = false, no_non_manifold = false, consistent_winding = false,
         no_inside_out = false, closed = false, unit_normals = false;
};

/// The names of the limits that are checked, in the order of CheckLimits: "max-seam", "closed".
RL_API std::vector<std::string> names_of(const CheckLimits& limits);

/// The limits that are checked, as text: "max-seam 1, closed".
RL_API std::string to_text(const CheckLimits& limits);

/// A violated limit.
struct CheckFailure {
    std::string limit{};    ///< name of the limit: "max-seam", "no-degenerate", ...
    std::string message{};  ///< one line: the worst place, its value, and the number of other places
};

/// One entry for each violated limit, in the order of CheckLimits; empty: passed.
RL_API std::vector<CheckFailure> check_limits(const Inspection& inspection, const CheckLimits& limits);

}  // namespace rakelight
