// SPDX-License-Identifier: Apache-2.0
#include "usage_error.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include <rakelight/words.h>

#include "switches.h"

namespace rakelight::cli {
namespace {

/// The long option that a misspelt word is likely to mean; empty: none is near.
std::string nearest_option(const CLI::App& app, const std::string& word) {
    std::string nearest;
    std::size_t least = std::max<std::size_t>(1, (word.size() - 2) / 3) + 1;
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_group().empty()) continue;  // hidden
        for (const std::string& name : option->get_lnames()) {
            const bool is_begun = word.size() >= 5 && ("--" + name).starts_with(word);
            const std::size_t distance = is_begun ? 1 : spelling_distance(word, "--" + name);
            if (distance < least) least = distance, nearest = "--" + name;
        }
    }
    return nearest;
}

Error unknown_option(const CLI::App& app, const std::string& given, const std::string& help) {
    const bool is_long = given.starts_with("--") && given.size() > 2;
    const std::string word = is_long ? given.substr(0, given.find('=')) : given;
    const std::string nearest = is_long ? nearest_option(app, word) : "";
    return Error(ErrorCode::usage, "unknown option '" + one_line(word, 60) + "'", {},
                 nearest.empty() ? help : "did you mean " + nearest + "? " + help);
}

/// An option that takes one value and was given several; null: none.
const CLI::Option* repeated_option(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options())
        if (!option->get_positional() && option->get_items_expected_max() == 1 && option->count() > 1 &&
            option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw)
            return option;
    return nullptr;
}

}  // namespace

Error usage_error(const CLI::ParseError& fault, const CLI::App& app) {
    const std::vector<CLI::App*> verbs = app.get_subcommands();
    const CLI::App& verb = verbs.empty() ? app : *verbs.front();
    const std::string help = "see rakelight" + (&verb == &app ? "" : " " + verb.get_name()) + " --help";
    for (const std::string& word : app.remaining(true))
        if (word.starts_with('-') && word.find('.') != word.npos && word.find('=') == word.npos)
            return Error(ErrorCode::usage, "'" + one_line(word, 60) + "' looks like an option", {},
                         "for a file write ./" + one_line(word, 60));
    for (const std::string& word : app.remaining(true))
        if (word.size() > 1 && word.starts_with('-')) return unknown_option(verb, word, help);
    if (const CLI::Option* const option = repeated_option(verb))
        return Error(ErrorCode::usage, option->get_name() + " is given more than once", {}, help);
    std::string text = fault.what();
    for (char& c : text) c = c == '\n' ? ' ' : c;
    return Error(ErrorCode::usage, text, {}, help);
}

void refuse_values_of_flags(const CLI::App& app, int argc, const char* const* argv) {
    const std::vector<const CLI::App*> verbs =
        app.get_subcommands([&](const CLI::App* verb) { return argc > 1 && verb->get_name() == argv[1]; });
    if (verbs.empty()) return;
    for (int i = 2; i < argc && std::string_view(argv[i]) != "--"; ++i) {
        const std::string word = argv[i], name = word.substr(0, word.find('='));
        if (!word.starts_with("--") || name == word) continue;
        const CLI::Option* const option = verbs.front()->get_option_no_throw(name);
        if (option && option->get_items_expected_max() == 0 && !is_switch(*option))
            throw Error(ErrorCode::usage,
                        name + " takes no value, but is given '" + one_line(word.substr(name.size() + 1), 40) + "'");
    }
}

}  // namespace rakelight::cli
