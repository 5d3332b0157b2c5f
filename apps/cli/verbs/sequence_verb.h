// SPDX-License-Identifier: Apache-2.0
// render --frames, --turntable, --movie: numbered pictures, and movies of them.
#pragma once
#include "../run.h"

namespace rakelight::cli {

std::vector<Option> sequence_options();

/// Whether the command line asks for a sequence. @throws Error usage: only for how one is made
bool asks_sequence(const Run& run);

int run_sequence(const Run& run);

}  // namespace rakelight::cli
