// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/error.h>

#include <cstdint>
#include <utility>

namespace rakelight {
namespace {

/// Length of the UTF-8 sequence at text[i], or 0 if it is invalid or a control character.
std::size_t printable_bytes(const std::string& text, std::size_t i) {
    const auto byte = [&](std::size_t k) { return std::uint8_t(k < text.size() ? text[k] : 0); };
    const std::uint8_t first = byte(i);
    if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
    const std::size_t length = first >= 0xF0 && first < 0xF5 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 0;
    if (length == 0 || first >= 0xF5) return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((byte(i + k) & 0xC0) != 0x80) return 0;
    const std::uint8_t second = byte(i + 1), third = byte(i + 2);
    // Overlong forms, surrogates, beyond U+10FFFF.
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) || (first == 0xF0 && second < 0x90) ||
        (first == 0xF4 && second >= 0x90))
        return 0;
    if (first == 0xC2 && second < 0xA0) return 0;  // C1 control characters
    // Line separators and bidirectional controls: U+061C, U+200E-F, U+2028-E, U+2066-9.
    if (first == 0xD8 && second == 0x9C) return 0;
    if (first == 0xE2 && second == 0x80 && (third == 0x8E || third == 0x8F || (third >= 0xA8 && third <= 0xAE)))
        return 0;
    if (first == 0xE2 && second == 0x81 && third >= 0xA6 && third <= 0xA9) return 0;
    return length;
}

}  // namespace

std::string one_line(const std::string& text, std::size_t max_bytes) {
    std::string line;
    std::size_t cut = 0;  // where "..." still fits after it
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t n = printable_bytes(text, i);
        if (line.size() + (n ? n : 1) > max_bytes) return line.substr(0, cut) + "...";
        if (n)
            line.append(text, i, n);
        else
            line += '?';
        i += n ? n : 1;
        if (line.size() + 3 <= max_bytes) cut = line.size();
    }
    return line;
}

Error::Error(ErrorCode code, std::string reason, std::string place, std::string advice)
    : code_(code), reason_(std::move(reason)), place_(std::move(place)), advice_(std::move(advice)) {
    compose();
}

Error Error::with_file(const std::string& file) const {
    Error copy = *this;
    if (copy.file_.empty()) copy.file_ = file;
    copy.compose();
    return copy;
}

Error Error::at(const std::string& place) const {
    Error copy = *this;
    copy.place_ = place;
    copy.compose();
    return copy;
}

Error Error::about(const std::string& setting, std::vector<std::string> related) const {
    Error copy = *this;
    copy.setting_ = setting;
    copy.related_ = std::move(related);
    copy.compose();
    return copy;
}

Error Error::as(ErrorCode code) const {
    Error copy = *this;
    copy.code_ = code;
    return copy;
}

Error Error::advising(const std::string& advice) const {
    Error copy = *this;
    copy.advice_ += advice;
    copy.compose();
    return copy;
}

Error Error::naming(std::vector<std::string> settings) const {
    Error copy = *this;
    copy.related_.insert(copy.related_.end(), settings.begin(), settings.end());
    return copy;
}

void Error::compose() {
    text_.clear();
    if (!file_.empty()) text_ += one_line(file_, 300) + ": ";
    if (!place_.empty()) text_ += one_line(place_, 120) + ": ";
    if (!setting_.empty()) text_ += one_line(setting_, 60) + ": ";
    text_ += one_line(reason_, 300);
    if (!advice_.empty()) text_ += "; " + one_line(advice_, 300);
    text_ = one_line(text_, 600);
}

}  // namespace rakelight
