// SPDX-License-Identifier: Apache-2.0
// Of a build that starts no other programs (RAKELIGHT_PROCESSES=OFF).
#include <rakelight/base/error.h>

#include "view_verb.h"

namespace rakelight::cli {

bool can_view() { return false; }

void become_viewer(const std::vector<std::string>&, const std::vector<std::string>&, bool) {
    throw Error(ErrorCode::usage, "this build has no window", {}, "name an output with -o");
}

}  // namespace rakelight::cli
