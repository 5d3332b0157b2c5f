// SPDX-License-Identifier: Apache-2.0
// Logical lines of OBJ and MTL text, with the place of every word in the file. Nothing is copied: the reader serves
// both loading and rewriting a file line by line (the bytes [Line::begin, Line::next) of all lines are the whole file).
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

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

private:
    std::string_view file_;
    std::size_t at_, end_;
};

class LineReader {
public:
    /// @param file  the whole file; a UTF-8 byte order mark is skipped (and is part of no line)
    explicit LineReader(std::string_view file);
    bool next(Line& line);  ///< false at the end of the file
    /// The words after the keyword.
    Tokens arguments(const Line& line) const { return {file_, line.keyword.end(), line.end}; }
    bool saw_lone_cr() const { return saw_lone_cr_; }  ///< a line so far ended in CR alone (old Mac text)

private:
    std::size_t line_end(std::size_t from);
    std::string_view file_;
    std::size_t at_ = 0, next_lf_ = 0, next_cr_ = 0;
    bool lf_known_ = false, cr_known_ = false, saw_lone_cr_ = false;
    std::uint64_t number_ = 1;
};

/// The text of [begin, end) as a name: blanks at both ends dropped, a joined line end and NUL bytes read as one blank
/// each, inner blanks kept ("Material name with many, many spaces", "texture 01.png").
std::string name_text(std::string_view file, std::size_t begin, std::size_t end);

/// Lower case of ASCII letters; other bytes stay.
std::string ascii_lower(std::string_view text);

}  // namespace rakelight::io::obj
