// SPDX-License-Identifier: Apache-2.0
// The command line, read by the tables of its commands.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "option.h"

namespace rakelight::apps {

/// A program with commands.
struct Program {
    const char *name, *help, *footer;
    std::span<const Command> commands;
    const char* usage = nullptr;  ///< of the program without a command; null: there is none
};

struct CommandLine {
    std::string help;         ///< what is to be printed instead of anything else; empty: nothing
    bool is_version = false;  ///< likewise
    std::size_t command = 0;  ///< into Program::commands
    Given given;
    std::vector<std::string> positionals;  ///< those of the list, or the single ones in their order
};

/// @throws Error usage, one line: unknown commands and options with the nearest that there is
/// @param words  behind the program's name
CommandLine read_command_line(const Program& program, const std::vector<std::string>& words);

}  // namespace rakelight::apps
