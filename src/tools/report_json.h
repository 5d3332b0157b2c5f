// SPDX-License-Identifier: Apache-2.0
// Parts that all JSON outputs share. Files that build values include <nlohmann/json.hpp> themselves.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>
#include <rakelight/engines/engine.h>

namespace rakelight {

using Json = nlohmann::ordered_json;

Json remarks_json(const std::vector<ReportEntry>& remarks);

/// "failed", "usage", "not_found", "bad_file", "check_failed"
const char* name_of(ErrorCode code);

/// {"code": "bad_file", "exit_code": 4, "message": ..., "place": ..., "advice": ...}
Json error_json(const Error& error);

/// What the engine counted, every field of RenderStats by its name.
Json stats_json(const RenderStats& stats);

/// A document as ASCII text: all other characters are escaped, since file names may contain ones that reverse a
/// terminal's text or are commands to it. It ends with a line feed; invalid UTF-8 becomes U+FFFD.
std::string json_text(const Json& whole, int spaces_a_level = 2);

/// The whole document, as json_text().
std::string document(const char* schema, Json rows);

}  // namespace rakelight
