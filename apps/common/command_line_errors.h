// SPDX-License-Identifier: Apache-2.0
// What is wrong with a command line, in one line each.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/error.h>

#include "command_line.h"

namespace rakelight::apps {

/// The command that the words behind the program's name ask for; null: none, or none that there is.
const Command* command_of(const Program& program, std::span<const std::string> words);

/// @throws Error usage: a command that there is not, an empty value or name, a flag with another value than on or off, such as
///         --json=5
/// @param words  behind the program's name
void check_words(const Program& program, std::span<const std::string> words);

/// The words with "--shadows", "off" as "--shadows=off" where that is a switch of the command, so that a model's name
/// behind a switch stays one; flags stand alone ("--json", "on" is "--json", "--json=off" is nothing). @throws Error usage: a word behind a switch that looks like neither
std::vector<std::string> join_switches(const Program& program, std::vector<std::string> words);

/// The parser's message as one line that says where help is. An unknown option is reported with the most similar known
/// one.
/// @param command   null: none was read
/// @param left      words that were not understood
/// @param repeated  an option that takes one value and was given several; empty: none
Error usage_error(const Program& program, const Command* command, std::string message,
                  const std::vector<std::string>& left, const std::string& repeated);

}  // namespace rakelight::apps
