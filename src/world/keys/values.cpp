// SPDX-License-Identifier: Apache-2.0

#include <rakelight/world/values.h>

#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/format_text.h"

namespace rakelight::values {
namespace {

[[noreturn]] void refuse(const std::string& option, std::string_view text, const std::string& expected) {
    throw wrong(option, "'" + one_line(std::string(text), 60) + "' is not " + expected);
}

template <class T>
bool parse(std::string_view text, T& value) {
    if (text.starts_with('+')) text.remove_prefix(1);  // from_chars takes none
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::size_t word_number(const std::string& setting, std::string_view text, std::span<const char* const> names) {
    std::string all;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (same_word(text, names[i])) return i;
        all += (i > 0 ? ", " : "") + std::string(names[i]);
    }
    if (is_number(text)) throw wrong(setting, "'" + one_line(std::string(text), 40) + "' is not one of " + all);
    const std::string nearest = nearest_word(text, {names.begin(), names.end()});
    throw wrong(setting, "unknown word '" + one_line(std::string(text), 40) + "'",
                (nearest.empty() ? "" : "did you mean '" + nearest + "'? ") + "use one of: " + all);
}

Error wrong(const std::string& setting, std::string reason, std::string advice) {
    return Error(ErrorCode::usage, std::move(reason), {}, std::move(advice)).about(setting);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t at = text.find(separator);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

std::vector<double> numbers(const std::string& option, std::string_view text, std::size_t count) {
    const std::string expected = count == 1 ? "a number" : format_text("{} numbers separated by commas", count);
    const std::vector<std::string_view> parts = split(text, ',');
    if (parts.size() != count) refuse(option, text, expected);
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
        if (!parse(parts[i], values[i]) || !std::isfinite(values[i])) refuse(option, text, expected);
    return values;
}

bool is_number(std::string_view text) {
    double value = 0;
    return parse(text, value);
}

double number(const std::string& option, std::string_view text) { return numbers(option, text, 1)[0]; }

double number(const std::string& option, std::string_view text, double low, double high) {
    const double value = number(option, text);
    if (value >= low && value <= high) return value;
    char limits[80];
    std::snprintf(limits, sizeof limits, "must be %.9g to %.9g", low, high);
    throw wrong(option, limits);
}

bool on_off(const std::string& option, std::string_view text) {
    for (const char* const word : {"on", "true", "1"})
        if (same_word(text, word)) return true;
    for (const char* const word : {"off", "false", "0"})
        if (same_word(text, word)) return false;
    throw wrong(option, "must be on or off, not '" + one_line(std::string(text), 40) + "'");
}

dvec3 vector3(const std::string& option, std::string_view text) {
    const std::vector<double> v = numbers(option, text, 3);
    return {v[0], v[1], v[2]};
}

int integer(const std::string& option, std::string_view text, int low, int high) {
    int value = 0;
    if (!parse(text, value) || value < low || value > high)
        refuse(option, text, format_text("a whole number from {} to {}", low, high));
    return value;
}

std::vector<int> integers(const std::string& option, std::string_view text, std::size_t count) {
    const char separator = count == 2 && text.find(',') == std::string_view::npos ? 'x' : ',';
    const std::vector<std::string_view> parts = split(text, separator);
    const std::string expected =
        format_text("{} whole numbers separated by {}", count, count == 2 ? "a comma or x" : "commas");
    if (parts.size() != count) refuse(option, text, expected);
    std::vector<int> values(count);
    for (std::size_t i = 0; i < count; ++i)
        if (!parse(parts[i], values[i])) refuse(option, text, expected);
    return values;
}

std::uint64_t byte_size(const std::string& option, std::string_view text) {
    constexpr std::string_view units = "KMGT";
    const char* const expected = "a size such as 500M or 4G";
    std::string_view digits = text;
    int shift = 0;
    if (digits.ends_with("iB"))
        digits.remove_suffix(2);
    else if (digits.ends_with('B'))
        digits.remove_suffix(1);
    if (!digits.empty()) {
        const char last = digits.back() >= 'a' ? char(digits.back() - 'a' + 'A') : digits.back();
        if (const std::size_t unit = units.find(last); unit != std::string_view::npos) {
            shift = 10 * int(unit + 1);
            digits.remove_suffix(1);
        }
    }
    std::uint64_t whole = 0;
    if (parse(digits, whole)) {
        if (whole == 0 || whole > (~0ull >> shift)) refuse(option, text, expected);
        return whole << shift;
    }
    double value = 0;
    const double bytes = parse(digits, value) ? value * double(std::uint64_t{1} << shift) : 0;
    if (!(bytes >= 1 && bytes < 18446744073709551616.0)) refuse(option, text, expected);
    return std::uint64_t(bytes);
}

}  // namespace rakelight::values
