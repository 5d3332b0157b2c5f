// SPDX-License-Identifier: Apache-2.0
// `rakelight stages`: what each stage makes of a model, as a page.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command stages_command();

/// Writes the stages of each input; returns the exit code.
int run_stages(const Run& run);

}  // namespace rakelight::cli
