// SPDX-License-Identifier: Apache-2.0
// Needs bash alone, not the package bash-completion.
#include <algorithm>
#include <map>

#include "completion.h"
#include "completion_answers.h"

namespace rakelight::apps {
namespace {

/// Patterns of "verb:--option" by what they are answered with: "words on off".
using Cases = std::map<std::string, std::vector<std::string>>;

std::string action(const Answers& answers) {
    if (!answers.words.empty() && !answers.takes_value) return "switch=\"" + joined_words(answers.words, " ") + "\"";
    if (!answers.words.empty())
        return "values=\"" + joined_words(answers.words, " ") + "\"" + (answers.is_list ? " list=1" : "");
    return answers.is_file ? "kind=file" : "kind=other";
}

/// One pattern for all commands where they agree about an option, else one a command.
Cases cases_of(const Program& program) {
    std::map<std::string, std::map<std::string, std::vector<std::string>>> by_option;  // option, action: commands
    for (const Command& command : program.commands)
        for (const Option& option : command.options)
            if (const Answers answers = answers_for(option); answers != Answers{})
                for (const std::string& name : spellings(option))
                    by_option[name][action(answers)].emplace_back(command.name);
    Cases cases;
    for (const auto& [option, actions] : by_option)
        for (const auto& [words, commands] : actions)
            for (const std::string& command : actions.size() == 1 ? std::vector<std::string>{"*"} : commands)
                cases[words].push_back(command + ":" + option);
    return cases;
}

/// What stands in `case $verb in` for a command: its options, and the words of its first positional.
std::string offers_of(const Command& command) {
    std::string text = "options=\"--help";
    for (const Option& option : command.options)
        if (!option.is_hidden)
            for (const std::string& name : spellings(option)) text += " " + name;
    text += '"';
    if (!command.positionals.empty() && command.positionals[0].words)
        text += " first=\"" + joined_words(command.positionals[0].words(), " ") + "\"";
    return text;
}

}  // namespace

std::string bash_completion(const Program& program) {
    const std::string name = program.name;
    std::string verbs, cases;
    for (const Command& command : program.commands) verbs += (verbs.empty() ? "" : " ") + std::string(command.name);
    std::string out = "# bash completion of " + name + ", written by `" + name + " --completion bash`\n_" + name +
                      R"(() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
    local verbs=")" + verbs +
                      R"(" verb options first= given values= list= listed= switch= kind=model
    # "--engine=gl" comes as three words
    if [ "$word" = = ]; then word=; elif [ "$before" = = ]; then before=${COMP_WORDS[COMP_CWORD-2]}; fi
    case " $verbs " in *" ${COMP_WORDS[1]} "*) verb=${COMP_WORDS[1]} ;; *) verb=)" +
                      program.commands[0].name + R"( ;; esac
    case $verb in
)";
    for (const Command& command : program.commands)
        out += "    " + std::string(command.name) + ") " + offers_of(command) + " ;;\n";
    out += "    esac\n    case $verb:$before in\n    *:--completion) values=\"" +
           joined_words(completion_shells(), " ") + "\" ;;\n";
    for (const auto& [words, patterns] : cases_of(program))
        out += "    " + joined_words(patterns, " | ") + ") " + words + " ;;\n";
    return out + R"(    esac
    # Behind the first of these words come files
    for given in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
        case " $first " in *" $given "*) first= ;; esac
    done
    COMPREPLY=()
    if [ -n "$values" ]; then
        if [ -n "$list" ]; then listed=${word%"${word##*,}"}; fi
        mapfile -t COMPREPLY < <(compgen -P "$listed" -W "$values" -- "${word#"$listed"}")
    elif [ "$kind" = other ]; then
        return
    elif [ "${word:0:1}" = - ]; then
        [ "$COMP_CWORD" != 1 ] || options+=" --version --completion"
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
    elif [ -n "$first" ] && [ "$kind" = model ] && [ "$COMP_CWORD" != 1 ]; then
        mapfile -t COMPREPLY < <(compgen -W "$switch $first" -- "$word")
    else
        [ "$COMP_CWORD" != 1 ] || switch="$verbs help"
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -W "$switch" -- "$word"; compgen -f -- "$word")
    fi
}
complete -F _)" +
           name + " " + name + "\n";
}

}  // namespace rakelight::apps
