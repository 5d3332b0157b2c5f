// SPDX-License-Identifier: Apache-2.0
// User-defined lighting models in GLSL files.
#pragma once
#include <string>
#include <string_view>

namespace rakelight {

/// Whether a value of the key `lighting` is a file: "*.glsl".
bool is_lighting_file(std::string_view word);

/// @throws Error not_found; bad_file: more than 1 MiB, or user_terms() is not defined; both about `lighting`
std::string read_lighting_text(const std::string& path);

}  // namespace rakelight
