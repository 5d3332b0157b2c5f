// SPDX-License-Identifier: Apache-2.0
#include "base/format_text.h"

#include <string_view>

#include <gtest/gtest.h>

namespace rakelight {
namespace {

TEST(FormatText, PutsValuesIntoThePattern) {
    EXPECT_EQ(
        format_text("index {} at corner {} exceeds {} {}", 4711, std::size_t(3), std::string_view("96"), "vertices"),
        "index 4711 at corner 3 exceeds 96 vertices");
}

TEST(FormatText, WritesNumbersWithTheDigitsAskedFor) {
    EXPECT_EQ(format_text("{:.3g} {:g} {:>4}", 3.14159, 0.5f, 7), "3.14 0.5    7");
}

TEST(FormatText, DoubledBracesAreBraces) { EXPECT_EQ(format_text("{{frame}} {}", 1), "{frame} 1"); }

}  // namespace
}  // namespace rakelight
