// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/base/context.h>

#include <atomic>
#include <utility>
#include <vector>

using namespace rakelight;

TEST(MemoryBudget, AllowsTwoGibOrSixtyFourBytesAByteRead) {
    MemoryBudget m;
    EXPECT_EQ(m.limit(), 2ull << 30);
    EXPECT_THROW(MemoryCharge(m, (2ull << 30) + 1, "accessor 0"), Error);
    const MemoryCharge a(m, 1ull << 30, "a"), b(m, 1ull << 30, "b");
    EXPECT_THROW(MemoryCharge(m, 1, "c"), Error);
    const MemoryCharge file = MemoryCharge::of_file(m, 1ull << 26, "the file");
    EXPECT_EQ(m.limit(), 1ull << 32);
    EXPECT_NO_THROW(MemoryCharge(m, 1, "c"));
    EXPECT_THROW(MemoryCharge(m, ~0ull, "d"), Error) << "no overflow";
}

TEST(MemoryBudget, WhatWasReadCountsUntilNothingIsChargedAnyMore) {
    constexpr std::uint64_t usual = 2ull << 30;
    MemoryBudget m;
    for (int round = 0; round < 3; ++round) {
        MemoryCharge scene;
        {
            const MemoryCharge file = MemoryCharge::of_file(m, 1ull << 26, "the file");
            EXPECT_EQ(m.charged(), 1ull << 26);
            EXPECT_EQ(m.limit(), 1ull << 32);
            scene = MemoryCharge(m, 3ull << 30, "the scene");
        }
        EXPECT_EQ(m.limit(), 1ull << 32) << "the scene is still there";
        scene.shrink(1);
        EXPECT_EQ(m.limit(), 1ull << 32);
        scene = {};
        EXPECT_EQ(m.limit(), usual) << "round " << round;
    }
    const MemoryCharge large = MemoryCharge::of_file(m, 3ull << 30, "the file");
    EXPECT_EQ(large.bytes(), 3ull << 30) << "a file pays for itself";
}

TEST(MemoryBudget, AFileThatTheUsersLimitRefusesIsNotCharged) {
    MemoryBudget m(1000);
    EXPECT_THROW(MemoryCharge::of_file(m, 1001, "the file"), Error);
    EXPECT_EQ(m.charged(), 0u);
    EXPECT_EQ(m.refusals(), 1u);
}

TEST(MemoryBudget, TheUsersLimitReplacesTheRule) {
    MemoryBudget m(1000);
    EXPECT_THROW(MemoryCharge::of_file(m, 1 << 20, "the file"), Error);
    EXPECT_THROW(m.check(1001, "x"), Error);
    EXPECT_NO_THROW(m.check(1000, "x"));
}

TEST(MemoryBudget, CountsWhatItRefused) {
    MemoryBudget m(1000);
    const MemoryCharge a(m, 400, "a");
    m.check(600, "b");
    EXPECT_EQ(m.refusals(), 0u);
    EXPECT_THROW(m.check(601, "c"), Error);
    EXPECT_THROW(MemoryCharge(m, 601, "d"), Error);
    EXPECT_EQ(m.refusals(), 2u);
    EXPECT_EQ(m.charged(), 400u);
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

TEST(MemoryCharge, GrowsShrinksAndIsSplit) {
    MemoryBudget budget(1000);
    MemoryCharge all(budget);
    all.grow(700, "names");
    EXPECT_THROW(all.grow(301, "names"), Error);
    EXPECT_EQ(all.bytes(), 700u);
    all.shrink(100);
    EXPECT_EQ(budget.charged(), 600u);
    {
        const MemoryCharge part = all.split(250), rest = all.split(1000);
        EXPECT_EQ(part.bytes(), 250u);
        EXPECT_EQ(rest.bytes(), 350u) << "no more than there is";
        EXPECT_EQ(all.bytes(), 0u);
        EXPECT_EQ(budget.charged(), 600u);
    }
    EXPECT_EQ(budget.charged(), 0u);
    all.grow(5, "names");
    all.shrink(100);
    EXPECT_EQ(all.bytes(), 0u) << "no more than there is";
    EXPECT_EQ(budget.charged(), 0u);
    MemoryCharge nobodys;
    EXPECT_EQ(nobodys.split(10).bytes(), 0u);
}

TEST(MemoryCharge, SharedByManyItEndsWithTheLast) {
    MemoryBudget budget(1000);
    SharedCharge one = share(MemoryCharge(budget, 10, "names"));
    SharedCharge other = one;
    one.reset();
    EXPECT_EQ(budget.charged(), 10u);
    other.reset();
    EXPECT_EQ(budget.charged(), 0u);
}

TEST(MemoryBudget, ThreadsTogetherNeverGetMoreThanTheLimit) {
    Context context({.threads = 4, .max_memory = 1000});
    for (int round = 0; round < 50; ++round) {
        MemoryBudget m(1000);
        MemoryCharge all(m);
        std::atomic<int> granted{0};
        context.parallel_for(4000, [&](std::size_t) {
            try {
                all.grow(1, "x");
                ++granted;
            } catch (const Error&) {
            }
        });
        ASSERT_EQ(granted, 1000);
        ASSERT_EQ(all.bytes(), 1000u);
    }
}
