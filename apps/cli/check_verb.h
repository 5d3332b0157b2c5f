// SPDX-License-Identifier: Apache-2.0
// `rakelight check`: whether scene files load, and what they hold.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command check_command();

/// Loads each input and says what it holds; returns the exit code.
int run_check(const Run& run);

}  // namespace rakelight::cli
