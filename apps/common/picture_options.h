// SPDX-License-Identifier: Apache-2.0
// The settings of pictures as options: every key of [render] in world files, with its help.
#pragma once
#include <vector>

#include "option.h"

namespace rakelight::apps {

/// Those that --engine takes in this build.
std::vector<std::string> engine_words();

/// All, in the order of the help.
std::vector<Option> picture_options();

/// Of commands that draw or look into pictures: --allow-shaders.
Option shader_option();

/// For commands that look into surfaces: --edges and the like are refused with their own message, so the help leaves them
/// out.
void hide_drawn_lines(std::vector<Option>& options);

/// Options of commands that take models: --recursive, --format, --as-one.
std::vector<Option> input_options();

/// Options of every command of a program: --config, --json, --quiet, --verbose, --threads, --max-memory, --allow-outside.
std::vector<Option> common_options();

/// Several lists in one.
std::vector<Option> joined(std::initializer_list<std::vector<Option>> lists);

}  // namespace rakelight::apps
