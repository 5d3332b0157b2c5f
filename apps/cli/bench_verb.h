// SPDX-License-Identifier: Apache-2.0
// `rakelight bench`: measurements of the program itself.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command bench_command();

/// Measures and says what was measured; returns the exit code.
int run_bench(const Run& run);

}  // namespace rakelight::cli
