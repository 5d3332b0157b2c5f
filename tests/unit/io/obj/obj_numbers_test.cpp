// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
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

TEST(ObjNumbers, PlainNumbersHaveTheValueThatFromCharsGives) {
    std::mt19937 random(5);
    std::size_t plain = 0;
    for (int i = 0; i < 200'000; ++i) {
        std::string text = random() % 3 ? "" : "-";
        for (std::uint32_t n = random() % 10; n > 0; --n) text += char('0' + random() % 10);
        if (random() % 4) text += '.';
        for (std::uint32_t n = random() % 10; n > 0; --n) text += char('0' + random() % 10);
        if (random() % 16 == 0) text += "e5\\x,+/#"[random() % 8];
        const std::string line = text + (random() % 2 ? " 7" : "");
        double value = -1, expected = -1;
        const char* const end = obj::take_plain_number(line.data(), line.data() + line.size(), value);
        if (!end) continue;
        ++plain;
        ASSERT_EQ(std::size_t(end - line.data()), text.size()) << line;
        const auto [behind, error] = std::from_chars(text.data(), text.data() + text.size(), expected);
        ASSERT_TRUE(behind == text.data() + text.size() && error == std::errc()) << line;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << line;
    }
    EXPECT_GT(plain, 100'000u);
    double value = 0;
    const auto is_plain = [&](std::string_view text) {
        return obj::take_plain_number(text.data(), text.data() + text.size(), value) != nullptr;
    };
    for (const char* text : {"", "-", ".", "-.", "+1", "1e5", "nan", "inf", "1\t", "1\\", "1.2.3", "1234567890123456"})
        EXPECT_FALSE(is_plain(text)) << text;
    EXPECT_TRUE(is_plain("-0") && std::signbit(value));
    EXPECT_TRUE(is_plain(".5") && value == 0.5);
    EXPECT_TRUE(is_plain("5.") && value == 5);
    EXPECT_TRUE(is_plain("0.00000000000001") && value == 1e-14);
}

TEST(ObjNumbers, PlainCornersAreThoseOfParseFaceToken) {
    obj::FaceToken token;
    const auto take = [&](std::string_view text) {
        const char* const end = obj::take_plain_corner(text.data(), text.data() + text.size(), token);
        return end ? end - text.data() : -1;
    };
    EXPECT_EQ(take("12 3"), 2);
    EXPECT_TRUE(token.position == 12 && !token.texcoord && !token.normal);
    EXPECT_EQ(take("1/2/3"), 5);
    EXPECT_TRUE(token.position == 1 && token.texcoord == 2 && token.normal == 3);
    EXPECT_EQ(take("1//999999999 x"), 12);
    EXPECT_TRUE(token.position == 1 && !token.texcoord && token.normal == 999999999);
    EXPECT_EQ(take("7/"), 2);
    EXPECT_TRUE(token.position == 7 && !token.texcoord && !token.normal);
    for (const char* text :
         {"", "/1", "-1", "+1", "1/-2", "1/2/3/4", "1/2/3x", "1234567890", "1/1234567890", "1\t2", "1\\"})
        EXPECT_EQ(take(text), -1) << text;
}

}  // namespace
}  // namespace rakelight::io::obj
