// SPDX-License-Identifier: Apache-2.0
#include "command_line_errors.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include <rakelight/scene/words.h>

#include "other_names.h"

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
    for (const Option& option : options) {
        if (option.is_hidden) continue;
        consider(std::string("--") + option.name);
        if (option.also) consider(std::string("--") + option.also);
    }
    consider("--help");
    return nearest;
}

Error unknown_option(const Command* command, const std::string& given, const std::string& help) {
    const bool is_long = given.starts_with("--") && given.size() > 2;
    const std::string word = is_long ? given.substr(0, given.find('=')) : given;
    std::string ours;
    if (is_long && command)
        for (const std::string_view name : our_options_for(word.substr(2)))
            if (find_or_null(command->options, name)) ours += (ours.empty() ? "--" : ", --") + std::string(name);
    if (!ours.empty()) return Error(ErrorCode::usage, one_line(word, 60) + ": unknown", {}, "see " + ours);
    const std::string nearest = is_long && command ? nearest_option(command->options, word) : "";
    return Error(ErrorCode::usage, "unknown option '" + one_line(word, 60) + "'", {},
                 nearest.empty() ? help : "did you mean " + nearest + "? " + help);
}

const Option* option_of(const Command& command, const std::string& word) {
    return word.starts_with("--") ? find_or_null(command.options, std::string_view(word).substr(2)) : nullptr;
}

/// "on", "off" and what else values::on_off() takes; nothing: it is no such word.
std::optional<bool> switch_of(std::string_view word) {
    for (const char* const on : {"on", "true", "1"})
        if (same_word(word, on)) return true;
    for (const char* const off : {"off", "false", "0"})
        if (same_word(word, off)) return false;
    return {};
}

void check_value_of_flag(const Command& command, const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    const Option* const option = name == word ? nullptr : option_of(command, name);
    if (option && option->form == Form::flag && !switch_of(word.substr(name.size() + 1)))
        throw Error(ErrorCode::usage,
                    name + ": must be on or off, not '" + one_line(word.substr(name.size() + 1), 40) + "'");
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

Error unknown_command(const Program& program, const std::string& word) {
    std::vector<std::string_view> names;
    for (const Command& command : program.commands) names.emplace_back(command.name);
    const std::string_view ours = our_command_for(word);
    const std::string nearest = ours.empty() ? nearest_word(word, names) : "",
                      help = std::string(program.name) + " --help";
    std::string advice = "use " + names_of(program.commands) + ", see " + help;
    if (!ours.empty() && std::ranges::find(names, ours) != names.end())
        advice = std::string("see ") + program.name + " " + std::string(ours) + " --help";
    if (!nearest.empty()) advice = "did you mean " + nearest + "? see " + help;
    const bool is_path = word.find_first_of("./\\") != word.npos;
    return Error(ErrorCode::usage,
                 "unknown command '" + one_line(word, 40) + (is_path ? "', and there is no such file" : "'"), {},
                 advice);
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
    if (!words.empty() && !words[0].starts_with('-') && !command) throw unknown_command(program, words[0]);
    for (std::size_t i = 1; i < words.size() && words[i] != "--"; ++i) {
        refuse_empty(words[i], words[i - 1]);
        if (command) check_value_of_flag(*command, words[i]);
    }
}

namespace {

/// "--json=on" as "--json", and "--json=off" as nothing.
void plain_flag(std::vector<std::string>& words, std::size_t& i) {
    const std::size_t equals = words[i].find('=');
    if (equals == std::string::npos) return;
    const bool is_on = switch_of(words[i].substr(equals + 1)).value_or(true);
    words[i].erase(equals);
    if (is_on) return;
    words.erase(words.begin() + std::ptrdiff_t(i));
    --i;
}

}  // namespace

std::vector<std::string> join_switches(const Program& program, std::vector<std::string> words) {
    const Command* const command = command_of(program, words);
    if (!command) return words;
    for (std::size_t i = 1; i < words.size() && words[i] != "--"; ++i) {
        const Option* const option = option_of(*command, words[i].substr(0, words[i].find('=')));
        if (!option || (option->form != Form::on_off && option->form != Form::flag)) continue;
        if (words[i].find('=') == std::string::npos && i + 1 < words.size()) {
            if (switch_of(words[i + 1])) {
                words[i] += "=" + words[i + 1];
                words.erase(words.begin() + std::ptrdiff_t(i) + 1);
            } else if (option->form == Form::on_off) {
                refuse_unless_file(words[i], words[i + 1]);
            }
        }
        if (option->form == Form::flag) plain_flag(words, i);
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
