// SPDX-License-Identifier: Apache-2.0
#include "command_line_errors.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include <rakelight/tools/words.h>

namespace rakelight::apps {
namespace {

/// The long option that a misspelt word is likely to mean; empty: none is near.
std::string nearest_option(const std::vector<Option>& options, const std::string& word) {
    std::string nearest;
    std::size_t least = std::max<std::size_t>(1, (word.size() - 2) / 3) + 1;
    const auto consider = [&](const std::string& name) {
        const bool is_begun = word.size() >= 5 && name.starts_with(word);
        const std::size_t distance = is_begun ? 1 : spelling_distance(word, name);
        if (distance < least) least = distance, nearest = name;
    };
    for (const Option& option : options)
        if (!option.is_hidden) consider(std::string("--") + option.name);
    consider("--help");
    return nearest;
}

Error unknown_option(const Command* command, const std::string& given, const std::string& help) {
    const bool is_long = given.starts_with("--") && given.size() > 2;
    const std::string word = is_long ? given.substr(0, given.find('=')) : given;
    const std::string nearest = is_long && command ? nearest_option(command->options, word) : "";
    return Error(ErrorCode::usage, "unknown option '" + one_line(word, 60) + "'", {},
                 nearest.empty() ? help : "did you mean " + nearest + "? " + help);
}

const Option* option_of(const Command& command, const std::string& word) {
    return word.starts_with("--") ? find_or_null(command.options, std::string_view(word).substr(2)) : nullptr;
}

void refuse_value_of_flag(const Command& command, const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    const Option* const option = name == word ? nullptr : option_of(command, name);
    if (option && option->form == Form::flag)
        throw Error(ErrorCode::usage,
                    name + " takes no value, but is given '" + one_line(word.substr(name.size() + 1), 40) + "'");
}

void refuse_empty(const std::string& word, const std::string& before) {
    const bool is_value = before.starts_with('-') && before.find('=') == before.npos;
    if ((word.empty() && is_value) || (word.starts_with("--") && word.ends_with('=')))
        throw Error(ErrorCode::usage, one_line(word.empty() ? before : word, 40) + ": the value is empty");
    if (word.empty()) throw Error(ErrorCode::usage, "the name of a model is empty");
}

std::string names_of(std::span<const Command> commands) {
    std::string all;
    for (std::size_t i = 0; i < commands.size(); ++i)
        all += (i == 0 ? "" : i + 1 < commands.size() ? ", " : " or ") + std::string(commands[i].name);
    return all;
}

/// A word behind a switch is a model, unless it looks like none: no file, without folder and ending.
void refuse_unless_file(const std::string& name, const std::string& word) {
    std::error_code ignored;
    if (word.starts_with('-') || word.find_first_of("./:") != word.npos || std::filesystem::exists(word, ignored))
        return;
    throw Error(ErrorCode::usage, name + ": unknown word '" + one_line(word, 40) + "'", {}, "use one of: on, off");
}

}  // namespace

const Command* command_of(const Program& program, std::span<const std::string> words) {
    for (const Command& command : program.commands)
        if (!words.empty() && words[0] == command.name) return &command;
    return nullptr;
}

void check_words(const Program& program, std::span<const std::string> words) {
    const Command* const command = command_of(program, words);
    if (!words.empty() && !words[0].starts_with('-') && !command)
        throw Error(ErrorCode::usage, "unknown command '" + one_line(words[0], 40) + "'", {},
                    "use " + names_of(program.commands) + ", see " + program.name + " --help");
    for (std::size_t i = 1; i < words.size() && words[i] != "--"; ++i) {
        refuse_empty(words[i], words[i - 1]);
        if (command) refuse_value_of_flag(*command, words[i]);
    }
}

std::vector<std::string> join_switches(const Program& program, std::vector<std::string> words) {
    const Command* const command = command_of(program, words);
    if (!command) return words;
    for (std::size_t i = 1; i + 1 < words.size() && words[i] != "--"; ++i) {
        const Option* const option = option_of(*command, words[i]);
        if (!option || option->form != Form::switched) continue;
        if (words[i + 1] != "on" && words[i + 1] != "off") {
            refuse_unless_file(words[i], words[i + 1]);
            continue;
        }
        words[i] += "=" + words[i + 1];
        words.erase(words.begin() + std::ptrdiff_t(i) + 1);
    }
    return words;
}

Error usage_error(const Program& program, const Command* command, std::string message,
                  const std::vector<std::string>& left, const std::string& repeated) {
    const std::string help =
        std::string("see ") + program.name + (command ? " " + std::string(command->name) : "") + " --help";
    for (const std::string& word : left)
        if (word.starts_with('-') && word.find('.') != word.npos && word.find('=') == word.npos)
            return Error(ErrorCode::usage, "'" + one_line(word, 60) + "' looks like an option", {},
                         "for a file write ./" + one_line(word, 60));
    for (const std::string& word : left)
        if (word.size() > 1 && word.starts_with('-')) return unknown_option(command, word, help);
    if (!repeated.empty()) return Error(ErrorCode::usage, repeated + " is given more than once", {}, help);
    std::ranges::replace(message, '\n', ' ');
    return Error(ErrorCode::usage, message, {}, help);
}

}  // namespace rakelight::apps
