// SPDX-License-Identifier: Apache-2.0
#include "io/ply/ply_cursor.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include <rakelight/base/error.h>

#include "base/format_text.h"
#include "base/from_chars.h"

namespace rakelight::io::ply {
namespace {

template <class T>
double as(const char* at, bool is_big_endian) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, at, sizeof bytes);
    if (is_big_endian != (std::endian::native == std::endian::big)) std::reverse(bytes, bytes + sizeof bytes);
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return double(value);
}

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\0'; }

}  // namespace

double binary_number(const char* at, Type type, bool is_big_endian) {
    switch (type) {
        case Type::i8:
            return as<std::int8_t>(at, is_big_endian);
        case Type::u8:
            return as<std::uint8_t>(at, is_big_endian);
        case Type::i16:
            return as<std::int16_t>(at, is_big_endian);
        case Type::u16:
            return as<std::uint16_t>(at, is_big_endian);
        case Type::i32:
            return as<std::int32_t>(at, is_big_endian);
        case Type::u32:
            return as<std::uint32_t>(at, is_big_endian);
        case Type::f32:
            return as<float>(at, is_big_endian);
        case Type::f64:
            return as<double>(at, is_big_endian);
    }
    return 0;
}

Cursor::Cursor(std::string_view file, const Header& header) : file_(file), format_(header.format), at_(header.bytes) {}

void Cursor::skip_blanks() {
    for (;;) {
        while (at_ < file_.size() && is_blank(file_[at_])) ++at_;
        if (file_.substr(at_, 7) != "comment") return;
        at_ = std::min(file_.find_first_of("\r\n", at_), file_.size());
    }
}

double Cursor::word() {
    skip_blanks();
    if (at_ >= file_.size()) ends_here();
    const char* const first = file_.data() + at_ + (file_[at_] == '+' ? 1 : 0);
    const char* const last = file_.data() + file_.size();
    double value = 0;
    const auto [end, problem] = from_chars(first, last, value);
    at_ = std::size_t(end - file_.data());
    if (problem == std::errc() && (end == last || is_blank(*end))) return value;
    while (at_ < file_.size() && !is_blank(file_[at_])) ++at_;
    if (problem == std::errc::result_out_of_range && std::fabs(value) < 1) return 0;
    ++bad_words_;
    return std::numeric_limits<double>::quiet_NaN();
}

double Cursor::binary(Type type) {
    const std::size_t bytes = size_of(type);
    if (bytes > file_.size() - at_) ends_here();
    const double value = binary_number(file_.data() + at_, type, format_ == Format::big_endian);
    at_ += bytes;
    return value;
}

double Cursor::number(Type type) { return format_ == Format::ascii ? word() : binary(type); }

std::uint64_t Cursor::list(const Property& property) {
    if (format_ == Format::ascii) skip_blanks();
    const std::size_t begin = at_;
    const double count = number(*property.count_type);
    const std::size_t follow = file_.size() - at_;
    const std::size_t most = format_ == Format::ascii ? follow / 2 + 1 : follow / size_of(property.type);
    if (count >= 0 && count <= double(most) && count == std::floor(count)) return std::uint64_t(count);
    const std::string written = std::isfinite(count) && std::fabs(count) < 1e18 ? std::to_string(std::int64_t(count))
                                                                                : std::string("no number of");
    throw Error(ErrorCode::bad_file,
                format_text("a list of element '{}' promises {} numbers, but {} bytes follow",
                            one_line(element_->name, 40), written, follow),
                format_ == Format::ascii ? line_of(begin) : std::string());
}

void Cursor::skip(const Property& property) {
    if (!property.count_type) {
        number(property.type);
        return;
    }
    const std::uint64_t count = list(property);
    if (format_ == Format::ascii)
        for (std::uint64_t i = 0; i < count; ++i) word();
    else
        at_ += count * size_of(property.type);  // list() has seen that they are there
}

void Cursor::skip_row(const Element& element) {
    for (const Property& p : element.properties) skip(p);
}

std::string_view Cursor::rows(const Element& element) {
    begin(element);
    const std::uint64_t row = element.least_bytes(format_);
    if (row > 0 && element.count > (file_.size() - at_) / row) ends_here();
    const std::string_view out = file_.substr(at_, element.count * row);
    at_ += out.size();
    return out;
}

bool Cursor::is_at_end() {
    if (format_ == Format::ascii) skip_blanks();
    return at_ >= file_.size();
}

void Cursor::ends_here() const {
    throw Error(ErrorCode::bad_file, "the data ends inside element '" + one_line(element_->name, 40) +
                                         "'; the file is cut short or damaged");
}

std::string Cursor::line_of(std::size_t at) const {
    return "line " + std::to_string(1 + std::count(file_.begin(), file_.begin() + std::ptrdiff_t(at), '\n'));
}

}  // namespace rakelight::io::ply
