// SPDX-License-Identifier: Apache-2.0
// STL: what the header promises against what the file holds.
#include <cstdint>
#include <cstring>
#include <string_view>

#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "io/import/precheck.h"

namespace rakelight::io {
namespace {

std::string_view text_of(const Suspect& s) { return {reinterpret_cast<const char*>(s.bytes.data()), s.bytes.size()}; }

std::uint64_t count_of(std::string_view text, std::string_view word) {
    std::uint64_t n = 0;
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + word.size())) ++n;
    return n;
}

[[noreturn]] void too_few(const char* what, std::uint64_t promised, std::uint64_t needs, std::uint64_t has) {
    throw Error(ErrorCode::bad_file, format_text("it promises {} {} (at least {} bytes), but {} bytes are there",
                                                 promised, what, needs, has));
}

void check_ascii_stl(const Suspect& s) {
    const std::string_view text = text_of(s);
    const std::string lower = lower_case(text);  // some writers use capitals
    const std::uint64_t vertices = count_of(lower, "vertex"), loops = count_of(lower, "outer");
    if (loops == 0) throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no facet");
    if (vertices != loops * 3)
        throw Error(ErrorCode::bad_file,
                    format_text("{} facets have {} vertices instead of three each", loops, vertices));
    if (lower.find("endsolid") == std::string::npos)
        s.report.add(Remark::warning, s.path, {}, "the solid has no end; the file is probably cut short");
}

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
                             "it begins with 'solid' like a text STL, but it is binary and was read as such");
            return;
        }
        const bool binary = !solid || text.substr(0, 512).find('\0') != std::string_view::npos;
        if (binary && needs > text.size()) too_few("triangles", count, needs, text.size());
        if (binary)
            throw Error(ErrorCode::bad_file,
                        format_text("{} bytes follow the {} triangles that it declares", text.size() - needs, count));
    }
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos ||
        !(text.substr(begin).starts_with("solid") || text.substr(begin).starts_with("SOLID")))
        throw Error(ErrorCode::bad_file,
                    "not an STL file (neither text beginning with 'solid' nor the size of a binary one)");
    check_ascii_stl(s);
}

}  // namespace

constinit const Precheck stl_precheck = {"stl", check_stl};

}  // namespace rakelight::io
