// SPDX-License-Identifier: Apache-2.0
// Hashes of positions: what a crafted file can and cannot do, and that no result depends on the key.
#include "geometry/input/position_hash.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>
#include <vector>

namespace rakelight::geometry {
namespace {

using Bits = std::uint64_t[3];

/// A hash without a key, as many programs have it: xor, multiply, shift.
std::uint64_t unkeyed(std::uint64_t h, std::uint64_t bits) {
    h = (h ^ bits ^ (bits >> 32)) * 0x9e3779b97f4a7c15ull;
    return h ^ (h >> 29);
}

/// The y that takes unkeyed(unkeyed(0, x), y) to the same number for each x: all steps can be undone.
std::uint64_t y_that_meets(std::uint64_t x) {
    const std::uint64_t wanted = 0x123456789abcdefull ^ unkeyed(0, x);
    return wanted ^ (wanted >> 32);
}

std::size_t different(const std::vector<std::uint64_t>& xs, HashKey key) {
    std::set<std::uint32_t> hashes;
    for (const std::uint64_t x : xs) {
        const std::uint64_t h = hash_of_bits({x, y_that_meets(x), 0}, 0, key);
        hashes.insert(std::uint32_t(h ^ (h >> 32)));
    }
    return hashes.size();
}

TEST(PositionHash, PositionsMadeToMeetUnderAHashWithoutAKeyDoNotMeet) {
    std::vector<std::uint64_t> xs;
    std::set<std::uint64_t> met;
    for (int i = 0; i < 20'000; ++i) {
        xs.push_back(std::bit_cast<std::uint64_t>(1.0 + i));
        met.insert(unkeyed(unkeyed(0, xs.back()), y_that_meets(xs.back())));
    }
    ASSERT_EQ(met.size(), 1u);  // they are crafted well
    // Of n numbers of 32 bits about n^2 / 2^33 meet by chance: 0.05 here.
    for (const HashKey key : {hash_key_of_this_run(), HashKey{1, 2}, HashKey{0x243f6a8885a308d3ull, 77}})
        EXPECT_GE(different(xs, key), xs.size() - 3);
}

TEST(PositionHash, AnotherKeyPartsWhatMeetsUnderOne) {
    const HashKey one{0x1234567890abcdefull, 0xfedcba0987654321ull},
        other{0x1234567890abcdeeull, 0xfedcba0987654321ull};
    int together = 0;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const Bits bits = {std::bit_cast<std::uint64_t>(double(i)), 0, 0};
        together += std::uint32_t(hash_of_bits(bits, 0, one)) == std::uint32_t(hash_of_bits(bits, 0, other));
    }
    EXPECT_LE(together, 1);
}

TEST(PositionHash, PositionsOfAGridFillATableEvenly) {
    // 65536 balls in as many bins: the fullest has about 8, and 14 once in a million runs.
    const HashKey key = hash_key_of_this_run();
    for (const int shift : {0, 16}) {  // low bits, and higher ones
        std::vector<int> bins(1 << 16);
        for (int x = 0; x < 64; ++x)
            for (int y = 0; y < 32; ++y)
                for (int z = 0; z < 32; ++z) {
                    const Bits bits = {std::bit_cast<std::uint64_t>(0.25 * x), std::bit_cast<std::uint64_t>(0.5 * y),
                                       std::bit_cast<std::uint64_t>(double(z))};
                    const std::uint64_t h = hash_of_bits(bits, 0, key);
                    int& count = bins[std::size_t(std::uint32_t(h ^ (h >> 32)) >> shift) & 0xffff];
                    EXPECT_LT(++count, 14);
                }
    }
}

TEST(PositionHash, IsTheSameThroughoutARun) {
    EXPECT_EQ(hash_key_of_this_run().a, hash_key_of_this_run().a);
    EXPECT_EQ(hash_key_of_this_run().b, hash_key_of_this_run().b);
}

}  // namespace
}  // namespace rakelight::geometry
