// SPDX-License-Identifier: Apache-2.0
// `rakelight inspect`: what is in models.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command inspect_command();

/// Inspects each input; returns the exit code.
int run_inspect(const Run& run);

}  // namespace rakelight::cli
