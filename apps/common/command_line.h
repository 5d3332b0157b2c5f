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
};

struct CommandLine {
    std::string help;         ///< what is to be printed in place of anything else; empty: nothing
    bool is_version = false;  ///< likewise
    std::size_t command = 0;  ///< into Program::commands
    Given given;
    std::vector<std::string> positionals;  ///< those of the list, or the single ones in their order
};

/// @throws Error usage, one line: unknown commands and options with the nearest that there is
CommandLine read_command_line(const Program& program, int argc, const char* const* argv);

}  // namespace rakelight::apps
