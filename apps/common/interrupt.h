// SPDX-License-Identifier: Apache-2.0
// Ctrl-C, SIGTERM and SIGHUP cancel the run, so that no temporary file stays. Work that does not stop within 0.3
// seconds (of a library that cannot be cancelled) is ended then, and a second signal ends the program at once. Then
// --json prints no rows, but temporary files are removed. The import helper dies with its parent. A signal that comes
// when all the work is done changes nothing. SIGXFSZ is ignored: writing beyond the file size limit is an error with a
// message then.
#pragma once
#include <string>

#include <rakelight/base/context.h>

namespace rakelight::apps {

/// While it lives, signals cancel the context. After it they are only noted, for happened() and for end_by_signal().
class CancelOnInterrupt {
public:
    /// @param last_words  a line for standard error, where the program is ended before it says anything; may be empty
    CancelOnInterrupt(Context& context, std::string last_words);
    ~CancelOnInterrupt();
    CancelOnInterrupt(const CancelOnInterrupt&) = delete;
    CancelOnInterrupt& operator=(const CancelOnInterrupt&) = delete;

    /// Whether a signal came at any time: no further file is to be begun. The program then ends by that signal.
    static bool happened();

    /// The caller says, in a line of its own, that the work has failed: no other is printed.
    static void words_are_said();

    /// From now on what is interrupted may take its time to finish, as files that are kept; a second signal still ends it at once.
    static void let_finish();

    /// There is nothing to finish: until the next work begins, a signal ends the program at once.
    static void stand_by();

    /// The last thing that a program does. Where a signal has cut its work short, it ends by that signal, so that a shell
    /// sees it and stops its loop too. @return `code`, where all the work is done
    static int end_by_signal(int code);

private:
    std::string last_words_;
};

}  // namespace rakelight::apps
