// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/document/setting_text.h"

#include "../../../apps/viewer/document/shell_words.h"
#include "looks.h"

namespace rakelight::viewer {
namespace {

using Words = std::vector<std::string>;

TEST(ShellWords, AreThoseOfAShell) {
    EXPECT_EQ(shell_words("a  b\tc "), (Words{"a", "b", "c"}));
    EXPECT_EQ(shell_words(R"('left arm' "a \"b\" \ c" d\ e f'g h'i)"),
              (Words{"left arm", R"(a "b" \ c)", "d e", "fg hi"}));
    EXPECT_EQ(shell_words("'' \"\""), (Words{"", ""}));
    EXPECT_EQ(shell_words(" "), Words{});
    EXPECT_EQ(shell_words("a\\"), Words{"a\\"});
    EXPECT_THROW(shell_words("'left arm"), Error);
    EXPECT_THROW(shell_words("\"left\\\""), Error);
}

TEST(ShellWords, EveryWordComesBackFromItsQuotes) {
    for (const std::string& word :
         {std::string("plain"), std::string("two words"), std::string("it's"), std::string("\"\\"), std::string(),
          std::string("a\nb"), std::string("*"), std::string("\xC3\xA4 b")})
        EXPECT_EQ(shell_words(quoted(word) + " " + quoted(word)), (Words{word, word})) << word;
}

class SettingText : public Looks {};

TEST_F(SettingText, NamesWithBlanksAndQuotesAreSetAsTheyAreShown) {
    const auto of = model(write_model());
    Look look = first_look(*of);
    set_setting(look, "shading", "flat 'object:left arm=gouraud' material:Bob\\'s\\ red=flat");
    const std::vector<ShadingRule> rules = look.request.settings.shading_rules;
    ASSERT_EQ(rules.size(), 2u);
    EXPECT_EQ(rules[0].name, "left arm");
    EXPECT_EQ(rules[1].name, "Bob's red");
    const std::string shown = setting_text(look.request, "shading");
    set_setting(look, "shading", "");
    EXPECT_TRUE(look.request.settings.shading_rules.empty());
    set_setting(look, "shading", shown);
    EXPECT_EQ(look.request.settings.shading_rules, rules);
    const Look before = look;
    EXPECT_THROW(set_setting(look, "shading", "'object:left arm=flat"), Error);
    EXPECT_TRUE(look == before);
    set_setting(look, "fog", "none");  // another setting leaves them
    EXPECT_EQ(look.request.settings.shading_rules, rules);
}

TEST_F(SettingText, AFileNameIsOneWord) {
    const auto of = model(write_model());
    Look look = first_look(*of);
    set_setting(look, "hdri-file", "a sky's picture.hdr");
    EXPECT_EQ(look.request.hdri_file, "a sky's picture.hdr");
    EXPECT_EQ(setting_text(look.request, "hdri-file"), "a sky's picture.hdr");
}

TEST_F(SettingText, EngineAndMethodAreChosenAsByTheirKeys) {
    const auto of = model(write_model());
    Look look = first_look(*of);
    look.request.settings.samples = 4;
    const Look before = look;
    set_setting(look, "engine", "trace");
    EXPECT_TRUE(look.request.settings.shadows);
    set_setting(look, "method", "path");
    EXPECT_EQ(look.request.settings.samples, 256);
    set_setting(look, "method", "");
    EXPECT_EQ(look.request.settings.samples, 4);
    set_setting(look, "engine", "");
    EXPECT_TRUE(look == before);
    EXPECT_THROW(set_setting(look, "engine", "none"), Error);
}

}  // namespace
}  // namespace rakelight::viewer
