// SPDX-License-Identifier: Apache-2.0
#include "engines/shader_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <rakelight/base/error.h>

#include "base/format_text.h"
#include "base/from_chars.h"
#include "engines/shader_arrays.h"
#include "engines/shader_macros.h"
#include "engines/shader_tokens.h"

namespace rakelight {
namespace {

constexpr std::size_t most_variables = 64;  ///< of a kind in a text
constexpr int most_elements = 16;           ///< of an array

bool is_word(std::string_view text) { return ShaderToken{text}.is_word(); }

/// Reads declarations; what stands in brackets is passed over.
class Declarations {
public:
    Declarations(const std::string& name, ShaderText& out, const std::vector<ShaderToken>& tokens)
        : name_(name), out_(out), tokens_(tokens) {
        while (at_ < tokens_.size()) take_statement();
    }

private:
    std::string_view peek() const { return at_ < tokens_.size() ? tokens_[at_].text : std::string_view(); }
    int line() const { return tokens_[std::min(at_, tokens_.size() - 1)].line; }
    std::string_view next() {
        const std::string_view text = peek();
        ++at_;
        return text;
    }

    /// To behind the bracket that closes the one here.
    void pass_brackets() {
        std::vector<ShaderToken> open;
        do {
            const ShaderToken& t = tokens_[at_++];
            if (t.text == "(" || t.text == "{" || t.text == "[") open.push_back(t);
            if (t.text != ")" && t.text != "}" && t.text != "]") continue;
            const std::string_view begin = t.text == ")" ? "(" : t.text == "}" ? "{" : "[";
            if (open.empty() || open.back().text != begin)
                refuse_shader(name_, t.line, "'" + std::string(t.text) + "' closes nothing");
            open.pop_back();
        } while (!open.empty() && at_ < tokens_.size());
        if (!open.empty())
            refuse_shader(name_, open.back().line, "'" + std::string(open.back().text) + "' is not closed");
    }

    /// One declaration or function.
    void take_statement() {
        for (const std::size_t first = at_; at_ < tokens_.size();) {
            const std::string_view word = peek();
            if (word == "uniform" || word == "in" || word == "out") {
                if (at_ != first)
                    refuse_shader(name_, line(),
                                  "'" + std::string(word) + "' must begin its declaration, without qualifiers");
                return take_declaration();
            }
            if (word.size() == 1 && std::string_view("({[)}]").find(word[0]) != std::string_view::npos) {
                pass_brackets();
                if (word == "{" && peek() != ";" && peek() != "=") return;
                continue;
            }
            ++at_;
            if (word == ";") return;
        }
    }

    void take_declaration() {
        const std::size_t begin = tokens_[at_].at;
        const std::string_view kind = next();
        if (peek() == "highp" || peek() == "mediump" || peek() == "lowp") ++at_;
        const std::string type(next());
        constexpr std::string_view known[] = {"float", "int", "vec2", "vec3", "vec4"};
        const bool is_known = std::ranges::find(known, type) != std::end(known);
        if (!is_known || (type == "int" && kind != "uniform"))
            refuse_shader(
                name_, line(),
                format_text("'{} {}' is not supported: declare {}", std::string(kind), one_line(type, 40),
                            kind == "uniform" ? "float, int, vec2, vec3 or vec4" : "float, vec2, vec3 or vec4"));
        auto& all = kind == "uniform" ? out_.uniforms : kind == "in" ? out_.inputs : out_.outputs;
        do {
            all.push_back(take_variable(type, kind == "uniform"));
            if (all.size() > most_variables)
                refuse_shader(name_, line(), format_text("more than {} of '{}'", most_variables, std::string(kind)));
        } while (peek() == "," && ++at_);
        if (peek() != ";") refuse_shader(name_, line(), "';' is missing after a declaration");
        const std::size_t end = tokens_[at_++].at + 1;
        for (std::size_t i = begin; i < end; ++i)
            if (out_.body[i] != '\n') out_.body[i] = ' ';
    }

    ShaderVariable take_variable(const std::string& type, bool is_uniform) {
        ShaderVariable v{.type = type, .name = std::string(peek()), .line = line()};
        check_name(v);
        ++at_;
        v.value.assign(std::size_t(v.components()), 0.0f);
        if (peek() == "[") {
            if (is_uniform) refuse_shader(name_, v.line, "'" + v.name + "': a uniform cannot be an array");
            ++at_;
            const std::string_view count = next();
            const auto [end, fault] = std::from_chars(count.data(), count.data() + count.size(), v.count);
            if (fault != std::errc() || end != count.data() + count.size() || v.count < 1 || v.count > most_elements ||
                next() != "]")
                refuse_shader(name_, v.line, format_text("'{}' must have 1 to {} elements", v.name, most_elements));
        }
        if (peek() == "=") {
            if (!is_uniform) refuse_shader(name_, v.line, "'" + v.name + "': only a uniform can have a value here");
            ++at_;
            take_value(v);
        }
        return v;
    }

    void check_name(const ShaderVariable& v) const {
        if (!is_word(v.name)) refuse_shader(name_, v.line, "a name is missing in a declaration");
        if (v.name.size() > max_uniform_name)
            refuse_shader(name_, v.line, format_text("a name has more than {} characters", max_uniform_name));
        for (const std::string_view own : {"rl_", "RL_", "gl_", "m_", "v_", "a_", "o_"})
            if (v.name.starts_with(own))
                refuse_shader(name_, v.line,
                              format_text("'{}': names with '{}' are the engine's", v.name, std::string(own)));
        for (const auto* const all : {&out_.uniforms, &out_.inputs, &out_.outputs})
            if (std::ranges::find(*all, v.name, &ShaderVariable::name) != all->end())
                refuse_shader(name_, v.line, "'" + v.name + "' is declared twice");
    }

    float take_number(const ShaderVariable& v) {
        const bool is_negative = peek() == "-";
        if (is_negative || peek() == "+") ++at_;
        std::string text(next());
        while (!text.empty() && (text.back() == 'e' || text.back() == 'E') && (peek() == "-" || peek() == "+")) {
            text += next();
            text += next();
        }
        if (text.ends_with('f') || text.ends_with('F')) text.pop_back();
        float value = 0;
        const char* const begin = text.data();
        const auto [end, fault] = from_chars(begin, begin + text.size(), value);
        if (fault != std::errc() || end != begin + text.size() || !std::isfinite(value))
            refuse_shader(name_, v.line, "the value of '" + v.name + "' must be a number, or " + v.type + "(numbers)");
        return is_negative ? -value : value;
    }

    /// 1.5, vec3(1.0), vec3(1.0, 2.0, 3.0)
    void take_value(ShaderVariable& v) {
        const std::size_t n = std::size_t(v.components());
        if (n == 1) {
            v.value[0] = take_number(v);
        } else {
            std::vector<float> numbers;
            const bool is_vector = next() == v.type && next() == "(";
            do
                if (is_vector) numbers.push_back(take_number(v));
            while (is_vector && numbers.size() < n && peek() == "," && ++at_);
            if (!is_vector || next() != ")" || (numbers.size() != 1 && numbers.size() != n))
                refuse_shader(name_, v.line, "the value of '" + v.name + "' must be " + v.type + "(numbers)");
            for (std::size_t i = 0; i < n; ++i) v.value[i] = numbers[numbers.size() == 1 ? 0 : i];
        }
        if (v.type == "int" && v.value[0] != std::trunc(v.value[0]))
            refuse_shader(name_, v.line, "the value of '" + v.name + "' must be a whole number");
    }

    const std::string& name_;
    ShaderText& out_;
    const std::vector<ShaderToken>& tokens_;
    std::size_t at_ = 0;
};

}  // namespace

ShaderText parse_shader_text(const std::string& name, std::string_view text) {
    ShaderText out{.body = std::string(text)};
    const std::string code = without_comments(name, text);
    const ShaderTokens tokens = shader_tokens(name, code);
    check_shader_arrays(name, expanded_macros(name, tokens).all);
    out.last_line = tokens.last_line;
    if (!tokens.all.empty()) Declarations(name, out, tokens.all);
    return out;
}

}  // namespace rakelight
