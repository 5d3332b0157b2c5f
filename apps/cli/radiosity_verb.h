// SPDX-License-Identifier: Apache-2.0
// `rakelight radiosity`: a scene with its light as the colors of its surfaces.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command radiosity_command();
int run_radiosity(const Run& run);

}  // namespace rakelight::cli
