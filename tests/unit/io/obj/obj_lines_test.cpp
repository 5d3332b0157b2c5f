// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/obj/obj_lines.h"

namespace rakelight::io::obj {
namespace {

struct Read {
    std::vector<Line> lines;
    std::vector<std::vector<Token>> words;
    bool saw_lone_cr = false;
};

Read read(std::string_view text) {
    Read result;
    LineReader reader(text);
    for (Line line; reader.next(line);) {
        result.lines.push_back(line);
        result.words.emplace_back();
        Tokens tokens = reader.arguments(line);
        for (Token t; tokens.next(t);) result.words.back().push_back(t);
    }
    result.saw_lone_cr = reader.saw_lone_cr();
    return result;
}

TEST(ObjLines, LinesTileTheFileWhateverTheirEnds) {
    const std::string text = "v 1 2 3\nvn 0 0 1\r\n\r\n# c\rf 1//1 2 \\\n 3\\\r\n4\no\\\n";
    const Read r = read(text);
    std::size_t at = 0;
    for (const Line& line : r.lines) {
        EXPECT_EQ(line.begin, at);
        EXPECT_LE(line.end, line.next);
        at = line.next;
    }
    EXPECT_EQ(at, text.size());
    ASSERT_EQ(r.lines.size(), 6u);
    EXPECT_EQ(r.lines[4].keyword.text, "f");
    EXPECT_EQ(r.lines[4].number, 5u);
    EXPECT_EQ(r.lines[5].number, 8u);
    EXPECT_TRUE(r.saw_lone_cr);
}

TEST(ObjLines, EachWordKnowsItsBytesInTheFile) {
    const std::string text = "# head\n  f\t1/2/3   4//5\\\n 6 # end\n";
    const Read r = read(text);
    ASSERT_EQ(r.lines.size(), 2u);
    EXPECT_EQ(text.substr(r.lines[1].keyword.begin, 1), "f");
    ASSERT_EQ(r.words[1].size(), 3u);
    const std::vector<std::string> expected{"1/2/3", "4//5", "6"};
    for (std::size_t i = 0; i < 3; ++i) {
        const Token& t = r.words[1][i];
        EXPECT_EQ(text.substr(t.begin, t.end() - t.begin), expected[i]);
        EXPECT_EQ(t.text, expected[i]);
    }
}

TEST(ObjLines, ACommentIsNeverJoinedToTheNextLine) {
    const Read r = read("# saved to C:\\models\\\nv 1 2 3\n");
    ASSERT_EQ(r.lines.size(), 2u);
    EXPECT_EQ(r.lines[1].keyword.text, "v");
}

TEST(ObjLines, EmptyFilesHaveNoLines) {
    EXPECT_TRUE(read("").lines.empty());
    EXPECT_TRUE(read("\xEF\xBB\xBF").lines.empty());
    EXPECT_EQ(read("\n").lines.size(), 1u);
}

TEST(ObjLines, AByteOrderMarkIsSkippedAndNulBytesAreBlanks) {
    const std::string text(
        "\xEF\xBB\xBFv 1 2 3\n\0\0v\0"
        "1 2 3",
        20);
    const Read r = read(text);
    ASSERT_EQ(r.lines.size(), 2u);
    EXPECT_EQ(r.lines[0].keyword.text, "v");
    EXPECT_EQ(r.lines[0].keyword.begin, 3u);
    EXPECT_EQ(r.lines[1].keyword.text, "v");
    EXPECT_EQ(r.words[1].size(), 3u);
}

TEST(ObjLines, ABackslashAtTheEndOfTheFileJoinsNothing) {
    for (const char* text : {"f 1 \\", "f 1 \\\n", "f 1\\\r\n"}) {
        const Read r = read(text);
        ASSERT_EQ(r.words.size(), 1u) << text;
        ASSERT_EQ(r.words[0].size(), 1u) << text;
        EXPECT_EQ(r.words[0][0].text, "1");
    }
}

TEST(ObjLines, NamesKeepInnerBlanksAndJoinLines) {
    const std::string text = "\t a  b, c \\\r\nd\t ";
    EXPECT_EQ(name_text(text, 0, text.size()), "a  b, c  d");
    EXPECT_EQ(name_text(text, 0, 0), "");
}

TEST(ObjLines, AMillionOldMacLinesAreReadInLinearTime) {
    // Would be 2 * 10^12 steps if each line searched the rest of the file for LF.
    std::string text;
    for (int i = 0; i < 1'000'000; ++i) text += "v\r";
    EXPECT_EQ(read(text).lines.size(), 1'000'000u);
}

}  // namespace
}  // namespace rakelight::io::obj
