// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/background/background.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace rakelight::viewer {
namespace {

/// Ends when it is cancelled, and not before.
Background::Finish wait_for_cancel(Context& context) {
    for (;;) {
        context.throw_if_cancelled();
        std::this_thread::yield();
    }
}

void poll_until_done(Background& background) {
    while (background.is_running()) background.poll(), std::this_thread::yield();
}

TEST(Background, FinishesInTheThreadThatPolls) {
    Background background([] {}, 1, 0);
    std::thread::id worked, finished;
    const auto work = [&](Context&) -> Background::Finish {
        worked = std::this_thread::get_id();
        return [&] { finished = std::this_thread::get_id(); };
    };
    background.start("work", work, [](const Error&) { FAIL(); });
    EXPECT_TRUE(background.is_running());
    poll_until_done(background);
    EXPECT_EQ(finished, std::this_thread::get_id());
    EXPECT_NE(worked, finished);
}

TEST(Background, TellsWhatFailed) {
    Background background([] {}, 1, 0);
    std::string told;
    background.start(
        "work", [](Context&) -> Background::Finish { throw Error(ErrorCode::bad_file, "broken"); },
        [&](const Error& error) { told = error.reason(); });
    poll_until_done(background);
    EXPECT_EQ(told, "broken");
}

TEST(Background, EndsWhenItIsCancelled) {
    Background background([] {}, 1, 0);
    std::string told;
    background.start("work", wait_for_cancel, [&](const Error& error) { told = error.reason(); });
    background.cancel();
    poll_until_done(background);
    EXPECT_EQ(told, "cancelled");
}

TEST(Background, ANewWorkTakesThePlaceOfOneThatDoesNotListen) {
    std::atomic<int> ends{0};
    Background background([&] { ++ends; }, 1, 0);
    std::atomic<bool> may_end{false};
    bool is_first_told = false, is_second_done = false;
    const auto deaf = [&](Context&) -> Background::Finish {
        while (!may_end) std::this_thread::yield();
        return [&] { is_first_told = true; };
    };
    background.start("first", deaf, [&](const Error&) { is_first_told = true; });
    background.start(
        "second", [&](Context&) -> Background::Finish { return [&] { is_second_done = true; }; },
        [](const Error&) { FAIL(); });
    poll_until_done(background);  // would hang if anybody waited for the first
    EXPECT_TRUE(is_second_done);
    may_end = true;
    while (ends < 2) std::this_thread::yield();
    background.poll();  // which finds the first one ended
    EXPECT_FALSE(is_first_told);
}

TEST(Background, QueuedWorksAllEndOneAfterTheOther) {
    Background background([] {}, 1, 0);
    std::atomic<int> running{0};
    std::string ended, told;
    for (const char c : {'a', 'b', 'c', 'd'}) {
        const auto work = [&, c](Context&) -> Background::Finish {
            EXPECT_EQ(++running, 1);
            std::this_thread::yield();
            --running;
            if (c == 'b') throw Error(ErrorCode::failed, "broken");
            return [&, c] { ended += c; };
        };
        background.queue("work", work, [&](const Error& error) { ended += '!', told = error.reason(); });
    }
    EXPECT_EQ(background.waiting(), 3u);
    poll_until_done(background);
    EXPECT_EQ(ended, "a!cd");
    EXPECT_EQ(told, "broken");
}

TEST(Background, ACancelTellsHowManyWaited) {
    Background background([] {}, 1, 0);
    std::string told;
    background.queue("first", wait_for_cancel, [&](const Error& error) { told += error.reason(); });
    for (int i = 0; i < 2; ++i)
        background.queue(
            "next", [](Context&) -> Background::Finish { return [] { FAIL(); }; }, [](const Error&) { FAIL(); });
    EXPECT_EQ(background.cancel(), 2u);
    poll_until_done(background);
    EXPECT_EQ(told, "cancelled");
    EXPECT_EQ(background.cancel(), 0u);
}

TEST(Background, NobodyIsWokenAfterItsEnd) {
    std::atomic<bool> has_ended{false}, was_woken_after{false};
    Background background([&] { was_woken_after = was_woken_after || has_ended; }, 1, 0);
    for (int i = 0; i < 3; ++i) background.start("work", wait_for_cancel, [](const Error&) { FAIL(); });
    background.queue(
        "next", [](Context&) -> Background::Finish { return [] { FAIL(); }; }, [](const Error&) { FAIL(); });
    background.end();
    has_ended = true;
    EXPECT_FALSE(background.is_running());
    background.poll();
    EXPECT_FALSE(was_woken_after);
}

TEST(Background, ItsEndCancelsWhatRuns) {
    Background background([] {}, 1, 0);
    background.start("work", wait_for_cancel, [](const Error&) { FAIL(); });
}

}  // namespace
}  // namespace rakelight::viewer
