// SPDX-License-Identifier: Apache-2.0
// The command `rakelight view`, for the program that starts the viewer and for the viewer itself.
#pragma once
#include "option.h"

namespace rakelight::apps {

Command view_command();

/// Whether a setting of a world file means something to a command.
/// @throws Error bad_file: a key that is about the run and not about the picture, which a file that was sent by somebody does not say
bool takes_setting(const Command& command, std::string_view key);

/// The second half of takes_setting(). @throws Error bad_file, as there
void refuse_options_of_the_run(std::string_view key);

}  // namespace rakelight::apps
