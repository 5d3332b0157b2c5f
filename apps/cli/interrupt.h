// SPDX-License-Identifier: Apache-2.0
// Ctrl-C, SIGTERM and SIGHUP cancel the run, so that no temporary file stays. Work that does not stop within 0.3
// seconds (of a library that cannot be cancelled) is ended then, and a second signal ends the program at once. Then
// --json prints no rows, but temporary files are removed. The import helper dies with its parent. SIGXFSZ is ignored:
// writing beyond the file size limit is an error with a message then.
#pragma once
#include <string>

#include <rakelight/context.h>

namespace rakelight::cli {

class CancelOnInterrupt {
public:
    /// @param file  the input that a message names
    CancelOnInterrupt(Context& context, const std::string& file);
    ~CancelOnInterrupt();
    CancelOnInterrupt(const CancelOnInterrupt&) = delete;
    CancelOnInterrupt& operator=(const CancelOnInterrupt&) = delete;

    /// Whether a signal came at any time: no further file is to be begun.
    static bool happened();

    /// From now on what is interrupted may take its time to finish, as files that are kept; a second signal still ends it at once.
    static void let_finish();

    /// Ends the program by the signal that came, so that a shell sees it and stops its loop too; returns where none came.
    static void die_of_signal();

private:
    std::string last_words_;
};

}  // namespace rakelight::cli
