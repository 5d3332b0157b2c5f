// SPDX-License-Identifier: Apache-2.0
#include "switches.h"

#include <CLI/CLI.hpp>

#include <filesystem>

#include <rakelight/error.h>

namespace rakelight::cli {
namespace {

/// A word behind a switch is a model, unless it looks like none: no file, without folder and ending.
void refuse_unless_file(const std::string& name, const std::string& word) {
    std::error_code ignored;
    if (word.starts_with('-') || word.find_first_of("./:") != word.npos || std::filesystem::exists(word, ignored))
        return;
    throw Error(ErrorCode::usage, name + ": unknown word '" + one_line(word, 40) + "'", {}, "use one of: on, off");
}

}  // namespace

bool is_switch(const CLI::Option& option) { return option.get_type_name() == switch_type; }

std::vector<std::string> join_switches(const CLI::App& app, int argc, const char* const* argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const std::vector<const CLI::App*> verbs =
        app.get_subcommands([&](const CLI::App* verb) { return !words.empty() && verb->get_name() == words[0]; });
    if (verbs.empty()) return words;
    for (std::size_t i = 1; i + 1 < words.size() && words[i] != "--"; ++i) {
        if (!words[i].starts_with("--")) continue;
        const CLI::Option* const option = verbs.front()->get_option_no_throw(words[i]);
        if (!option || !is_switch(*option)) continue;
        if (words[i + 1] != "on" && words[i + 1] != "off") {
            refuse_unless_file(words[i], words[i + 1]);
            continue;
        }
        words[i] += "=" + words[i + 1];
        words.erase(words.begin() + std::ptrdiff_t(i) + 1);
    }
    return words;
}

}  // namespace rakelight::cli
