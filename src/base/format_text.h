// SPDX-License-Identifier: Apache-2.0
// Formatted text: format_text("index {} at corner {}", index, corner). Patterns are those of fmt and std::format,
// checked at compile time. The result does not depend on the locale.
#pragma once
#include <string>

#include <fmt/core.h>

namespace rakelight {

/// Formats the arguments. Callers need no library: the code of fmt is in format_text.cpp.
std::string format_arguments(fmt::string_view pattern, fmt::format_args arguments);

/// @param pattern a literal: "{}" is the next value, "{:.6g}" has six significant digits, "{{" is a brace
template <class... T>
std::string format_text(fmt::format_string<const T&...> pattern, const T&... values) {
    return format_arguments(pattern, fmt::make_format_args(values...));
}

}  // namespace rakelight
