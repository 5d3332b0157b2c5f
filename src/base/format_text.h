// SPDX-License-Identifier: Apache-2.0
// Text with numbers and names in it: format_text("index {} at corner {}", index, corner). The pattern language is that of fmt and
// std::format, checked while compiling; no locale changes the result.
#pragma once
#include <string>

#include <fmt/core.h>

namespace rakelight {

/// The pattern with its arguments put in. Callers need no library: all of fmt that runs is in format_text.cpp.
std::string format_arguments(fmt::string_view pattern, fmt::format_args arguments);

/// @param pattern  a literal; "{}" is the next value, "{:.6g}" with six significant digits, "{{" a brace
template <class... T>
std::string format_text(fmt::format_string<const T&...> pattern, const T&... values) {
    return format_arguments(pattern, fmt::make_format_args(values...));
}

}  // namespace rakelight
