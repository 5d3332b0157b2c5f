// SPDX-License-Identifier: Apache-2.0
// Option values, in the program's namespace.
#pragma once
#include <rakelight/tools/values.h>

namespace rakelight::cli {
using namespace rakelight::values;
}
