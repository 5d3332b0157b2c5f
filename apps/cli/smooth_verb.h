// SPDX-License-Identifier: Apache-2.0
// `rakelight smooth`: models written back with seam-free normals and tangents.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command smooth_command();

/// Smooths each input to its output; returns the exit code.
int run_smooth(const Run& run);

}  // namespace rakelight::cli
