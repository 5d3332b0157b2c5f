// SPDX-License-Identifier: Apache-2.0
// Scripts by which shells complete a program's command line at <Tab>, of the tables that it is read by.
#pragma once
#include <string>
#include <vector>

#include "command_line.h"

namespace rakelight::apps {

// A word in the first place is a verb or a model. Behind no verb it is the options of the program's first command that are offered, as that
// is what models alone stand for.
/// The words behind "--completion".
std::vector<std::string> completion_shells();

std::string bash_completion(const Program& program);
std::string zsh_completion(const Program& program);
std::string fish_completion(const Program& program);

/// What "--completion SHELL", alone, asks for; other words: empty. @throws Error usage: there is no such shell here
std::string completion_for(const Program& program, const std::vector<std::string>& words);

}  // namespace rakelight::apps
