// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_contents.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/name_table.h"

namespace rakelight::io::obj {
namespace {

constexpr std::uint64_t lines_between_checks = 1 << 16;

/// What one chunk tells of the file, beside its counts.
struct Counted {
    std::uint64_t elements = 0, lines = 0, lone_cr_line = 0, nul_line = 0;  ///< lines: numbers in the chunk, 0: none
    bool has_objects = false, has_smoothing = false;
    std::vector<std::string> libraries;
};

/// The number of the line that holds the chunk's first NUL byte, or 0.
std::uint64_t find_nul(std::string_view text) {
    const void* const nul = std::memchr(text.data(), '\0', text.size());
    if (!nul) return 0;
    std::uint64_t line = 1;
    for (const char* c = text.data(); c != nul; ++c) line += *c == '\n' || (*c == '\r' && c[1] != '\n');
    return line;
}

class ChunkCounter {
public:
    ChunkCounter(std::string_view file, ChunkContents& chunk, Counted& counted)
        : file_(file), chunk_(chunk), counted_(counted) {}

    void count(const Context& context) {
        counted_.nul_line = find_nul(file_.substr(chunk_.chunk.begin, chunk_.chunk.end - chunk_.chunk.begin));
        LineReader lines(file_, chunk_.chunk);
        for (Line line; lines.next(line);) {
            if (line.number % lines_between_checks == 0) context.throw_if_cancelled();
            if (!line.keyword.text.empty()) add(line);
            if (lines.saw_lone_cr() && counted_.lone_cr_line == 0) counted_.lone_cr_line = line.number;
        }
        counted_.lines = lines.next_number() - 1;
    }

private:
    void add(const Line& line) {
        const std::string_view key = line.keyword.text;
        if (key == "v" || key == "vt" || key == "vn") {
            ++(key.size() == 1 ? chunk_.positions : key[1] == 't' ? chunk_.texcoords : chunk_.normals);
            chunk_.vertices_end = line.next;
            return;
        }
        ++chunk_.others;
        if (key == "f" || key == "fo" || key == "l" || key == "p")
            ++counted_.elements;
        else if (key == "o")
            counted_.has_objects = true;
        else if (key == "s")
            counted_.has_smoothing = true;
        else if (key == "mtllib") {
            std::string name = name_text(file_, line.keyword.end(), line.end);
            if (!name.empty() && names_.insert(name).second) counted_.libraries.push_back(std::move(name));
        }
    }

    std::string_view file_;
    ChunkContents& chunk_;
    Counted& counted_;
    NameSet names_;
};

/// Sums over the chunks before, and of all.
void add_up(std::vector<Counted>& counted, Contents& contents, Remarks& remarks) {
    NameSet libraries;
    std::uint64_t line = 1;
    for (std::size_t i = 0; i < counted.size(); ++i) {
        ChunkContents& chunk = contents.chunks[i];
        Counted& c = counted[i];
        chunk.first_line = line;
        chunk.positions_before = contents.positions, contents.positions += chunk.positions;
        chunk.texcoords_before = contents.texcoords, contents.texcoords += chunk.texcoords;
        chunk.normals_before = contents.normals, contents.normals += chunk.normals;
        contents.elements += c.elements;
        contents.has_objects |= c.has_objects;
        contents.has_smoothing |= c.has_smoothing;
        for (std::string& name : c.libraries)
            if (libraries.insert(name).second) contents.libraries.push_back(std::move(name));
        const auto first = [&](Issue issue, std::uint64_t in_chunk) {
            if (in_chunk > 0 && remarks.count(issue) == 0) remarks.add(issue, line + in_chunk - 1);
        };
        first(Issue::lone_cr, c.lone_cr_line);
        first(Issue::nul_bytes, c.nul_line);
        line += c.lines;
    }
}

}  // namespace

Contents count_contents(std::string_view file, Remarks& remarks, Context& context, std::size_t chunk_bytes) {
    Contents contents;
    for (const Chunk& chunk : chunks_of(file, chunk_bytes)) contents.chunks.push_back({.chunk = chunk});
    std::vector<Counted> counted(contents.chunks.size());
    context.parallel_for(counted.size(),
                         [&](std::size_t i) { ChunkCounter(file, contents.chunks[i], counted[i]).count(context); });
    add_up(counted, contents, remarks);
    const std::uint64_t most = std::max({contents.positions, contents.texcoords, contents.normals});
    if (most >= std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorCode::bad_file, "more than 4294967294 vertices are not supported");
    return contents;
}

}  // namespace rakelight::io::obj
