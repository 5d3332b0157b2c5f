// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "io/obj/obj_numbers.h"

namespace rakelight::io::obj {
namespace {

TEST(ObjNumbers, UsualFormsAreRead) {
    EXPECT_EQ(parse_number("1"), 1.0);
    EXPECT_EQ(parse_number("+2."), 2.0);
    EXPECT_EQ(parse_number("-.7e+2"), -70.0);
    EXPECT_EQ(parse_number(".8e-1"), 0.08);
    EXPECT_EQ(parse_number("3.1E2"), 310.0);
    EXPECT_EQ(parse_number("500000.123"), 500000.123);
    EXPECT_TRUE(std::signbit(*parse_number("-0")));
}

TEST(ObjNumbers, TrailingGarbageIsNoNumber) {
    for (const char* text :
         {"", "+", "-", ".", "1,5", "3.1+e2", "0x10", "1e", "1.5f", "--1", "+-1", "1 ", "e5", "12abc"})
        EXPECT_FALSE(parse_number(text)) << text;
}

TEST(ObjNumbers, NotFiniteNumbersAreNaN) {
    for (const char* text : {"nan", "-nan", "inf", "-INF", "infinity", "1e999", "-1e400", "+1e99999999999999999999"}) {
        const auto value = parse_number(text);
        ASSERT_TRUE(value) << text;
        EXPECT_TRUE(std::isnan(*value)) << text;
    }
    EXPECT_TRUE(std::isnan(*parse_number(std::string(400, '9'))));
}

TEST(ObjNumbers, TooSmallNumbersAreZero) {
    EXPECT_EQ(parse_number("1e-999"), 0.0);
    EXPECT_EQ(parse_number("-1e-99999999999999999999"), 0.0);
    EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1"), 0.0);
    EXPECT_EQ(parse_number("0e99999999999999999999").value_or(0), 0.0);
}

TEST(ObjNumbers, IntegersThatDoNotFitAreRefused) {
    EXPECT_EQ(parse_integer("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(parse_integer("+7"), 7);
    for (const char* text : {"", "9223372036854775808", "99999999999999999999", "1.0", "1e3", "x", "+-1"})
        EXPECT_FALSE(parse_integer(text)) << text;
}

TEST(ObjNumbers, AllFormsOfCornersAreRead) {
    const auto v = parse_face_token("7"), vt = parse_face_token("7/8"), vn = parse_face_token("-7//-9"),
               vtn = parse_face_token("7/8/9"), open = parse_face_token("1//"), half = parse_face_token("1/");
    ASSERT_TRUE(v && vt && vn && vtn && open && half);
    EXPECT_EQ(v->position, 7);
    EXPECT_FALSE(v->texcoord || v->normal || open->texcoord || open->normal || half->texcoord || vn->texcoord);
    EXPECT_EQ(vt->texcoord, 8);
    EXPECT_EQ(vn->position, -7);
    EXPECT_EQ(vn->normal, -9);
    EXPECT_EQ(vtn->normal, 9);
    for (const char* text : {"", "/", "//1", "1/2/3/4", "1/x", "1//x", "1.5", "1/2/3x", "1\\2"})
        EXPECT_FALSE(parse_face_token(text)) << text;
}

}  // namespace
}  // namespace rakelight::io::obj
