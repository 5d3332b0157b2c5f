// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/base/error.h>
#include <rakelight_internal/base/exit_code.h>

using namespace rakelight;

TEST(Error, ComposesFilePlaceReasonAndAdvice) {
    const Error e(ErrorCode::bad_file, "reads past the end", "accessor 7", "export it again");
    EXPECT_STREQ(e.with_file("a.glb").what(), "a.glb: accessor 7: reads past the end; export it again");
}

TEST(Error, KeepsTheFileThatIsAlreadyThere) {
    const Error e = Error(ErrorCode::failed, "x").with_file("inner.bin").with_file("outer.gltf");
    EXPECT_EQ(e.file(), "inner.bin");
}

TEST(Error, ExitCodesAreThoseOfTheManual) {
    EXPECT_EQ(exit_code(ErrorCode::failed), 1);
    EXPECT_EQ(exit_code(ErrorCode::usage), 2);
    EXPECT_EQ(exit_code(ErrorCode::not_found), 3);
    EXPECT_EQ(exit_code(ErrorCode::bad_file), 4);
    EXPECT_EQ(exit_code(ErrorCode::check_failed), 5);
}

TEST(OneLine, ReplacesControlCharactersAndKeepsUtf8) {
    EXPECT_EQ(one_line("a\nb\x1b[31m\x7f"), "a?b?[31m?");
    EXPECT_EQ(one_line("n\xC3\xA4me \xE2\x9D\xA4"), "n\xC3\xA4me \xE2\x9D\xA4");
    EXPECT_EQ(one_line("\xff\xC3"), "??");
    EXPECT_EQ(one_line("\xC2\x9B"), "??") << "C1 control sequence introducer";
    EXPECT_EQ(one_line("\xE2\x80\xAE"), "???") << "right-to-left override";
}

TEST(Error, TheWholeLineHasAtMostSixHundredBytes) {
    const std::string big(1000, 'x');
    const std::string text = Error(ErrorCode::failed, big, big, big).with_file(big).what();
    EXPECT_EQ(text.size(), 600u);
    EXPECT_EQ(text.substr(597), "...");
}

TEST(OneLine, ReplacesWhatIsNotUtf8OrTurnsTheDirectionOfWriting) {
    EXPECT_EQ(one_line("\xE0\x80\xAF"), "???") << "overlong";
    EXPECT_EQ(one_line("\xED\xA0\x80"), "???") << "surrogate";
    EXPECT_EQ(one_line("\xF0\x82\x82\xAC"), "????") << "overlong";
    EXPECT_EQ(one_line("\xF4\x90\x80\x80"), "????") << "beyond U+10FFFF";
    EXPECT_EQ(one_line("\xE2\x81\xA7"), "???") << "U+2067, right-to-left isolate";
    EXPECT_EQ(one_line("\xF0\x9F\x8E\xA8\xED\x95\x9C"), "\xF0\x9F\x8E\xA8\xED\x95\x9C")
        << "a picture and a Korean syllable";
}

TEST(OneLine, KeepsWhatFitsExactly) {
    EXPECT_EQ(one_line("12345678", 8), "12345678");
    EXPECT_EQ(one_line("123456789", 8), "12345...");
}

TEST(OneLine, CutsAtACharacterBorder) {
    const std::string cut = one_line(std::string(500, 'x'), 20);
    EXPECT_EQ(cut.size(), 20u);
    EXPECT_EQ(cut.substr(17), "...");
    EXPECT_LE(one_line("\xE2\x9D\xA4\xE2\x9D\xA4\xE2\x9D\xA4", 8).size(), 8u);
}
