// SPDX-License-Identifier: Apache-2.0
// Ctrl-C, SIGTERM and SIGHUP cancel the run, so that no temporary file stays; a second one ends the program at once.
// SIGXFSZ is ignored: writing beyond the file size limit is an error with a message then.
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

    /// Ends the program by the signal that came, so that a shell sees it and stops its loop too; returns where none came.
    static void die_of_signal();
};

}  // namespace rakelight::cli
