// SPDX-License-Identifier: Apache-2.0
// Logical lines of OBJ and MTL text, with the place of every word in the file. Nothing is copied: the reader serves
// both loading and rewriting a file line by line (the bytes [Line::begin, Line::next) of all lines are the whole file).
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rakelight::io::obj {

/// A word and where it stands: bytes [begin, end()) of the file.
struct Token {
    std::string_view text;
    std::size_t begin = 0;
    std::size_t end() const { return begin + text.size(); }
};

/// One logical line: physical lines that a backslash at the very end joins. A comment line is never joined to the next
/// one (comments hold Windows paths).
struct Line {
    std::uint64_t number = 0;  ///< 1, 2, ... of its first physical line; LF, CR LF and CR alone end a line
    std::size_t begin = 0;     ///< first byte
    std::size_t end = 0;       ///< one past the last byte before the line end
    std::size_t next = 0;      ///< first byte of the next logical line
    Token keyword;             ///< empty for a blank or comment line
};

/// Words of [begin, end) of a file, split at blanks, tabs, NUL bytes and joined line ends. A word that begins with '#'
/// ends the line.
class Tokens {
public:
    Tokens(std::string_view file, std::size_t begin, std::size_t end) : file_(file), at_(begin), end_(end) {}
    bool next(Token& token);                ///< false when there are no more words
    std::size_t at() const { return at_; }  ///< where the next word is looked for

    /// For most lines, whose words end in a single blank or at the line's end. Calls take(first, end) with the start
    /// of the next word, and continues after the word's end if that function knows it. @return false: next() is to be
    /// asked
    template <class Take>
    bool next_plain(const Take& take) {
        const char* const begin = file_.data() + at_;
        const char* const end = file_.data() + end_;
        const char* const first = begin != end && *begin == ' ' ? begin + 1 : begin;
        const char* const behind = first != end ? take(first, end) : nullptr;
        if (behind) at_ = std::size_t(behind - file_.data());
        return behind != nullptr;
    }

private:
    std::string_view file_;
    std::size_t at_, end_;
};

/// A part of a file that holds whole logical lines: bytes [begin, end).
struct Chunk {
    std::size_t begin = 0, end = 0;
};

/// What chunks are about as long as. A constant: where they lie must not depend on threads. Small enough for what is made of
/// one to stay in the L2 cache.
inline constexpr std::size_t usual_chunk_bytes = 512 << 10;

/// The file cut at ends of logical lines, each chunk at the first one that is `bytes` or more from its begin. A UTF-8 byte
/// order mark is in no chunk. An empty file has none.
std::vector<Chunk> chunks_of(std::string_view file, std::size_t bytes = usual_chunk_bytes);

class LineReader {
public:
    /// @param file  the whole file; a UTF-8 byte order mark is skipped (and is part of no line)
    explicit LineReader(std::string_view file);
    /// The lines of one chunk. @param first_line  the number of its first one
    LineReader(std::string_view file, Chunk chunk, std::uint64_t first_line = 1);
    bool next(Line& line);  ///< false at the end of the file, or chunk
    /// The words after the keyword.
    Tokens arguments(const Line& line) const { return {file_, line.keyword.end(), line.end}; }
    bool saw_lone_cr() const { return saw_lone_cr_; }      ///< a line so far ended in CR alone (old Mac text)
    std::uint64_t next_number() const { return number_; }  ///< of the line that next() gives next

private:
    std::size_t line_end(std::size_t from);
    std::string_view file_;
    std::size_t at_ = 0, next_lf_ = 0, next_cr_ = 0;
    bool lf_known_ = false, cr_known_ = false, saw_lone_cr_ = false;
    std::uint64_t number_ = 1;
};

/// The text of [begin, end) as a name. Blanks at both ends are dropped, and a joined line end and NUL bytes read as one
/// blank each. Inner blanks are kept ("Material name with many, many spaces", "texture 01.png").
std::string name_text(std::string_view file, std::size_t begin, std::size_t end);

}  // namespace rakelight::io::obj
