// SPDX-License-Identifier: Apache-2.0
#include "engines/shader_macros.h"

#include <algorithm>
#include <map>
#include <optional>

#include <rakelight/base/error.h>

#include "base/format_text.h"
#include "engines/shader_branches.h"

namespace rakelight {
namespace {

// Both are searched one by one.
constexpr std::size_t most_parameters = 64;
constexpr std::size_t most_meanings = 64;  ///< of a name, by branches of #if of which only the driver knows

using List = std::vector<ShaderToken>;
constexpr int deepest = 200;  ///< calls in arguments of calls

struct Macro {
    bool has_parameters = false;
    std::vector<std::string_view> parameters{};
    List body{};
};

/// What a name may stand for.
struct Meanings {
    std::vector<Macro> all;
    bool may_be_itself = false;  ///< it is not sure that the name is defined
    bool is_in_use = false;      ///< its expansion is being read: the name is not expanded again
};
using Table = std::map<std::string_view, Meanings>;

/// Macros that the engine defines and texts use as if they were GLSL (math/prelude.glsl).
Table engine_macros() {
    const auto word = [](std::string_view text) { return ShaderToken{.text = text}; };
    const auto one = [](Macro macro) { return Meanings{.all = {std::move(macro)}}; };
    return {{"RL_FN", one({})},
            {"RL_IN", one({true, {"type"}, {word("type")}})},
            {"RL_INOUT", one({true, {"type"}, {word("inout"), word("type")}})},
            {"real", one({.body = {word("float")}})},
            {"mask", one({.body = {word("bool")}})}};
}

/// Reads tokens, and in place of macros what they stand for. A macro's expansion is a list that is read before what follows,
/// as in the usual preprocessors; its name is not expanded while it is read.
class Expander {
public:
    Expander(const std::string& name, const ShaderTokens& tokens) : name_(name), macros_(engine_macros()) {
        count(tokens.all.size());
        std::size_t at = 0;
        for (const ShaderDirective& directive : tokens.directives) {
            // A call whose brackets hold a directive has no meaning in GLSL: each piece is read by itself.
            expand_piece(tokens.all, at, directive.before);
            at = directive.before;
            take_directive(directive);
        }
        expand_piece(tokens.all, at, tokens.all.size());
    }
    ExpandedShader take() { return std::move(out_); }

private:
    struct Reading {
        List tokens;
        Meanings* of = nullptr;  ///< the macro whose expansion it is
        std::size_t at = 0;
    };

    void expand_piece(const List& all, std::size_t from, std::size_t to) {
        if (branches_.state() == Branch::dead || from == to) return;
        const List expanded = expand({all.begin() + std::ptrdiff_t(from), all.begin() + std::ptrdiff_t(to)});
        out_.all.insert(out_.all.end(), expanded.begin(), expanded.end());
    }

    void take_directive(const ShaderDirective& directive) {
        if (directive.words.empty()) return;
        const std::string_view word = directive.words[0].text;
        const auto is_defined = [this](std::string_view macro) -> std::optional<bool> {
            const auto at = macros_.find(macro);
            if (at == macros_.end()) return is_foreign(macro) ? std::nullopt : std::optional(false);
            return at->second.may_be_itself ? std::nullopt : std::optional(true);
        };
        if (branches_.take(directive, is_defined) || branches_.state() == Branch::dead) return;
        if (word == "define")
            define(directive);
        else if (word == "undef" && directive.words.size() > 1)
            undefine(directive.words[1].text);
        else
            expand({directive.words.begin() + 1, directive.words.end()});  // #if, #line: for their costs
    }
    /// Names that the engine or the driver may define.
    static bool is_foreign(std::string_view macro) {
        for (const std::string_view begin : {"RL_", "rl_", "GL_", "gl_", "m_", "__"})
            if (macro.starts_with(begin)) return true;
        return false;
    }

    void define(const ShaderDirective& directive) {
        const List& words = directive.words;
        if (words.size() < 2 || !words[1].is_word()) refuse_shader(name_, words[0].line, "a #define without a name");
        Macro macro;
        std::size_t at = 2;
        if (words.size() > 2 && words[2] == "(" && !directive.is_spaced) at = take_parameters(words, macro);
        macro.body.assign(words.begin() + std::ptrdiff_t(at), words.end());
        Meanings& known = macros_[words[1].text];
        const bool is_sure = branches_.state() == Branch::live;
        if (is_sure) known = {};
        if (!is_sure && known.all.empty()) known.may_be_itself = true;
        if (!known.all.empty() && known.all[0].has_parameters != macro.has_parameters)
            refuse_shader(name_, words[1].line,
                          "'" + one_line(std::string(words[1].text), 60) + "' is defined with and without parameters");
        const auto is_same = [&](const Macro& other) {
            return std::ranges::equal(other.body, macro.body, {}, &ShaderToken::text, &ShaderToken::text) &&
                   other.parameters == macro.parameters;
        };
        if (std::ranges::none_of(known.all, is_same)) known.all.push_back(std::move(macro));
        if (known.all.size() > most_meanings)
            refuse_shader(
                name_, words[1].line,
                format_text("'{}' has more than {} meanings", one_line(std::string(words[1].text), 60), most_meanings));
    }
    std::size_t take_parameters(const List& words, Macro& macro) const {
        macro.has_parameters = true;
        std::size_t at = 3;
        for (; at < words.size() && words[at] != ")"; ++at) {
            if (words[at].is_word())
                add_parameter(words[at], macro);
            else if (words[at] != ",")
                refuse_shader(name_, words[at].line, "a #define has parameters of another form than (a, b)");
        }
        if (at == words.size()) refuse_shader(name_, words[1].line, "the parameters of a #define do not end");
        return at + 1;
    }
    void add_parameter(const ShaderToken& word, Macro& macro) const {
        if (macro.parameters.size() == most_parameters)
            refuse_shader(name_, word.line, format_text("a #define has more than {} parameters", most_parameters));
        macro.parameters.push_back(word.text);
    }
    void undefine(std::string_view macro) {
        if (branches_.state() == Branch::live)
            macros_.erase(macro);
        else if (const auto at = macros_.find(macro); at != macros_.end())
            at->second.may_be_itself = true;
    }

    void count(std::size_t tokens) {
        made_ += tokens;
        if (made_ > max_macro_tokens)
            refuse_shader(
                name_, line_,
                format_text("the text has more than {} tokens when its macros are expanded to here", max_macro_tokens));
    }

    /// All of it, expanded. Reads no further than its end.
    List expand(List tokens) {
        if (++depth_ > deepest)
            refuse_shader(name_, line_, format_text("calls of macros are nested more than {} deep", deepest));
        std::vector<Reading> stack;
        stack.push_back({std::move(tokens)});
        List out;
        while (const std::optional<ShaderToken> token = next(stack)) take(*token, stack, out);
        --depth_;
        return out;
    }
    static void drop_ended(std::vector<Reading>& stack) {
        while (!stack.empty() && stack.back().at == stack.back().tokens.size()) {
            if (stack.back().of) stack.back().of->is_in_use = false;
            stack.pop_back();
        }
    }
    std::optional<ShaderToken> next(std::vector<Reading>& stack) {
        drop_ended(stack);
        if (stack.empty()) return {};
        Reading& top = stack.back();
        if (!top.of && depth_ == 1) line_ = top.tokens[top.at].line;
        return top.tokens[top.at++];
    }

    void take(ShaderToken token, std::vector<Reading>& stack, List& out) {
        const auto macro = token.is_word() && !token.is_painted ? macros_.find(token.text) : macros_.end();
        if (macro == macros_.end()) return out.push_back(token);
        Meanings& means = macro->second;
        if (means.is_in_use) {
            token.is_painted = true;
            return out.push_back(token);
        }
        std::vector<List> arguments;
        if (means.all[0].has_parameters) {
            drop_ended(stack);
            if (stack.empty() || stack.back().tokens[stack.back().at] != "(") return out.push_back(token);
            arguments = take_arguments(token, stack);
        }
        push_expansion(token, means, arguments, stack);
    }

    /// From "(" to its ")"; commas in brackets divide nothing.
    std::vector<List> take_arguments(const ShaderToken& of, std::vector<Reading>& stack) {
        std::vector<List> arguments(1);
        int open = 0;
        for (;;) {
            const std::optional<ShaderToken> token = next(stack);
            if (!token) refuse_shader(name_, of.line, "the arguments of a macro do not end");
            count(1);  // of calls in calls the same tokens are read again for each
            if (*token == "(" && ++open == 1) continue;
            if (*token == ")" && --open == 0) return arguments;
            if (*token == "," && open == 1)
                arguments.emplace_back();
            else
                arguments.back().push_back(*token);
        }
    }

    void push_expansion(const ShaderToken& name, Meanings& means, const std::vector<List>& arguments,
                        std::vector<Reading>& stack) {
        List made;
        if (means.may_be_itself) put_itself(name, arguments, made);
        for (const Macro& macro : means.all) substitute(macro, arguments, made);
        count(1 + made.size());
        for (ShaderToken& token : made) token.line = name.line;
        means.is_in_use = true;
        stack.push_back({std::move(made), &means});
    }
    static void put_itself(ShaderToken name, const std::vector<List>& arguments, List& made) {
        const auto mark = [&](std::string_view text) { made.push_back({text, name.at, name.line}); };
        name.is_painted = true;
        made.push_back(name);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            mark(i == 0 ? "(" : ",");
            made.insert(made.end(), arguments[i].begin(), arguments[i].end());
        }
        if (!arguments.empty()) mark(")");
    }

    void substitute(const Macro& macro, const std::vector<List>& arguments, List& made) {
        std::vector<std::optional<List>> expanded(arguments.size());
        const List& body = macro.body;
        const auto is_paste = [&](std::size_t i) {
            return i + 1 < body.size() && body[i] == "#" && body[i + 1] == "#";
        };
        bool pastes = false;
        for (std::size_t i = 0; i < body.size(); ++i) {
            if (is_paste(i)) {
                pastes = true, ++i;
                continue;
            }
            const auto parameter = std::ranges::find(macro.parameters, body[i].text);
            const std::size_t number = std::size_t(parameter - macro.parameters.begin());
            const bool is_parameter = parameter != macro.parameters.end() && number < arguments.size();
            List piece{body[i]};
            if (is_parameter && (pastes || is_paste(i + 1))) {
                piece = arguments[number];
            } else if (is_parameter) {
                if (!expanded[number]) expanded[number] = expand(arguments[number]);
                piece = *expanded[number];
            } else if (parameter != macro.parameters.end()) {
                piece.clear();
            }
            count(piece.size());
            append(made, std::move(piece), pastes);
            pastes = false;
        }
    }
    /// @param pastes  the first becomes one token with the last that is there
    void append(List& made, List piece, bool pastes) {
        if (pastes && !made.empty() && !piece.empty()) {
            out_.pasted.push_back(std::string(made.back().text) + std::string(piece[0].text));
            count(out_.pasted.back().size());  // its letters are memory, too
            made.back().text = out_.pasted.back(), made.back().is_painted = false;
            piece.erase(piece.begin());
        }
        made.insert(made.end(), piece.begin(), piece.end());
    }

    const std::string& name_;
    Table macros_;
    ShaderBranches branches_;
    ExpandedShader out_;
    std::size_t made_ = 0;
    int depth_ = 0;
    int line_ = 1;
};

}  // namespace

ExpandedShader expanded_macros(const std::string& name, const ShaderTokens& tokens) {
    return Expander(name, tokens).take();
}

}  // namespace rakelight
