// SPDX-License-Identifier: Apache-2.0
// Cleanup for programs that must exit while cancelled work is still running.
#pragma once
#include <rakelight/base/export.h>

namespace rakelight {

/// Removes the temporary files and folders of all unfinished outputs of this process. Complete files stay. Exit
/// immediately after this call, because writes in progress then fail. Async-signal-safe.
RL_API void remove_unfinished_outputs() noexcept;

}  // namespace rakelight
