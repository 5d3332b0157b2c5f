// SPDX-License-Identifier: Apache-2.0
// Lighting models of the user's own, as files in GLSL.
#pragma once
#include <string>
#include <string_view>

namespace rakelight {

/// Whether a value of the key `lighting` names a file: "*.glsl".
bool is_lighting_file(std::string_view word);

/// @throws Error not_found; bad_file: more than 1 MiB, or no text that defines user_terms(); both about `lighting`
std::string read_lighting_text(const std::string& path);

}  // namespace rakelight
