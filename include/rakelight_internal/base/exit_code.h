// SPDX-License-Identifier: Apache-2.0
// Exit codes of programs.
#pragma once
#include <rakelight/base/error.h>

namespace rakelight {

/// 1 to 5, in the order of ErrorCode; 0 is success.
constexpr int exit_code(ErrorCode code) noexcept { return int(code) + 1; }

}  // namespace rakelight
