// SPDX-License-Identifier: Apache-2.0
// For programs that are told to end and cannot wait until the work that they cancelled has stopped.
#pragma once
#include <rakelight/export.h>

namespace rakelight {

/// Removes the temporary files and folders of all outputs that are being written by this process. What was whole stays. To be
/// called last: the process must end now, for what is still being written fails. Async-signal-safe.
RL_API void remove_unfinished_outputs() noexcept;

}  // namespace rakelight
