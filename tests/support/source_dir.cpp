// SPDX-License-Identifier: Apache-2.0
#include "support/shared.h"

namespace rakelight::test {

std::filesystem::path source_dir() { return RL_SOURCE_DIR; }

}  // namespace rakelight::test
