// SPDX-License-Identifier: Apache-2.0
// Switches: options that may stand alone, or with on or off behind them.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace rakelight::cli {

inline constexpr const char* switch_type = "[on|off]";

bool is_switch(const CLI::Option& option);

/// The words behind the program's name, with "--shadows", "off" as "--shadows=off" where that is a switch of the verb,
/// so that a model's name behind a switch stays one.
/// @param app  that is to be parsed, with all verbs
std::vector<std::string> join_switches(const CLI::App& app, int argc, const char* const* argv);

}  // namespace rakelight::cli
