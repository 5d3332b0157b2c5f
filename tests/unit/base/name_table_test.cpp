// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "base/name_table.h"

using namespace rakelight;

namespace {
constexpr HashKey key{0x0123456789abcdefull, 0xfedcba9876543211ull},
    other_key{0x243f6a8885a308d3ull, 0x13198a2e03707344ull};

/// Bits that differ, as a share of 64.
double difference(std::uint64_t a, std::uint64_t b) { return double(__builtin_popcountll(a ^ b)) / 64; }
}  // namespace

TEST(NameTable, EveryByteAndTheNumberOfBytesCount) {
    std::set<std::uint64_t> hashes;
    std::size_t texts = 0;
    for (std::size_t size = 0; size <= 40; ++size) {
        const std::string zeros(size, '\0');  // as the filled up end of a shorter text
        hashes.insert(hash_of_text(zeros, key)), ++texts;
        for (std::size_t i = 0; i < size; ++i)
            for (const char c : {'\1', '\x80', 'a'}) {
                std::string text = zeros;
                text[i] = c;
                hashes.insert(hash_of_text(text, key)), ++texts;
            }
    }
    EXPECT_EQ(hashes.size(), texts);
}

TEST(NameTable, OneBitOfATextChangesHalfOfTheHash) {
    std::string text = "the quick brown fox jumps over it";
    const std::uint64_t hash = hash_of_text(text, key);
    double sum = 0;
    for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
        text[bit / 8] = char(text[bit / 8] ^ 1 << bit % 8);
        sum += difference(hash, hash_of_text(text, key));
        text[bit / 8] = char(text[bit / 8] ^ 1 << bit % 8);
    }
    EXPECT_NEAR(sum / double(8 * text.size()), 0.5, 0.02);
}

/// Whoever does not know the key cannot choose names that meet in one slot: with another key they are spread anew.
TEST(NameTable, NamesThatMeetUnderOneKeyDoNotUnderAnother) {
    constexpr std::uint64_t slots = 1024;
    std::set<std::uint64_t> met;
    std::size_t names = 0;
    for (int i = 0; names < 100; ++i) {
        const std::string name = "part_" + std::to_string(i);
        if (hash_of_text(name, key) % slots != 7) continue;
        met.insert(hash_of_text(name, other_key) % slots), ++names;
    }
    EXPECT_GT(met.size(), 80u);  // 95 of 100 are expected
}

TEST(NameTable, FindsNamesByViewsOfThem) {
    NameMap<int> table{{"left", 1}, {"right", 2}, {"", 3}};
    EXPECT_EQ(table.find(std::string_view("right of it").substr(0, 5))->second, 2);
    EXPECT_EQ(table.find(std::string_view())->second, 3);
    EXPECT_FALSE(table.contains(std::string_view("up")));
    const NameSet names{"a", "b", "a"};
    EXPECT_EQ(names.size(), 2u);
}
