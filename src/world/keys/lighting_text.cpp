// SPDX-License-Identifier: Apache-2.0
#include "world/keys/lighting_text.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <rakelight/base/error.h>
#include <rakelight/engines/engine.h>
#include <rakelight_internal/base/file_ending.h>

#include "base/format_text.h"

namespace rakelight {

bool is_lighting_file(std::string_view word) { return file_ending(word) == "glsl"; }

std::string read_shader_file(const std::string& path, const std::string& key, const std::string& function) {
    const std::string name = "'" + one_line(path, 80) + "'";
    std::error_code fault;
    if (!std::filesystem::is_regular_file(path, fault))
        throw Error(ErrorCode::not_found, name + (std::filesystem::exists(path, fault) ? " is not a regular file"
                                                                                       : ": there is no such file"))
            .about(key);
    if (std::filesystem::file_size(path, fault) > max_shader_bytes)
        throw Error(ErrorCode::bad_file, format_text("{} has more than {} bytes", name, max_shader_bytes)).about(key);
    std::ifstream file(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file && !file.eof()) throw Error(ErrorCode::not_found, name + " cannot be read").about(key);
    if (text.find(function) == std::string::npos || text.find('\0') != std::string::npos)
        throw Error(ErrorCode::bad_file, name + " does not define " + function + "()", {}, "see docs/user-shaders.md")
            .about(key);
    return text;
}

bool names_lighting_file(const WorldValue& value) {
    return value.key == "lighting" && !value.words.empty() && is_lighting_file(value.words[0]);
}

}  // namespace rakelight
