// SPDX-License-Identifier: Apache-2.0
// The documentation of a program's command line, of the tables that it is read by: --help says the same.
#pragma once
#include <string>
#include <vector>

#include "command_line.h"

namespace rakelight::apps {

/// In the macros of man(7), for `man`.
std::string man_page(const Program& program);

/// In Markdown: docs/command-line.md.
std::string markdown_page(const Program& program);

/// What "--man", "--markdown" or "--typescript", alone, ask for; else empty.
std::string manual_for(const Program& program, const std::vector<std::string>& words);

}  // namespace rakelight::apps
