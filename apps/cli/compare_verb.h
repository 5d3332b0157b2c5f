// SPDX-License-Identifier: Apache-2.0
// `rakelight compare`: how much pictures differ, of files or as engines draw them.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command compare_command();

/// Compares each pair; returns the exit code.
int run_compare(const Run& run);

}  // namespace rakelight::cli
