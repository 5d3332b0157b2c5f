// SPDX-License-Identifier: Apache-2.0
#include "switches.h"

#include <CLI/CLI.hpp>

namespace rakelight::cli {

bool is_switch(const CLI::Option& option) { return option.get_type_name() == switch_type; }

std::vector<std::string> join_switches(const CLI::App& app, int argc, const char* const* argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const std::vector<const CLI::App*> verbs =
        app.get_subcommands([&](const CLI::App* verb) { return !words.empty() && verb->get_name() == words[0]; });
    if (verbs.empty()) return words;
    for (std::size_t i = 1; i + 1 < words.size() && words[i] != "--"; ++i) {
        if (!words[i].starts_with("--") || (words[i + 1] != "on" && words[i + 1] != "off")) continue;
        const CLI::Option* const option = verbs.front()->get_option_no_throw(words[i]);
        if (!option || !is_switch(*option)) continue;
        words[i] += "=" + words[i + 1];
        words.erase(words.begin() + std::ptrdiff_t(i) + 1);
    }
    return words;
}

}  // namespace rakelight::cli
