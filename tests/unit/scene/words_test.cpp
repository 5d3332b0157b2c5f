// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/scene/words.h>

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
    const std::string long_word(65, 'r');
    EXPECT_EQ(nearest_word(long_word, {long_word}),
              "");  // names of files may be long, and the time is a product of lengths
}

TEST(Words, ListsOfLongNamesAreCutBehindAWholeName) {
    std::vector<std::string> names;
    for (int i = 0; i < 40; ++i) names.push_back("metallic_roughness_texture_" + std::to_string(i));
    EXPECT_EQ(list_of_names(names, 40),
              "metallic_roughness_texture_0, metallic_roughness_texture_1, metallic_roughness_texture_2, "
              "metallic_roughness_texture_3 and 36 more");
}

TEST(Words, ListsOfNamesAreCutAndHaveNoDoubles) {
    EXPECT_EQ(list_of_names({}), "");
    EXPECT_EQ(list_of_names({"a"}), "a");
    EXPECT_EQ(list_of_names({"b", "a", "b", "a", "b"}), "b, a");
    EXPECT_EQ(list_of_names({"a", "b", "c", "d", "e"}), "a, b, c, d, e");
    EXPECT_EQ(list_of_names({"a", "b", "a", "c", "d", "e", "f", "f", "g"}), "a, b, c, d, e and 2 more");
    EXPECT_EQ(list_of_names({"a", "b", "c"}, 2), "a, b and 1 more");
    EXPECT_EQ(list_of_names({"", "x"}), ", x");
}

TEST(Words, NamesInAListAreShortAndPrintable) {
    EXPECT_EQ(list_of_names({"a\n\033[31m", "0123456789"}, 5, 8), "a??[31m, 01234...");
}
