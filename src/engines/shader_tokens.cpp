// SPDX-License-Identifier: Apache-2.0
#include "engines/shader_tokens.h"

#include <algorithm>

#include <rakelight/base/error.h>

namespace rakelight {
namespace {

constexpr char line_in_comment = '\v';

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name_begin(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name_char(char c) { return is_name_begin(c) || is_digit(c); }

int line_at(std::string_view text, std::size_t at) { return 1 + int(std::ranges::count(text.substr(0, at), '\n')); }

class Tokenizer {
public:
    Tokenizer(const std::string& name, std::string_view text) : name_(name), text_(text) {
        while (at_ < text_.size()) take_next();
        if (!branches_.empty()) refuse_shader(name, branches_.back(), "an #if begins that does not end");
        out_.last_line = line_;
    }
    ShaderTokens take() { return std::move(out_); }

private:
    char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

    /// Passes blanks and lines that are continued. @return whether there were any
    bool pass_blanks() {
        const std::size_t first = at_;
        for (;; ++at_) {
            const char c = peek();
            if (c == '\\' && (peek(1) == '\n' || (peek(1) == '\r' && peek(2) == '\n')))
                pass_continuation();
            else if (c == line_in_comment)
                ++line_;
            else if (c == '\r' && peek(1) != '\n')
                refuse_shader(name_, line_, "a carriage return stands without a line feed");
            else if (c != ' ' && c != '\t' && c != '\r' && c != '\f')
                return at_ > first;
            if (at_ >= text_.size()) return true;
        }
    }
    /// Leaves at_ at the line feed.
    void pass_continuation() {
        const char before = at_ > 0 ? text_[at_ - 1] : ' ';
        at_ += peek(1) == '\r' ? 2 : 1;
        ++line_;
        if (is_name_char(before) && is_name_char(peek(1)))
            refuse_shader(name_, line_ - 1, "a backslash at the end of the line divides a word");
    }

    void take_next() {
        pass_blanks();
        if (at_ >= text_.size()) return;
        if (peek() == '\n')
            ++line_, is_line_begin_ = true, ++at_;
        else if (peek() == '#' && is_line_begin_)
            take_directive();
        else
            out_.all.push_back(take_token());
    }
    ShaderToken take_token() {
        const std::size_t first = at_++;
        if (is_name_begin(text_[first]))
            while (is_name_char(peek())) ++at_;
        else if (is_digit(text_[first]) || (text_[first] == '.' && is_digit(peek())))
            while (is_name_char(peek()) || peek() == '.') ++at_;
        is_line_begin_ = false;
        return {text_.substr(first, at_ - first), first, line_};
    }
    void take_directive() {
        ShaderDirective directive{.before = out_.all.size()};
        ++at_;
        for (;;) {
            const bool is_spaced = pass_blanks();
            if (directive.words.size() == 2) directive.is_spaced = is_spaced;
            if (at_ >= text_.size() || peek() == '\n') break;
            directive.words.push_back(take_token());
        }
        count_branch(directive);
        out_.directives.push_back(std::move(directive));
        is_line_begin_ = true;
    }
    void count_branch(const ShaderDirective& directive) {
        const std::string_view word = directive.words.empty() ? std::string_view() : directive.words[0].text;
        if (word.starts_with("if")) branches_.push_back(directive.words[0].line);
        if (word != "endif" && word != "else" && word != "elif") return;
        if (branches_.empty())
            refuse_shader(name_, directive.words[0].line, "an #" + std::string(word) + " without its #if");
        if (word == "endif") branches_.pop_back();
    }

    const std::string& name_;
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool is_line_begin_ = true;
    std::vector<int> branches_;  ///< lines of #if that have not ended
    ShaderTokens out_;
};

}  // namespace

bool ShaderToken::is_word() const { return !text.empty() && is_name_begin(text[0]); }

void refuse_shader(const std::string& name, int line, const std::string& reason) {
    throw Error(ErrorCode::bad_file, reason, "line " + std::to_string(line), "see docs/user-shaders.md")
        .with_file(one_line(name, 200));
}

std::string without_comments(const std::string& name, std::string_view text) {
    std::string out(text);
    const auto blank = [&out](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) out[i] = out[i] == '\n' ? line_in_comment : ' ';
    };
    for (std::size_t at = text.find('/'); at < text.size(); at = text.find('/', at)) {
        const std::string_view rest = text.substr(at);
        std::size_t end = at + 1;
        if (rest.starts_with("//")) {
            end = std::min(text.find('\n', at), text.size());
            if (text[end - 1] == '\\' || (text[end - 1] == '\r' && text[end - 2] == '\\'))
                refuse_shader(name, line_at(text, at), "a comment ends with a backslash");
            if (text.substr(at, end - 1 - at).find('\r') != text.npos)
                refuse_shader(name, line_at(text, at), "a carriage return stands without a line feed");
            blank(at, end);
        } else if (rest.starts_with("/*")) {
            end = text.find("*/", at + 2);
            if (end == text.npos) refuse_shader(name, line_at(text, at), "a comment begins that does not end");
            blank(at, end += 2);
        } else if (rest.starts_with("/\\")) {
            refuse_shader(name, line_at(text, at), "a backslash follows a slash");
        }
        at = end;
    }
    return out;
}

ShaderTokens shader_tokens(const std::string& name, std::string_view code) { return Tokenizer(name, code).take(); }

}  // namespace rakelight
