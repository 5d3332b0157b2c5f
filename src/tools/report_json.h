// SPDX-License-Identifier: Apache-2.0
// Parts that all JSON outputs share. Only for .cpp files: the JSON library is slow to compile.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <rakelight/engine.h>
#include <rakelight/error.h>
#include <rakelight/report.h>

namespace rakelight {

using Json = nlohmann::ordered_json;

Json remarks_json(const std::vector<ReportEntry>& remarks);

/// "failed", "usage", "not_found", "bad_file", "check_failed"
const char* name_of(ErrorCode code);

/// {"code": "bad_file", "exit_code": 4, "message": ..., "place": ..., "advice": ...}
Json error_json(const Error& error);

/// What the engine counted, every field of RenderStats by its name.
Json stats_json(const RenderStats& stats);

/// A document as text in ASCII: names of files may hold characters that turn a terminal's text around or are commands to
/// it, and are escaped as all others beyond. A line feed at its end; invalid UTF-8 becomes U+FFFD.
std::string json_text(const Json& whole, int spaces_a_level = 2);

/// The whole document, as json_text().
std::string document(const char* schema, Json rows);

}  // namespace rakelight
