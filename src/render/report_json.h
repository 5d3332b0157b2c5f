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

/// {"code": "bad_file", "exit_code": 4, "message": ..., "place": ..., "advice": ...}
Json error_json(const Error& error);

/// What the engine counted, every field of RenderStats by its name.
Json stats_json(const RenderStats& stats);

/// The whole document as text, two spaces a level, a line feed at its end; invalid UTF-8 becomes U+FFFD.
std::string document(const char* schema, Json rows);

}  // namespace rakelight
