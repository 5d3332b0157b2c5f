// SPDX-License-Identifier: Apache-2.0
// `rakelight explain`: why a pixel has its color.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command explain_command();

/// Explains a pixel of each input; returns the exit code.
int run_explain(const Run& run);

}  // namespace rakelight::cli
