// SPDX-License-Identifier: Apache-2.0
// Numbers of OBJ and MTL text: the same on every machine and in every locale (std::from_chars).
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rakelight::io::obj {

/// A decimal number with optional '+', leading or trailing point, exponent. "nan", "inf" and numbers that overflow
/// double give NaN, numbers too small for double give 0.
/// @return nullopt when the text, all of it, is not a number ("1,5", "3.1+e2", "0x10", "")
std::optional<double> parse_number(std::string_view text);

/// The references of one corner as written, "v", "v/t", "v//n", "v/t/n": 1-based, negative ones count from the end.
struct FaceToken {
    std::int64_t position = 0;
    std::optional<std::int64_t> texcoord, normal;  ///< absent when not written ("1//", "1/")
};

/// The number that begins at `at`, where it is written as most are: an optional '-', up to 15 digits with or without a point, no
/// exponent. Its value is exact: the digits and the power of ten are, and one division rounds. (Clinger 1990, "How to Read Floating
/// Point Numbers Accurately")
/// @return the first byte behind it, or null where something else stands there: parse_number() knows more
const char* take_plain_number(const char* at, const char* end, double& value);

/// As much for a corner: up to nine digits each, no signs.
const char* take_plain_corner(const char* at, const char* end, FaceToken& token);

/// An integer with optional sign. @return nullopt when the text is not one or does not fit in 64 bits
std::optional<std::int64_t> parse_integer(std::string_view text);

/// @return nullopt when the text is not of one of these forms or a number does not fit in 64 bits
std::optional<FaceToken> parse_face_token(std::string_view text);

}  // namespace rakelight::io::obj
