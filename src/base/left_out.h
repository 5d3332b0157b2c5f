// SPDX-License-Identifier: Apache-2.0
// The error for a part that was left out of this build.
#pragma once
#include <rakelight/base/error.h>

#include <string>

namespace rakelight {

/// "WHAT: this build leaves LIBRARY out; build Rakelight with -DOPTION=ON"
inline Error left_out(const std::string& what, const std::string& library, const std::string& option,
                      ErrorCode code = ErrorCode::bad_file) {
    return Error(code, what + ": this build leaves " + library + " out", {},
                 "build Rakelight with -D" + option + "=ON");
}

}  // namespace rakelight
