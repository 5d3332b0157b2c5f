// SPDX-License-Identifier: Apache-2.0
// GLSL as tokens and preprocessor lines, as the driver's preprocessor will see it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace rakelight {

/// A word, a number or one character of another kind.
struct ShaderToken {
    std::string_view text;
    std::size_t at = 0;  ///< in the whole text
    int line = 1;
    bool is_painted = false;  ///< a macro's name that is not expanded again
    bool is_word() const;     ///< a name or keyword
    bool operator==(std::string_view other) const { return text == other; }
};

/// A line that begins with #.
struct ShaderDirective {
    std::vector<ShaderToken> words;  ///< behind the #; may be empty
    std::size_t before = 0;          ///< it stands before this one of ShaderTokens::all
    bool is_spaced = false;          ///< a blank follows the second word: "#define A (x)" has no parameters
};

struct ShaderTokens {
    std::vector<ShaderToken> all;  ///< outside of directives
    std::vector<ShaderDirective> directives;
    int last_line = 1;
};

/// @throws Error bad_file, with file and line
[[noreturn]] void refuse_shader(const std::string& name, int line, const std::string& reason);

/// The text with blanks in place of comments; a line's end in a comment is a vertical tab, as it ends no directive.
/// @throws Error bad_file: a comment does not end, or its line ends with a backslash, which drivers read differently
std::string without_comments(const std::string& name, std::string_view text);

/// @param code  without comments; must outlive the result
/// @throws Error bad_file: #if that do not end, a word that a backslash divides, a carriage return alone
ShaderTokens shader_tokens(const std::string& name, std::string_view code);

}  // namespace rakelight
