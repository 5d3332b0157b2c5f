// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_numbers.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "base/from_chars.h"

namespace rakelight::io::obj {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A well-formed number that from_chars called out of range: is it too large (else too small)? By the decimal exponent
/// of its first digit that is not 0.
bool is_overflow(std::string_view text) {
    std::int64_t magnitude = 0, exponent = 0;
    bool seen_digit = false, seen_point = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == 'e' || c == 'E') {
            std::string_view digits = text.substr(i + 1);
            const bool is_negative = !digits.empty() && digits[0] == '-';
            if (!digits.empty() && (digits[0] == '-' || digits[0] == '+')) digits.remove_prefix(1);
            const auto r = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
            if (r.ec == std::errc::result_out_of_range) exponent = std::numeric_limits<std::int64_t>::max() / 4;
            if (is_negative) exponent = -exponent;
            break;
        }
        if (c == '.') seen_point = true;
        if (c > '0' && c <= '9') seen_digit = true;
        if (c >= '0' && c <= '9') magnitude += seen_point ? (seen_digit ? 0 : -1) : (seen_digit ? 1 : 0);
    }
    return magnitude + exponent > 0;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where a word surely ends. Other blanks, and a backslash that joins lines, are left to Tokens.
bool is_behind_word(const char* at, const char* end) { return at == end || *at == ' '; }

/// Up to nine digits, or none. @return behind them; null: there are more
const char* take_digits(const char* at, const char* end, std::uint32_t& number) {
    const char* const begin = at;
    number = 0;
    for (; at != end && is_digit(*at); ++at) number = number * 10 + std::uint32_t(*at - '0');
    return at - begin <= 9 ? at : nullptr;
}

}  // namespace

const char* take_plain_number(const char* at, const char* end, double& value) {
    static constexpr double powers[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const bool is_negative = at != end && *at == '-';
    at += is_negative;
    const char* const begin = at;
    std::uint64_t digits = 0;
    for (; at != end && is_digit(*at); ++at) digits = digits * 10 + std::uint64_t(*at - '0');
    std::ptrdiff_t count = at - begin, behind = 0;
    if (at != end && *at == '.') {
        const char* const point = at++;
        for (; at != end && is_digit(*at); ++at) digits = digits * 10 + std::uint64_t(*at - '0');
        behind = at - point - 1;
        count += behind;
    }
    if (count < 1 || count > 15 || !is_behind_word(at, end)) return nullptr;
    value = double(digits) / powers[behind];
    if (is_negative) value = -value;
    return at;
}

const char* take_plain_corner(const char* at, const char* end, FaceToken& token) {
    std::uint32_t number = 0;
    const char* digits = take_digits(at, end, number);
    if (!digits || digits == at) return nullptr;
    token.position = number;
    token.texcoord.reset(), token.normal.reset();
    for (std::optional<std::int64_t>* const part : {&token.texcoord, &token.normal}) {
        if (digits == end || *digits != '/') break;
        at = digits + 1;
        digits = take_digits(at, end, number);
        if (!digits) return nullptr;
        if (digits != at) *part = number;
    }
    return is_behind_word(digits, end) ? digits : nullptr;
}

std::optional<double> parse_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc::result_out_of_range) return is_overflow(text) ? nan : 0.0;
    return std::isfinite(value) ? value : nan;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || error != std::errc()) return std::nullopt;
    return value;
}

std::optional<FaceToken> parse_face_token(std::string_view text) {
    FaceToken token;
    if (take_plain_corner(text.data(), text.data() + text.size(), token) == text.data() + text.size()) return token;
    std::array<std::string_view, 3> parts;
    std::size_t count = 0;
    for (;;) {
        if (count == parts.size()) return std::nullopt;
        const std::size_t slash = text.find('/');
        parts[count++] = text.substr(0, slash);
        if (slash == std::string_view::npos) break;
        text.remove_prefix(slash + 1);
    }
    token = {};
    const auto position = parse_integer(parts[0]);
    if (!position) return std::nullopt;
    token.position = *position;
    if (!parts[1].empty() && !(token.texcoord = parse_integer(parts[1]))) return std::nullopt;
    if (!parts[2].empty() && !(token.normal = parse_integer(parts[2]))) return std::nullopt;
    return token;
}

}  // namespace rakelight::io::obj
