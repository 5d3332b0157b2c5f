// SPDX-License-Identifier: Apache-2.0
// Options whose values are kept as words, declared by tables.
#pragma once
#include <CLI/CLI.hpp>
#include <span>
#include <string>

#include <rakelight/world.h>

#include "switches.h"

namespace rakelight::cli {

/// An option of a set of words. A switch may stand alone, or with on or off behind it.
template <class Words>
struct OptionEntry {
    const char *group, *name;
    std::string Words::*word;
    const char *type, *help;
};

/// Declares the options. @param group  in place of the entries' own; null: those
template <class Words>
void add_table(CLI::App& app, std::span<const OptionEntry<Words>> table, Words& words, const char* group = nullptr) {
    for (const OptionEntry<Words>& entry : table) {
        std::string& word = words.*entry.word;
        CLI::Option* const option = std::string_view(entry.type) == switch_type
                                        ? app.add_flag(entry.name, word, entry.help)
                                        : app.add_option(entry.name, word, entry.help);
        option->type_name(entry.type)->group(group ? group : entry.group);
    }
}

/// What was given, by keys of [render], which the options' names are.
template <class Words>
void add_values(std::span<const OptionEntry<Words>> table, const Words& words, std::vector<WorldValue>& values) {
    for (const OptionEntry<Words>& entry : table)
        if (!(words.*entry.word).empty()) values.push_back({.key = entry.name + 2, .words = {words.*entry.word}});
}

}  // namespace rakelight::cli
