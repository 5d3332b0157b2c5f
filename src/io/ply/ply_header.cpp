// SPDX-License-Identifier: Apache-2.0
#include "io/ply/ply_header.h"

#include <algorithm>
#include <charconv>

#include <rakelight/base/error.h>

#include "base/format_text.h"

namespace rakelight::io::ply {
namespace {

struct TypeName {
    std::string_view name;
    Type type;
};
constexpr TypeName type_names[] = {
    {"char", Type::i8},   {"uchar", Type::u8},   {"int8", Type::i8},     {"uint8", Type::u8},
    {"short", Type::i16}, {"ushort", Type::u16}, {"int16", Type::i16},   {"uint16", Type::u16},
    {"int", Type::i32},   {"uint", Type::u32},   {"int32", Type::i32},   {"uint32", Type::u32},
    {"float", Type::f32}, {"double", Type::f64}, {"float32", Type::f32}, {"float64", Type::f64}};

std::string in_quotes(std::string_view word) { return "'" + one_line(std::string(word), 40) + "'"; }

/// Cuts the next word off a line; empty at its end.
std::string_view next_word(std::string_view& line) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return line = {};
    const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

Type type_of(std::string_view word) {
    for (const TypeName& known : type_names)
        if (known.name == word) return known.type;
    throw Error(ErrorCode::bad_file, "unknown property type " + in_quotes(word));
}

Property property_of(std::string_view line) {
    Property p;
    std::string_view type = next_word(line);
    if (type == "list") {
        p.count_type = type_of(next_word(line));
        type = next_word(line);
    }
    p.type = type_of(type);
    p.name = next_word(line);
    return p;
}

Format format_of(std::string_view word) {
    if (word == "ascii") return Format::ascii;
    if (word == "binary_little_endian") return Format::little_endian;
    if (word == "binary_big_endian") return Format::big_endian;
    throw Error(ErrorCode::bad_file, "unknown PLY format " + in_quotes(word));
}

std::uint64_t count_of(std::string_view word) {
    std::uint64_t n = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), n);
    if (problem != std::errc() || end != word.data() + word.size() || n > (1ull << 40))
        throw Error(ErrorCode::bad_file, "the number of elements is " + in_quotes(word));
    return n;
}

/// Of one line of the header. @return false at its end
bool read_line(std::string_view line, Header& header) {
    const std::string_view key = next_word(line);
    if (key == "end_header") return false;
    if (key == "format") header.format = format_of(next_word(line));
    if (key == "comment" && next_word(line) == "TextureFile") {
        const std::size_t begin = line.find_first_not_of(" \t"), end = line.find_last_not_of(" \t");
        if (begin != std::string_view::npos) header.textures.emplace_back(line.substr(begin, end + 1 - begin));
    }
    if (key == "element") {
        if (header.elements.size() >= 100) throw Error(ErrorCode::bad_file, "more than 100 elements");
        const std::string_view name = next_word(line);
        header.elements.push_back({std::string(name), count_of(next_word(line)), {}});
    }
    if (key == "property") {
        if (header.elements.empty()) throw Error(ErrorCode::bad_file, "a property stands before the first element");
        std::vector<Property>& properties = header.elements.back().properties;
        if (properties.size() >= 1000) throw Error(ErrorCode::bad_file, "an element has more than 1000 properties");
        properties.push_back(property_of(line));
    }
    return true;
}

void check_counts(const Header& header, std::uint64_t body) {
    for (const Element& e : header.elements) {
        const std::uint64_t least = e.least_bytes(header.format);
        if (least > 0 && e.count > (body + 1) / least)
            throw Error(ErrorCode::bad_file,
                        format_text("it promises {} elements (at least {} bytes), but {} bytes are there", e.count,
                                    e.count * least, body));
    }
}

}  // namespace

std::size_t size_of(Type type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[std::size_t(type)];
}

bool Element::has_lists() const {
    return std::ranges::any_of(properties, [](const Property& p) { return p.count_type.has_value(); });
}

std::uint64_t Element::least_bytes(Format format) const {
    std::uint64_t bytes = 0;
    for (const Property& p : properties) bytes += format == Format::ascii ? 2 : size_of(p.count_type.value_or(p.type));
    return bytes;
}

Header read_header(std::string_view file) {
    if (!file.starts_with("ply") && !file.starts_with("PLY"))
        throw Error(ErrorCode::bad_file, "not a PLY file (it does not begin with 'ply')");
    Header header;
    for (std::size_t at = 0; at < file.size();) {
        const std::size_t end = file.find_first_of("\n\r", at);
        if (end == std::string_view::npos) break;
        const std::string_view line = file.substr(at, end - at);
        at = end + (file[end] == '\r' && end + 1 < file.size() && file[end + 1] == '\n' ? 2 : 1);
        if (read_line(line, header)) continue;
        header.bytes = at;
        check_counts(header, file.size() - at);
        return header;
    }
    throw Error(ErrorCode::bad_file, "the header has no end_header");
}

}  // namespace rakelight::io::ply
