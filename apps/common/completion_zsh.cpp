// SPDX-License-Identifier: Apache-2.0
// By zsh's _arguments: one function a command.
#include "completion.h"
#include "completion_answers.h"

namespace rakelight::apps {
namespace {

/// In single quotes.
std::string in_quotes(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

/// With backslashes before what means something in a specification.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) out += (c == '[' || c == ']' || c == ':' || c == '\\' ? "\\" : "") + std::string(1, c);
    return out;
}

/// ":TYPE:(words)", ":TYPE:_values -s , TYPE words"
std::string value_of(const Option& option, const Answers& answers) {
    if (answers == Answers{}) return {};
    const std::string type = answers.takes_value ? ":" + escaped(option.type) : "::on or off";
    if (answers.is_list) return type + ":_values -s , " + escaped(option.type) + " " + joined_words(answers.words, " ");
    if (!answers.words.empty()) return type + ":(" + joined_words(answers.words, " ") + ")";
    return type + (answers.is_file ? ":_files" : ":");
}

/// A specification a spelling; one excludes the others, but for lists.
std::string specifications(const Option& option) {
    const Answers answers = answers_for(option);
    const std::vector<std::string> names = spellings(option);
    std::string out;
    for (const std::string& name : names) {
        std::string text = option.form == Form::list ? "*" : "(" + joined_words(names, " ") + ")";
        text += name + (name.starts_with("--") && answers.takes_value ? "=" : "");
        text += "[" + escaped(brief(option.help)) + "]" + value_of(option, answers);
        out += "        " + in_quotes(text) + " \\\n";
    }
    return out;
}

std::string function_of(const std::string& program, const Command& command) {
    std::string out = "_" + program + "_" + command.name + "() {\n    _arguments -s \\\n";
    for (const Option& option : command.options)
        if (!option.is_hidden) out += specifications(option);
    out += "        '(-h --help)'{-h,--help}'[Show the help]'";
    for (const Positional& p : command.positionals)
        out +=
            std::string(" \\\n        ") + in_quotes(std::string(p.is_list ? "*" : "") + ":" + escaped(p.name) + ":" +
                                                     (p.words ? "(" + joined_words(p.words(), " ") + ")" : "_files"));
    return out + "\n}\n";
}

}  // namespace

std::string zsh_completion(const Program& program) {
    const std::string name = program.name;
    std::string out = "#compdef " + name + "\n# written by `" + name + " --completion zsh`\n", verbs, names;
    for (const Command& command : program.commands) {
        out += function_of(name, command);
        verbs += "            " + in_quotes(std::string(command.name) + ":" + command.help) + "\n";
        names += (names.empty() ? "" : "|") + std::string(command.name);
    }
    return out + "_" + name + R"(() {
    local -a verbs
    if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then
        verbs=(
)" + verbs +
           R"(        )
        _describe verb verbs
        _files
        return
    fi
    case $words[2] in
    )" + names +
           R"()
        local verb=$words[2]
        shift words
        (( CURRENT-- ))
        _)" +
           name + R"(_$verb
        ;;
    --completion) compadd )" +
           joined_words(completion_shells(), " ") + R"( ;;
    *) _)" +
           name + "_" + program.commands[0].name + R"( ;;
    esac
}
if [[ $zsh_eval_context[-1] == loadautofunc ]]; then
    _)" + name +
           R"( "$@"
else
    compdef _)" +
           name + " " + name + "\nfi\n";
}

}  // namespace rakelight::apps
