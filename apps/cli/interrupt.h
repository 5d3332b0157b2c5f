// SPDX-License-Identifier: Apache-2.0
// Ctrl-C and SIGTERM cancel the run, so that no temporary file stays; a second one ends the program at once.
#pragma once
#include <rakelight/context.h>

namespace rakelight::cli {

class CancelOnInterrupt {
public:
    explicit CancelOnInterrupt(Context& context);
    ~CancelOnInterrupt();
    CancelOnInterrupt(const CancelOnInterrupt&) = delete;
    CancelOnInterrupt& operator=(const CancelOnInterrupt&) = delete;

    /// Whether a signal came at any time: no further file is to be begun.
    static bool happened();
};

}  // namespace rakelight::cli
