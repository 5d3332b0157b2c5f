// SPDX-License-Identifier: Apache-2.0
// `rakelight thumbnail`: what file managers call for the small picture of a model.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command thumbnail_command();

/// Draws the model into a square PNG; returns the exit code.
int run_thumbnail(const Run& run);

}  // namespace rakelight::cli
