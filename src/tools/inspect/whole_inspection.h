// SPDX-License-Identifier: Apache-2.0
// Inspections are plain data: a caller may pass one that differs from what inspect() returned.
#pragma once
#include <rakelight/tools/inspect.h>

namespace rakelight {

/// @throws Error usage: a number of an object, or a size, that does not fit the others
void check_whole(const Inspection& inspection);

}  // namespace rakelight
