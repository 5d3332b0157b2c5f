// SPDX-License-Identifier: Apache-2.0
// Command lines that begin with a model: `rakelight helmet.glb -o helmet.png`.
#pragma once
#include <string>
#include <vector>

#include "../common/command_line.h"

namespace rakelight::cli {

/// Whether a word is a model and no misspelt verb: it exists as a file or folder, begins with "builtin:", has a model's ending, or
/// is "-", standard input.
bool is_model_word(const std::string& word);

/// The words, with "render" before them where they begin with a model and name an output ("convert" where that is a model), and with
/// "view" where they name none and a window can be opened. Others are left as they are.
/// @throws Error usage: wrong options; models, but nothing to show them on
std::vector<std::string> with_implied_verb(const apps::Program& program, std::vector<std::string> words);

}  // namespace rakelight::cli
