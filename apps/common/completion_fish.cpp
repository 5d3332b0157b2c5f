// SPDX-License-Identifier: Apache-2.0
// One line an option; commands whose options are alike share it.
#include <map>

#include "completion.h"
#include "completion_answers.h"

namespace rakelight::apps {
namespace {

std::string in_quotes(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += (c == '\'' || c == '\\' ? "\\" : "") + std::string(1, c);
    return out + "'";
}

std::string arguments_of(const Option& option) {
    std::string out;
    for (const std::string& name : spellings(option))
        out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    const Answers answers = answers_for(option);
    if (answers.is_file && answers.words.empty())
        out += " -r -F";
    else if (answers.takes_value)
        out += " -x";
    if (answers.is_list)
        out +=
            " -a " + in_quotes("(__fish_complete_list , \"string split , " + joined_words(answers.words, ",") + "\")");
    else if (!answers.words.empty() && answers.takes_value)
        out += " -a " + in_quotes(joined_words(answers.words, " "));
    return out + " -d " + in_quotes(brief(option.help));
}

/// Where none of them is there.
std::string positional_words(const std::string& program, const Command& command, const Positional& positional) {
    const std::string words = joined_words(positional.words(), " ");
    return " -n '__" + program + "_is " + command.name + "; and not __fish_seen_subcommand_from " + words + "' -f -a " +
           in_quotes(words);
}

}  // namespace

std::string fish_completion(const Program& program) {
    const std::string name = program.name, complete = "complete -c " + name, is_first = "__" + name + "_is_first";
    std::string verbs, out;
    std::vector<std::string> lines;  // in the order of the options
    std::map<std::string, std::string> commands_of;
    for (const Command& command : program.commands) {
        verbs.append(" ").append(command.name);
        out.append(complete)
            .append(" -n " + is_first + " -a ")
            .append(command.name)
            .append(" -d " + in_quotes(command.help) + "\n");
        for (const Positional& p : command.positionals)
            if (p.words) out += complete + positional_words(name, command, p) + "\n";
        for (const Option& option : command.options) {
            if (option.is_hidden) continue;
            const std::string line = arguments_of(option);
            std::string& commands = commands_of[line];
            if (commands.empty()) lines.push_back(line);
            commands.append(" ").append(command.name);
        }
    }
    for (const std::string& line : lines)
        out.append(complete).append(" -n '__" + name + "_is").append(commands_of[line]).append("'" + line + "\n");
    return "# fish completion of " + name + ", written by `" + name + " --completion fish`\nfunction __" + name + R"(_is
    set -l words (commandline -opc)
    set -l verb )" +
           program.commands[0].name + R"(
    if set -q words[2]; and contains -- $words[2])" +
           verbs + R"(
        set verb $words[2]
    end
    contains -- $verb $argv
end
function )" +
           is_first + R"(
    test (count (commandline -opc)) -eq 1
end
)" + complete +
           " -n " + is_first + " -l version -s V -d 'Say version, formats, engines and instruction sets'\n" + complete +
           " -n '" + is_first + "; or contains -- --completion (commandline -opc)' -l completion -x -a " +
           in_quotes(joined_words(completion_shells(), " ")) + " -d 'Print the script by which a shell completes'\n" +
           complete + " -l help -s h -d 'Show the help'\n" + out;
}

}  // namespace rakelight::apps
