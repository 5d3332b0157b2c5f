// SPDX-License-Identifier: Apache-2.0
// Parsers of values in options and in [render] of world files: numbers, lists, sizes, colors, lights. If a text is
// wrong, a parser throws an Error usage about `setting`, with the expected form. Numbers are parsed by std::from_chars,
// independent of the locale.
#pragma once
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/base/export.h>
#include <rakelight/scene/words.h>

namespace rakelight::values {

/// An Error usage about a setting.
RL_API Error wrong(const std::string& setting, std::string reason, std::string advice = {});

/// Finite numbers separated by commas, exactly `count` of them.
RL_API std::vector<double> numbers(const std::string& setting, std::string_view text, std::size_t count);
/// One finite number.
RL_API double number(const std::string& setting, std::string_view text);
/// One finite number in low..high.
RL_API double number(const std::string& setting, std::string_view text, double low, double high);
/// Three finite numbers.
RL_API dvec3 vector3(const std::string& setting, std::string_view text);

/// An integer in low..high.
RL_API int integer(const std::string& setting, std::string_view text, int low, int high);
/// Integers separated by commas ("1280,720"; a resolution may also be written "1280x720").
RL_API std::vector<int> integers(const std::string& setting, std::string_view text, std::size_t count);

/// A size in bytes: "500M", "1.5G", "1073741824". Units are powers of 1024.
RL_API std::uint64_t byte_size(const std::string& setting, std::string_view text);

/// A display color as linear RGB and alpha: "0.2,0.2,0.2", "#ff8000", "ff8000", "#f80", a name of CSS ("white"), or
/// "transparent".
RL_API vec4 background(const std::string& setting, std::string_view text);
/// The same without "transparent". `advice` is part of the error message.
RL_API vec4 display_color(const std::string& setting, std::string_view text,
                          const char* advice = "write r,g,b from 0 to 1, '#rrggbb' or a name such as white");

/// A light color: linear light "1,0.9,0.8" without negative numbers, or a display color by code or name.
RL_API vec3 light_color(const std::string& setting, std::string_view text);
/// The normalized direction.
RL_API dvec3 unit(const std::string& setting, dvec3 direction);

/// "point:0,2,3:color=1,0.9,0.8:attenuation=1,0,0.1", "directional:0,-1,-1", "spot:...", "ambient:0.1,0.1,0.1";
/// "photometric-point:0,2,3:intensity=100" and the like.
RL_API Light light(const std::string& setting, std::string_view text);

/// "none", "linear:2,30:color=#c0c8d0", "exp:0.1", "exp2:0.1".
RL_API Fog fog(const std::string& setting, std::string_view text);

/// "on", "off"; also "true", "false", "1", "0".
RL_API bool on_off(const std::string& setting, std::string_view text);

/// Whether a text is meant as a number. For numbers, error messages propose no similar word.
RL_API bool is_number(std::string_view text);

/// The index of a text in a list of words.
/// @throws Error usage: the list does not have the text; the message has the nearest word and all words
RL_API std::size_t word_number(const std::string& setting, std::string_view text, std::span<const char* const> names);

/// The value of a word in a fixed list.
template <class T>
T word(const std::string& setting, std::string_view text, std::span<const Word<T>> words) {
    std::vector<const char*> names;
    for (const Word<T>& word : words) names.push_back(word.name);
    return words[word_number(setting, text, names)].value;
}
/// The same for an array.
template <class T, std::size_t n>
T word(const std::string& setting, std::string_view text, const Word<T> (&words)[n]) {
    return word<T>(setting, text, std::span(words));
}
/// The same for an initializer list.
template <class T>
T word(const std::string& setting, std::string_view text, std::initializer_list<Word<T>> words) {
    return word<T>(setting, text, std::span(words.begin(), words.size()));
}

/// The parts between separators; "a,,b" has an empty part.
RL_API std::vector<std::string_view> split(std::string_view text, char separator);
/// The parts of a temporary string would dangle.
template <class Text>
requires std::same_as<std::remove_const_t<Text>, std::string> std::vector<std::string_view> split(Text&& text,
                                                                                                  char separator)
= delete;

}  // namespace rakelight::values
