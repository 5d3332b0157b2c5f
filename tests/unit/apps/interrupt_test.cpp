// SPDX-License-Identifier: Apache-2.0
// How a program ends after a signal: each case in a process of its own.
#include "../../../apps/common/interrupt.h"

#include <unistd.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace rakelight::apps {
namespace {

using testing::Eq, testing::ExitedWithCode, testing::KilledBySignal;

constexpr const char* words = "model.obj: cancelled\n";

[[noreturn]] void wait_for_ever() {
    for (;;) pause();
}

/// What fails because it was cancelled, and says so.
void fail_in_words() {
    CancelOnInterrupt::words_are_said();
    std::fputs(words, stderr);
}

[[noreturn]] void end(int code) { std::_Exit(CancelOnInterrupt::end_by_signal(code)); }

TEST(InterruptDeathTest, WorkThatIsCancelledEndsByTheSignalWithOneLine) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        EXPECT_EXIT(
            {
                Context context({.threads = 1});
                {
                    const CancelOnInterrupt guard(context, words);
                    std::raise(signal);
                    if (context.cancelled()) fail_in_words();
                }
                end(1);
            },
            KilledBySignal(signal), Eq(words));
}

TEST(InterruptDeathTest, WorkThatDoesNotStopIsEndedWithOneLine) {
    EXPECT_EXIT(
        {
            Context context({.threads = 1});
            const CancelOnInterrupt guard(context, words);
            std::raise(SIGTERM);
            wait_for_ever();
        },
        KilledBySignal(SIGTERM), Eq(words));
}

TEST(InterruptDeathTest, WordsThatWereSaidAreNotSaidAgain) {
    EXPECT_EXIT(
        {
            Context context({.threads = 1});
            const CancelOnInterrupt guard(context, words);
            std::raise(SIGTERM);
            fail_in_words();
            wait_for_ever();
        },
        KilledBySignal(SIGTERM), Eq(words));
}

TEST(InterruptDeathTest, WordsThatWereSaidAreNotSaidByALaterGuard) {
    EXPECT_EXIT(
        {
            Context context({.threads = 1});
            {
                const CancelOnInterrupt guard(context, words);
                std::raise(SIGTERM);
                fail_in_words();
            }
            Context other({.threads = 1});
            { const CancelOnInterrupt guard(other, ""); }
            CancelOnInterrupt::happened();
            end(1);
        },
        KilledBySignal(SIGTERM), Eq(words));
}

TEST(InterruptDeathTest, ASignalAfterTheWorkChangesNothing) {
    const auto work = [] {
        Context context({.threads = 1});
        const CancelOnInterrupt guard(context, words);
    };
    EXPECT_EXIT(work(); std::raise(SIGTERM); end(5), ExitedWithCode(5), Eq(""));
    EXPECT_EXIT(work(); CancelOnInterrupt::end_by_signal(5); std::raise(SIGTERM);
                wait_for_ever(), ExitedWithCode(5), Eq(""));
}

TEST(InterruptDeathTest, WorkThatIsNotBegunForItIsSaid) {
    EXPECT_EXIT(
        {
            Context context({.threads = 1});
            { const CancelOnInterrupt guard(context, words); }
            std::raise(SIGHUP);
            end(CancelOnInterrupt::happened() ? 0 : 1);
        },
        KilledBySignal(SIGHUP), Eq("rakelight: error: cancelled\n"));
}

TEST(InterruptDeathTest, WhoStandsByEndsAtOnce) {
    EXPECT_EXIT(
        {
            Context context({.threads = 1});
            { const CancelOnInterrupt guard(context, words); }
            CancelOnInterrupt::stand_by();
            std::raise(SIGINT);
            end(0);
        },
        KilledBySignal(SIGINT), Eq(""));
}

TEST(InterruptDeathTest, WhatNohupIgnoresStaysIgnored) {
    EXPECT_EXIT(
        {
            std::signal(SIGHUP, SIG_IGN);
            Context context({.threads = 1});
            const CancelOnInterrupt guard(context, words);
            std::raise(SIGHUP);
            end(context.cancelled());
        },
        ExitedWithCode(0), Eq(""));
}

}  // namespace
}  // namespace rakelight::apps
