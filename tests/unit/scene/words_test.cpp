// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/words.h>

using namespace rakelight;

TEST(Words, DistanceCountsLettersPutInLeftOutReplacedAndSwapped) {
    EXPECT_EQ(spelling_distance("position", "position"), 0u);
    EXPECT_EQ(spelling_distance("postion", "position"), 1u);
    EXPECT_EQ(spelling_distance("ligth", "light"), 1u);
    EXPECT_EQ(spelling_distance("", "abc"), 3u);
    EXPECT_EQ(spelling_distance("kitten", "sitting"), 3u);
}

TEST(Words, TheNearestIsFoundOnlyWhereOneIsNear) {
    EXPECT_EQ(nearest_word("roughnes", {"metallic", "roughness"}), "roughness");
    EXPECT_EQ(nearest_word("rough", {"metallic", "roughness"}), "roughness");  // begun
    EXPECT_EQ(nearest_word("elephant", {"metallic", "roughness"}), "");
    EXPECT_EQ(nearest_word("a", {}), "");
}
