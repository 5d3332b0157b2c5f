// SPDX-License-Identifier: Apache-2.0
// `rakelight join-windows`: windows of one picture to the whole.
#pragma once
#include "run.h"

namespace rakelight::cli {

Command join_windows_command();
int run_join_windows(const Run& run);

}  // namespace rakelight::cli
