// SPDX-License-Identifier: Apache-2.0
// `rakelight render`: pictures of models.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command render_command();

/// Draws each input to its output; returns the exit code.
int run_render(const Run& run);

}  // namespace rakelight::cli
