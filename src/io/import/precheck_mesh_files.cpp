// SPDX-License-Identifier: Apache-2.0
// STL, PLY and OFF: what the header promises against what the file holds.
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "io/import/precheck.h"

namespace rakelight::io {
namespace {

std::string_view text_of(const Suspect& s) { return {reinterpret_cast<const char*>(s.bytes.data()), s.bytes.size()}; }

std::uint64_t count_of(std::string_view text, std::string_view word) {
    std::uint64_t n = 0;
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + word.size())) ++n;
    return n;
}

/// Cuts the next word off; empty at the end.
std::string_view next_word(std::string_view& rest) {
    const std::size_t begin = rest.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return rest = {};
    const std::size_t end = std::min(rest.find_first_of(" \t\r\n", begin), rest.size());
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

/// Skips lines that begin with "comment".
void skip_comments(std::string_view& rest) {
    for (std::string_view after = rest; next_word(after) == "comment"; after = rest)
        rest = after.substr(std::min(after.find_first_of("\r\n"), after.size()));
}

std::uint64_t to_count(std::string_view word, const char* what) {
    std::uint64_t n = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), n);
    if (problem != std::errc() || end != word.data() + word.size() || n > (1ull << 40))
        throw Error(ErrorCode::bad_file,
                    "the number of " + std::string(what) + " is '" + one_line(std::string(word), 40) + "'");
    return n;
}

[[noreturn]] void too_few(const char* what, std::uint64_t promised, std::uint64_t needs, std::uint64_t has) {
    throw Error(ErrorCode::bad_file, "it promises " + std::to_string(promised) + " " + what + " (at least " +
                                         std::to_string(needs) + " bytes), but " + std::to_string(has) +
                                         " bytes are there");
}

void check_ascii_stl(const Suspect& s) {
    const std::string_view text = text_of(s);
    std::string lower(text);  // some writers use capitals
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    const std::uint64_t vertices = count_of(lower, "vertex"), loops = count_of(lower, "outer");
    if (loops == 0) throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no facet");
    if (vertices != loops * 3)
        throw Error(ErrorCode::bad_file, std::to_string(loops) + " facets have " + std::to_string(vertices) +
                                             " vertices instead of three each");
    if (lower.find("endsolid") == std::string::npos)
        s.report.add(Remark::warning, s.path, {}, "the solid has no end; the file is probably cut short");
}

// --- PLY -------------------------------------------------------------------------------------------------------------------

struct PlyProperty {
    std::uint32_t bytes = 0, count_bytes = 0;  ///< count_bytes > 0: a list
    bool index = false;                        ///< a list of vertex numbers
};
struct PlyElement {
    std::string_view name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};
struct PlyHeader {
    bool ascii = true, big_endian = false;
    std::size_t size = 0;
    std::vector<PlyElement> elements;
};

std::uint32_t ply_type_bytes(std::string_view type) {
    static constexpr std::array<std::pair<std::string_view, std::uint32_t>, 16> types = {{{"char", 1},
                                                                                          {"uchar", 1},
                                                                                          {"int8", 1},
                                                                                          {"uint8", 1},
                                                                                          {"short", 2},
                                                                                          {"ushort", 2},
                                                                                          {"int16", 2},
                                                                                          {"uint16", 2},
                                                                                          {"int", 4},
                                                                                          {"uint", 4},
                                                                                          {"int32", 4},
                                                                                          {"uint32", 4},
                                                                                          {"float", 4},
                                                                                          {"float32", 4},
                                                                                          {"double", 8},
                                                                                          {"float64", 8}}};
    for (const auto& [name, bytes] : types)
        if (name == type) return bytes;
    throw Error(ErrorCode::bad_file, "unknown property type '" + one_line(std::string(type), 40) + "'");
}

void parse_property(std::string_view line, PlyHeader& header) {
    if (header.elements.empty()) throw Error(ErrorCode::bad_file, "a property stands before the first element");
    PlyProperty p;
    const std::string_view type = next_word(line);
    if (type == "list") {
        p.count_bytes = ply_type_bytes(next_word(line));
        p.bytes = ply_type_bytes(next_word(line));
        p.index = next_word(line).starts_with("vertex_ind");
    } else {
        p.bytes = ply_type_bytes(type);
    }
    if (header.elements.back().properties.size() >= 1000)
        throw Error(ErrorCode::bad_file, "an element has more than 1000 properties");
    header.elements.back().properties.push_back(p);
}

void parse_format(std::string_view line, PlyHeader& header) {
    const std::string_view format = next_word(line);
    header.ascii = format == "ascii";
    header.big_endian = format == "binary_big_endian";
    if (!header.ascii && !header.big_endian && format != "binary_little_endian")
        throw Error(ErrorCode::bad_file, "unknown PLY format '" + one_line(std::string(format), 40) + "'");
}

PlyHeader parse_ply_header(std::string_view text) {
    PlyHeader header;
    if (!text.starts_with("ply") && !text.starts_with("PLY"))
        throw Error(ErrorCode::bad_file, "not a PLY file (it does not begin with 'ply')");
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = text.find_first_of("\n\r", at);
        if (end == std::string_view::npos) break;
        std::string_view line = text.substr(at, end - at);
        at = end + (text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n' ? 2 : 1);
        const std::string_view key = next_word(line);
        if (key == "format") parse_format(line, header);
        if (key == "property") parse_property(line, header);
        if (key == "element") {
            const std::string_view name = next_word(line);
            if (header.elements.size() >= 100) throw Error(ErrorCode::bad_file, "more than 100 elements");
            header.elements.push_back({name, to_count(next_word(line), "elements"), {}});
        }
        if (key == "end_header") {
            header.size = at;
            return header;
        }
    }
    throw Error(ErrorCode::bad_file, "the header has no end_header");
}

/// A count or a vertex number of 1, 2 or 4 bytes.
std::uint64_t read_number(const unsigned char* p, std::uint32_t bytes, bool big_endian) {
    std::uint64_t v = 0;
    for (std::uint32_t i = 0; i < bytes; ++i) v |= std::uint64_t(p[i]) << (8 * (big_endian ? bytes - 1 - i : i));
    return v;
}

/// Walks over a list. @return false when it runs past the end; `bad` counts vertex numbers out of range.
bool walk_list(const std::span<const unsigned char> data, std::uint64_t& at, const PlyProperty& p, bool big,
               std::uint64_t vertices, std::uint64_t& bad) {
    if (p.count_bytes > data.size() - at) return false;
    const std::uint64_t n = read_number(data.data() + at, p.count_bytes, big);
    at += p.count_bytes;
    if (n > (data.size() - at) / p.bytes) return false;
    for (std::uint64_t i = 0; p.index && p.bytes <= 4 && i < n; ++i)
        bad += read_number(data.data() + at + i * p.bytes, p.bytes, big) >= vertices;
    at += n * p.bytes;
    return true;
}

struct Walk {
    std::uint64_t bytes = 0, bad_indices = 0;
    const PlyElement* short_of = nullptr;  ///< the element that runs past the end
};

Walk walk_binary(const PlyHeader& header, std::span<const unsigned char> data) {
    Walk walk;
    std::uint64_t vertices = 0;
    for (const PlyElement& e : header.elements) {
        if (e.name == "vertex") vertices = e.count;
        for (std::uint64_t i = 0; i < e.count; ++i) {
            if (e.properties.empty()) break;
            for (const PlyProperty& p : e.properties) {
                bool fits = true;
                if (p.count_bytes > 0)
                    fits = walk_list(data, walk.bytes, p, header.big_endian, vertices, walk.bad_indices);
                else if ((fits = p.bytes <= data.size() - walk.bytes))
                    walk.bytes += p.bytes;
                if (fits) continue;
                walk.short_of = &e;
                return walk;
            }
        }
    }
    return walk;
}

/// In text, counts of lists are followed and nothing else is checked: Assimp asks for memory for what they promise.
void check_ascii_lists(const PlyHeader& header, std::string_view text) {
    std::string_view rest = text.substr(header.size);
    for (const PlyElement& e : header.elements)
        for (std::uint64_t i = 0; i < e.count && !e.properties.empty() && !rest.empty(); ++i) {
            skip_comments(rest);
            for (const PlyProperty& p : e.properties) {
                const std::string_view word = next_word(rest);
                if (p.count_bytes == 0) continue;
                std::int64_t n = 0;
                const auto problem = std::from_chars(word.data(), word.data() + word.size(), n).ec;
                if (problem == std::errc::invalid_argument) return;  // from here on it cannot be followed
                if (problem != std::errc() || n < 0 || std::uint64_t(n) > rest.size() / 2 + 1)
                    throw Error(ErrorCode::bad_file,
                                "a list of element '" + one_line(std::string(e.name), 40) + "' promises " +
                                    one_line(std::string(word), 40) + " numbers, but " + std::to_string(rest.size()) +
                                    " bytes follow",
                                line_of(text, text.size() - rest.size()));
                for (std::int64_t k = 0; k < n; ++k) next_word(rest);
            }
        }
}

}  // namespace

void check_stl(const Suspect& s) {
    const std::string_view text = text_of(s);
    const bool solid = text.starts_with("solid");
    if (text.size() >= 84) {
        std::uint32_t count = 0;
        std::memcpy(&count, text.data() + 80, 4);
        const std::uint64_t needs = 84 + std::uint64_t(count) * 50;
        if (needs == text.size()) {
            if (count == 0) throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no triangle");
            if (solid)
                s.report.add(Remark::warning, s.path, {},
                             "it begins with 'solid' like a text STL but is binary, and was read so");
            return;
        }
        const bool binary = !solid || text.substr(0, 512).find('\0') != std::string_view::npos;
        if (binary && needs > text.size()) too_few("triangles", count, needs, text.size());
        if (binary)
            throw Error(ErrorCode::bad_file, std::to_string(text.size() - needs) + " bytes follow the " +
                                                 std::to_string(count) + " triangles that it promises");
    }
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos ||
        !(text.substr(begin).starts_with("solid") || text.substr(begin).starts_with("SOLID")))
        throw Error(ErrorCode::bad_file,
                    "not an STL file (neither text beginning with 'solid' nor the size of a binary one)");
    check_ascii_stl(s);
}

void check_ply(const Suspect& s) {
    const std::string_view text = text_of(s);
    const PlyHeader header = parse_ply_header(text);
    const std::string_view body = text.substr(header.size);
    std::uint64_t vertices = 0;
    for (const PlyElement& e : header.elements) {
        if (e.name == "vertex") vertices += e.count;
        std::uint64_t least = 0;  // bytes of one element: binary sizes, or a digit and a separator
        for (const PlyProperty& p : e.properties)
            least += header.ascii ? 2 : p.count_bytes > 0 ? p.count_bytes : p.bytes;
        if (e.count * least > body.size() + 1) too_few("elements", e.count, e.count * least, body.size());
    }
    if (vertices == 0) throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no vertex");
    if (header.ascii) return check_ascii_lists(header, text);
    const Walk walk = walk_binary(header, {reinterpret_cast<const unsigned char*>(body.data()), body.size()});
    if (walk.short_of)
        throw Error(ErrorCode::bad_file, "the data ends inside element '" +
                                             one_line(std::string(walk.short_of->name), 40) +
                                             "'; the file is cut short or damaged");
    if (walk.bad_indices != 0)
        throw Error(ErrorCode::bad_file, std::to_string(walk.bad_indices) + " vertex numbers are out of range");
    if (walk.bytes < body.size())
        s.report.add(Remark::warning, s.path, {}, "bytes follow the elements that the header promises");
}

void check_off(const Suspect& s) {
    std::string_view rest = text_of(s);
    const auto next_uncommented = [&rest] {
        for (std::string_view word = next_word(rest);; word = next_word(rest)) {
            if (!word.starts_with('#')) return word;
            rest.remove_prefix(std::min(rest.find('\n'), rest.size()));
        }
    };
    const std::string_view key = next_uncommented();
    if (!key.ends_with("OFF")) throw Error(ErrorCode::bad_file, "not an OFF file (it does not begin with 'OFF')");
    std::string_view word = next_uncommented();
    if (word == "BINARY")
        throw Error(ErrorCode::bad_file, "binary OFF files are not supported", {}, "export text OFF or PLY");
    const std::uint64_t vertices = to_count(word, "vertices"), faces = to_count(next_uncommented(), "faces");
    if (vertices * 6 > rest.size() + 1) too_few("vertices", vertices, vertices * 6, rest.size());
    if (faces * 2 > rest.size() + 1) too_few("faces", faces, faces * 2, rest.size());
    if (vertices == 0 || faces == 0)
        throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no vertex or no face");
}

}  // namespace rakelight::io
