// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/context.h>

#include <atomic>
#include <utility>
#include <vector>

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
    EXPECT_THROW(context.parallel_for(4, [](std::size_t i) { if (i == 2) throw Error(ErrorCode::failed, "x"); }), Error);
    context.parallel_for(0, [](std::size_t) { FAIL(); });
}

TEST(Context, RefusesImpossibleThreadCounts) {
    EXPECT_THROW(Context({.threads = -1}), Error);
    EXPECT_THROW(Context({.threads = 2000}), Error);
    EXPECT_GE(Context().threads(), 1);
}

TEST(MemoryBudget, AllowsTwoGibOrSixtyFourBytesAByteRead) {
    MemoryBudget m;
    EXPECT_EQ(m.limit(), 2ull << 30);
    EXPECT_THROW(m.charge((2ull << 30) + 1, "accessor 0"), Error);
    m.charge(1ull << 30, "a");
    m.charge(1ull << 30, "b");
    EXPECT_THROW(m.charge(1, "c"), Error);
    m.note_read(1ull << 26);
    EXPECT_EQ(m.limit(), 1ull << 32);
    EXPECT_NO_THROW(m.charge(1, "c"));
    EXPECT_THROW(m.charge(~0ull, "d"), Error) << "no overflow";
}

TEST(MemoryBudget, TheUsersLimitReplacesTheRule) {
    MemoryBudget m(1000);
    m.note_read(1 << 20);
    EXPECT_THROW(m.check(1001, "x"), Error);
    EXPECT_NO_THROW(m.check(1000, "x"));
}

TEST(MemoryBudget, KnowsWhetherTheOrderOfRequestsMattered) {
    MemoryBudget m(1000);
    m.charge(400, "a");
    m.check(600, "b");
    EXPECT_TRUE(m.grants_in_any_order());
    m.charge(1, "c");
    EXPECT_FALSE(m.grants_in_any_order()) << "the check would have failed after this";
    m.release(1);
    EXPECT_EQ(m.charged(), 400u);
    EXPECT_TRUE(m.grants_in_any_order());
    EXPECT_THROW(m.charge(601, "d"), Error);
    EXPECT_FALSE(m.grants_in_any_order());
    EXPECT_NO_THROW(m.charge(600, "e"));
}

TEST(MemoryCharge, IsGivenBackOnceWhoeverHasItAndOutlivesItsBudget) {
    MemoryCharge kept;
    {
        MemoryBudget budget(1000);
        MemoryCharge first(budget, 600, "maps");
        EXPECT_EQ(budget.charged(), 600u);
        EXPECT_THROW(MemoryCharge(budget, 500, "more maps"), Error);
        EXPECT_EQ(budget.charged(), 600u);
        kept = std::move(first);
        EXPECT_EQ(first.bytes(), 0u);
        EXPECT_EQ(kept.bytes(), 600u);
        {
            const MemoryCharge second(budget, 400, "more maps");
            EXPECT_EQ(budget.charged(), 1000u);
        }
        EXPECT_EQ(budget.charged(), 600u);
        kept = {};
        EXPECT_EQ(budget.charged(), 0u);
        kept = MemoryCharge(budget, 10, "maps");
    }
    EXPECT_EQ(kept.bytes(), 10u);
}

TEST(MemoryBudget, ThreadsTogetherNeverGetMoreThanTheLimit) {
    Context context({.threads = 4, .max_memory = 1000});
    for (int round = 0; round < 50; ++round) {
        MemoryBudget m(1000);
        std::atomic<int> granted{0};
        context.parallel_for(4000, [&](std::size_t) {
            try {
                m.charge(1, "x");
                ++granted;
            } catch (const Error&) {
            }
        });
        ASSERT_EQ(granted, 1000);
    }
}

TEST(Context, AnExceptionOfOneBodyOfManyComesOutOnceAndTheContextStaysUsable) {
    for (int threads : {1, 2, 4}) {
        Context context({.threads = threads});
        EXPECT_THROW(context.parallel_for(1000, [](std::size_t i) { if (i % 7 == 3) throw Error(ErrorCode::failed, "x"); }), Error);
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
