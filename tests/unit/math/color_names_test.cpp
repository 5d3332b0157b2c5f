// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "math/color_names.h"

namespace rakelight {
namespace {

using Codes = std::array<std::uint8_t, 3>;

TEST(ColorNames, KnownValuesOfCssInAnyCase) {
    EXPECT_EQ(color_by_text("white"), (Codes{255, 255, 255}));
    EXPECT_EQ(color_by_text("GRAY"), (Codes{128, 128, 128}));
    EXPECT_EQ(color_by_text("grey"), color_by_text("gray"));
    EXPECT_EQ(color_by_text("RebeccaPurple"), (Codes{0x66, 0x33, 0x99}));
    EXPECT_EQ(color_by_text("lightgoldenrodyellow"), (Codes{0xfa, 0xfa, 0xd2}));
}

TEST(ColorNames, CodesHaveThreeOrSixDigits) {
    EXPECT_EQ(color_by_text("#ff8000"), (Codes{255, 128, 0}));
    EXPECT_EQ(color_by_text("#F80"), (Codes{255, 136, 0}));
    EXPECT_EQ(color_by_text("#000"), (Codes{0, 0, 0}));
    for (const char* none : {"", "#", "#ff", "#ffff", "#fffff", "#fffffff", "#ggg", "#-12", "#+12345", "# 12", "ff8000",
                             "whit", "white ", "1,0,0"})
        EXPECT_FALSE(color_by_text(none)) << none;
}

TEST(ColorNames, EveryNameIsThereOnceAndIsRead) {
    const std::vector<std::string_view> names = color_names();
    EXPECT_EQ(names.size(), 148u);
    EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), names.size());
    for (const std::string_view name : names) EXPECT_TRUE(color_by_text(name)) << name;
}

}  // namespace
}  // namespace rakelight
