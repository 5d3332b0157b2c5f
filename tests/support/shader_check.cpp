// SPDX-License-Identifier: Apache-2.0
// Test programs do not stand beside rakelight-shader-check: they are told where it is.
#include <stdlib.h>

namespace {

[[maybe_unused]] const int is_told = ::setenv("RAKELIGHT_SHADER_CHECK", RL_SHADER_CHECK, 0);

}  // namespace
