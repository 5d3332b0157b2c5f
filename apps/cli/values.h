// SPDX-License-Identifier: Apache-2.0
// Option values as people write them: numbers, lists, sizes, colors, lights. All throw Error usage that says what was
// expected; numbers go by std::from_chars, so no locale changes them.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rakelight/error.h>
#include <rakelight/scene.h>

namespace rakelight::cli {

/// Finite numbers separated by commas, exactly `count` of them. `option` is for the message.
std::vector<double> numbers(const std::string& option, std::string_view text, std::size_t count);
double number(const std::string& option, std::string_view text);
dvec3 vector3(const std::string& option, std::string_view text);

/// An integer in low..high.
int integer(const std::string& option, std::string_view text, int low, int high);
/// Integers separated by commas ("1280,720"; a resolution may also be written "1280x720").
std::vector<int> integers(const std::string& option, std::string_view text, std::size_t count);

/// "500M", "1.5G", "1073741824": bytes, powers of 1024.
std::uint64_t byte_size(const std::string& option, std::string_view text);

/// Display color "0.2,0.2,0.2", "#ff8000", "ff8000", "#f80", or "transparent": linear RGB and alpha.
vec4 background(const std::string& option, std::string_view text);
/// The same without "transparent". `advice` says what may be written.
vec4 display_color(const std::string& option, std::string_view text,
                   const char* advice = "write r,g,b from 0 to 1 or '#rrggbb'");

/// "point:0,2,3:color=1,0.9,0.8:attenuation=1,0,0.1", "directional:0,-1,-1", "spot:...", "ambient:0.1,0.1,0.1".
Light light(const std::string& option, std::string_view text);

/// The value of a word out of a fixed list.
template <class T>
T word(const std::string& option, std::string_view text, std::initializer_list<std::pair<const char*, T>> words) {
    std::string all;
    for (const auto& [name, value] : words) {
        if (text == name) return value;
        all += (all.empty() ? "" : ", ") + std::string(name);
    }
    throw Error(ErrorCode::usage, option + ": unknown word '" + one_line(std::string(text), 40) + "'", {},
                "use one of: " + all);
}

/// Parts between separators; "a,,b" has an empty one.
std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace rakelight::cli
