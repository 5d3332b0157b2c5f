// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_lines.h"

#include <array>
#include <cstring>

namespace rakelight::io::obj {
namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// What a byte is between words: 0 a part of one, 1 a blank, 2 the backslash that may join lines.
constexpr std::array<unsigned char, 256> kinds = [] {
    std::array<unsigned char, 256> k{};
    for (const char c : {' ', '\t', '\0', '\v', '\f', '\n', '\r'}) k[static_cast<unsigned char>(c)] = 1;
    k[static_cast<unsigned char>('\\')] = 2;
    return k;
}();

unsigned kind_of(char c) { return kinds[static_cast<unsigned char>(c)]; }
bool is_blank(char c) { return kind_of(c) == 1; }

std::size_t find(std::string_view file, std::size_t from, char c) {
    const void* hit = from < file.size() ? std::memchr(file.data() + from, c, file.size() - from) : nullptr;
    return hit ? std::size_t(static_cast<const char*>(hit) - file.data()) : file.size();
}

/// A blank, or the backslash that joins two lines (at the end of the file: with nothing).
bool is_gap(std::string_view file, std::size_t i, std::size_t end) {
    const unsigned kind = kind_of(file[i]);
    return kind == 1 || (kind == 2 && (i + 1 == end || is_line_end(file[i + 1])));
}

std::size_t after_byte_order_mark(std::string_view file) { return file.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0; }

/// Where a physical line ends that holds byte `at` and that no backslash joins to the next one: the first byte behind its line
/// end.
std::size_t logical_end(std::string_view file, std::size_t at) {
    for (; at < file.size(); ++at) {
        if (!is_line_end(file[at])) continue;
        if (file[at] == '\r' && at + 1 < file.size() && file[at + 1] == '\n') ++at;
        const bool is_crlf = file[at] == '\n' && at > 0 && file[at - 1] == '\r';
        const std::size_t end = at - (is_crlf ? 1 : 0);  // of the line without what ends it
        if (end == 0 || file[end - 1] != '\\') return at + 1;
    }
    return file.size();
}

}  // namespace

bool Tokens::next(Token& token) {
    while (at_ < end_ && is_gap(file_, at_, end_)) ++at_;
    if (at_ >= end_ || file_[at_] == '#') {
        at_ = end_;
        return false;
    }
    const std::size_t begin = at_;
    while (at_ < end_ && !is_gap(file_, at_, end_)) ++at_;
    token = {file_.substr(begin, at_ - begin), begin};
    return true;
}

std::vector<Chunk> chunks_of(std::string_view file, std::size_t bytes) {
    std::vector<Chunk> chunks;
    for (std::size_t begin = after_byte_order_mark(file); begin < file.size();) {
        const std::size_t wanted = file.size() - begin <= bytes ? file.size() : begin + bytes;
        chunks.push_back({begin, wanted < file.size() ? logical_end(file, wanted - 1) : wanted});
        begin = chunks.back().end;
    }
    return chunks;
}

LineReader::LineReader(std::string_view file) : file_(file), at_(after_byte_order_mark(file)) {}

LineReader::LineReader(std::string_view file, Chunk chunk, std::uint64_t first_line)
    : file_(file.substr(0, chunk.end)), at_(chunk.begin), number_(first_line) {}

// Both positions are remembered: a file of CR lines would otherwise be searched for LF to its end at every line.
std::size_t LineReader::line_end(std::size_t from) {
    if (!lf_known_ || next_lf_ < from) next_lf_ = find(file_, from, '\n');
    if (!cr_known_ || next_cr_ < from) next_cr_ = find(file_, from, '\r');
    lf_known_ = cr_known_ = true;
    return next_lf_ < next_cr_ ? next_lf_ : next_cr_;
}

bool LineReader::next(Line& line) {
    if (at_ >= file_.size()) return false;
    line.number = number_;
    line.begin = at_;
    line.keyword = {};
    bool is_comment = false, is_joined = true;
    for (bool is_first = true; is_joined; is_first = false) {
        const std::size_t start = at_;
        line.end = line_end(start);
        if (is_first) {
            std::size_t i = start;
            while (i < line.end && is_blank(file_[i])) ++i;
            is_comment = i < line.end && file_[i] == '#';
        }
        at_ = line.end;
        if (at_ < file_.size()) {
            const bool is_crlf = file_[at_] == '\r' && at_ + 1 < file_.size() && file_[at_ + 1] == '\n';
            if (file_[at_] == '\r' && !is_crlf) saw_lone_cr_ = true;
            at_ += is_crlf ? 2 : 1;
        }
        ++number_;
        is_joined = !is_comment && line.end > start && file_[line.end - 1] == '\\' && at_ < file_.size();
    }
    line.next = at_;
    Tokens words(file_, line.begin, line.end);
    if (is_comment || !words.next(line.keyword)) line.keyword = {file_.substr(line.end, 0), line.end};
    return true;
}

std::string name_text(std::string_view file, std::size_t begin, std::size_t end) {
    while (begin < end && is_gap(file, begin, end)) ++begin;
    while (end > begin && is_blank(file[end - 1])) --end;
    std::string name;
    for (std::size_t i = begin; i < end; ++i) {
        if (file[i] == '\\' && i + 1 < end && is_line_end(file[i + 1])) {
            if (file[i + 1] == '\r' && i + 2 < end && file[i + 2] == '\n') ++i;
            ++i;
            name += ' ';
        } else {
            name += file[i] == '\0' ? ' ' : file[i];
        }
    }
    return name;
}

}  // namespace rakelight::io::obj
