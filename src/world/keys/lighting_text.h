// SPDX-License-Identifier: Apache-2.0
// User-defined shaders in GLSL files.
#pragma once
#include <string>
#include <string_view>

#include <rakelight/io/world.h>

namespace rakelight {

/// Whether a value of the key `lighting` is a file: "*.glsl".
bool is_lighting_file(std::string_view word);

/// @param key       of [render], which errors are about
/// @param function  that the text must define
/// @throws Error not_found; bad_file: more than max_shader_bytes, or `function` is not there
std::string read_shader_file(const std::string& path, const std::string& key, const std::string& function);

/// Whether the value of the key "lighting" is such a file.
bool names_lighting_file(const WorldValue& value);

}  // namespace rakelight
