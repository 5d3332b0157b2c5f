// SPDX-License-Identifier: Apache-2.0
#include "world/lighting_text.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <rakelight/error.h>
#include <rakelight/tools/file_ending.h>

#include "base/format_text.h"

namespace rakelight {

bool is_lighting_file(std::string_view word) { return file_ending(word) == "glsl"; }

std::string read_lighting_text(const std::string& path) {
    constexpr std::uintmax_t max_bytes = 1 << 20;
    const std::string name = "'" + one_line(path, 80) + "'";
    std::error_code fault;
    if (!std::filesystem::is_regular_file(path, fault))
        throw Error(ErrorCode::not_found, name + ": there is no such file").about("lighting");
    if (std::filesystem::file_size(path, fault) > max_bytes)
        throw Error(ErrorCode::bad_file, format_text("{} has more than {} bytes", name, max_bytes)).about("lighting");
    std::ifstream file(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file && !file.eof()) throw Error(ErrorCode::not_found, name + " cannot be read").about("lighting");
    if (text.find("user_terms") == std::string::npos || text.find('\0') != std::string::npos)
        throw Error(ErrorCode::bad_file, name + " does not define user_terms()", {}, "see docs/opengl.md")
            .about("lighting");
    return text;
}

}  // namespace rakelight
