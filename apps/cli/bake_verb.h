// SPDX-License-Identifier: Apache-2.0
// `rakelight bake`: what one model looks like, as maps for another one.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command bake_command();

/// Bakes and writes the maps; returns the exit code.
int run_bake(const Run& run);

}  // namespace rakelight::cli
