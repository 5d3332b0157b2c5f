// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/base/context.h>

#include <atomic>
#include <vector>

#include "base/cancel_check.h"

using namespace rakelight;

TEST(Context, ParallelForCallsEachIndexOnceForAnyNumberOfThreads) {
    for (int threads : {1, 2, 4}) {
        Context context({.threads = threads});
        std::vector<std::atomic<int>> calls(1000);
        context.parallel_for(calls.size(), [&](std::size_t i) { ++calls[i]; });
        for (const auto& c : calls) EXPECT_EQ(c, 1);
    }
}

TEST(Context, ParallelForNestsAndPassesExceptionsOn) {
    Context context({.threads = 2});
    std::atomic<int> sum{0};
    context.parallel_for(4, [&](std::size_t) { context.parallel_for(8, [&](std::size_t) { ++sum; }); });
    EXPECT_EQ(sum, 32);
    EXPECT_THROW(context.parallel_for(4,
                                      [](std::size_t i) {
                                          if (i == 2) throw Error(ErrorCode::failed, "x");
                                      }),
                 Error);
    context.parallel_for(0, [](std::size_t) { FAIL(); });
}

TEST(Context, KeepsTheFilesThatItIsToldOfEachOnce) {
    Context context;
    EXPECT_TRUE(context.files().empty());
    for (const char* name : {"b", "a", "b"}) context.note_file(name);
    EXPECT_EQ(context.files(), (std::vector<std::string>{"b", "a"}));
}

TEST(Context, RefusesImpossibleThreadCounts) {
    EXPECT_THROW(Context({.threads = -1}), Error);
    EXPECT_THROW(Context({.threads = 2000}), Error);
    EXPECT_GE(Context().threads(), 1);
}

TEST(Context, AnExceptionOfOneBodyOfManyComesOutOnceAndTheContextStaysUsable) {
    for (int threads : {1, 2, 4}) {
        Context context({.threads = threads});
        EXPECT_THROW(context.parallel_for(1000,
                                          [](std::size_t i) {
                                              if (i % 7 == 3) throw Error(ErrorCode::failed, "x");
                                          }),
                     Error);
        std::atomic<int> calls{0};
        context.parallel_for(1000, [&](std::size_t) { ++calls; });
        EXPECT_EQ(calls, 1000);
    }
}

TEST(Context, CancelIsSeen) {
    Context context;
    EXPECT_NO_THROW(context.throw_if_cancelled());
    context.cancel();
    EXPECT_THROW(context.throw_if_cancelled(), Error);
}

TEST(Context, IsUsableAgainAfterItsCancelIsTakenBack) {
    Context context;
    context.cancel();
    EXPECT_THROW(context.parallel_for(3, [](std::size_t) {}), Error);
    context.reset_cancel();
    EXPECT_FALSE(context.cancelled());
    std::atomic<int> calls{0};
    context.parallel_for(3, [&](std::size_t) { ++calls; });
    EXPECT_EQ(calls, 3);
}

TEST(Context, TakesTheImportHelperOfItsParentWhereItHasNone) {
    const Context parent({.import_helper = "/opt/helper"}), child({.parent = &parent}),
        own({.parent = &parent, .import_helper = "/usr/helper"}), none;
    EXPECT_EQ(child.import_helper(), "/opt/helper");
    EXPECT_EQ(own.import_helper(), "/usr/helper");
    EXPECT_EQ(none.import_helper(), "");
}

TEST(Context, CancellingAParentCancelsItsChildrenAndNotTheOtherWay) {
    Context parent;
    Context child({.threads = 1, .parent = &parent}), grandchild({.threads = 1, .parent = &child});
    child.cancel();
    EXPECT_TRUE(grandchild.cancelled());
    EXPECT_FALSE(parent.cancelled());
    Context other({.threads = 1, .parent = &parent});
    parent.cancel();
    EXPECT_THROW(other.throw_if_cancelled(), Error);
}

TEST(Context, NothingOfALoopBeginsAfterTheCancel) {
    for (int threads : {1, 2, 4}) {
        Context context({.threads = threads});
        std::atomic<int> calls{0};
        const auto call = [&](std::size_t) {
            ++calls;
            context.cancel();
        };
        EXPECT_THROW(context.parallel_for(100'000, call), Error);
        EXPECT_LE(calls, threads);  // each thread may have been at one
        const int before = calls;
        EXPECT_THROW(context.parallel_for(1, call), Error);
        EXPECT_EQ(calls, before);
    }
}

TEST(Context, AnInnerLoopStopsTheOuterOne) {
    Context context({.threads = 2});
    std::atomic<int> calls{0};
    EXPECT_THROW(context.parallel_for(100,
                                      [&](std::size_t) {
                                          context.parallel_for(100, [&](std::size_t) {
                                              ++calls;
                                              context.cancel();
                                          });
                                      }),
                 Error);
    EXPECT_LE(calls, 2);
}

TEST(CancelCheck, LooksNowAndThen) {
    Context context;
    CancelCheck check(context);
    for (int i = 0; i < 100'000; ++i) EXPECT_NO_THROW(check());
    context.cancel();
    int calls = 0;
    EXPECT_THROW(for (;; ++calls) check(), Error);
    EXPECT_LT(calls, 16'384);
}
