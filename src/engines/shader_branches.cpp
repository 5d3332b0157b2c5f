// SPDX-License-Identifier: Apache-2.0
#include "engines/shader_branches.h"

namespace rakelight {
namespace {

/// Of #if and #elif: numbers, and "defined A" with or without brackets; nothing else is evaluated.
std::optional<bool> condition_of(const std::vector<ShaderToken>& words,
                                 const std::function<std::optional<bool>(std::string_view)>& is_defined) {
    if (words.size() == 2 && words[1] == "0") return false;
    if (words.size() == 2 && words[1] == "1") return true;
    if (words.size() == 3 && words[1] == "defined") return is_defined(words[2].text);
    if (words.size() == 5 && words[1] == "defined" && words[2] == "(" && words[4] == ")")
        return is_defined(words[3].text);
    return {};
}

}  // namespace

/// The next branch of the innermost #if.
void ShaderBranches::enter(std::optional<bool> condition) {
    Open& open = open_.back();
    open.had_live |= open.state == Branch::live;
    open.had_unknown |= open.state == Branch::unknown;
    if (open.outside == Branch::dead || open.had_live || condition == false)
        open.state = Branch::dead;
    else
        open.state = condition && !open.had_unknown ? open.outside : Branch::unknown;
    if (condition == true && !open.had_unknown) open.had_live = true;  // also where it is unknown for what is outside
}

bool ShaderBranches::take(const ShaderDirective& directive,
                          const std::function<std::optional<bool>(std::string_view)>& is_defined) {
    const std::vector<ShaderToken>& words = directive.words;
    const std::string_view word = words[0].text;
    if (word == "ifdef" || word == "ifndef") {
        std::optional<bool> condition = words.size() > 1 ? is_defined(words[1].text) : std::nullopt;
        if (condition && word == "ifndef") condition = !*condition;
        open_.push_back({Branch::dead, state()});
        enter(condition);
        return true;
    }
    if (word == "if") {
        open_.push_back({Branch::dead, state()});
        enter(condition_of(words, is_defined));
        return false;
    }
    if (open_.empty() || (word != "elif" && word != "else" && word != "endif")) return false;
    if (word == "endif")
        open_.pop_back();
    else
        enter(word == "else" ? std::optional(true) : condition_of(words, is_defined));
    return word != "elif";
}

}  // namespace rakelight
