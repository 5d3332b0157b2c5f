// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/document/keys.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>

#include "../../../apps/viewer/document/settings_file.h"
#include "../../../apps/viewer/view/pace.h"
#include "../../../apps/viewer/window/input.h"
#include "support/environment_variable.h"
#include "support/shared.h"
#include "support/temporary_folder.h"

namespace rakelight::viewer {
namespace {

TEST(Keys, NoKeyDoesTwoThings) {
    std::set<std::pair<Key, int>> seen;
    for (const Binding& b : bindings())
        EXPECT_TRUE(seen.emplace(b.key, b.modifiers).second) << b.key << " " << b.modifiers;
}

TEST(Keys, EveryCommandHasAKey) {
    std::set<Command> bound;
    for (const Binding& b : bindings()) bound.insert(b.command);
    for (int i = 1; i <= int(Command::leave); ++i) EXPECT_TRUE(bound.contains(Command(i))) << i;
}

TEST(Keys, FollowF3DWhereItHasThem) {
    EXPECT_EQ(command_of('1', 0), Command::front);
    EXPECT_EQ(command_of('3', 0), Command::right);
    EXPECT_EQ(command_of('7', 0), Command::top);
    EXPECT_EQ(command_of('9', 0), Command::isometric);
    EXPECT_EQ(command_of('5', 0), Command::orthographic);
    EXPECT_EQ(command_of('`', 0), Command::walk);
    EXPECT_EQ(command_of('/', mod_shift), Command::help);
    EXPECT_EQ(command_of(290 + 10, 0), Command::full_screen);
    EXPECT_EQ(command_of('Q', mod_control), Command::quit);
    EXPECT_EQ(command_of('Q', mod_control | mod_shift), Command::none);
}

TEST(Keys, TheKeypadDoesWhatTheDigitsDo) {
    EXPECT_EQ(command_of(320 + 7, 0), Command::top);
    EXPECT_EQ(command_of(320 + 1, mod_control), Command::back);
    EXPECT_EQ(command_of(330, 0), Command::fit);
}

TEST(Keys, TheTableForPeopleNamesEveryGroupOnce) {
    const std::string text = key_table_text();
    for (const char* group : {"| Files |", "| View |", "| Picture |", "| Marks |", "| Window |"}) {
        const std::size_t at = text.find(group);
        ASSERT_NE(at, std::string::npos) << group;
        EXPECT_EQ(text.find(group, at + 1), std::string::npos) << group;
    }
}

TEST(Keys, TheDocumentationHasTheTable) {
    std::ifstream file(test::source_dir() / "docs/viewer.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find(key_table_text()), std::string::npos) << "docs/viewer.md should hold:\n" << key_table_text();
}

TEST(Input, ButtonsDragAsInF3D) {
    EXPECT_EQ(drag_of(Button::left, 0), Drag::orbit);
    EXPECT_EQ(drag_of(Button::left, mod_shift), Drag::pan);
    EXPECT_EQ(drag_of(Button::left, mod_control), Drag::roll);
    EXPECT_EQ(drag_of(Button::middle, 0), Drag::pan);
    EXPECT_EQ(drag_of(Button::right, 0), Drag::zoom);
}

TEST(Keys, OfTheUsersOwnGoBeforeTheUsualOnes) {
    const std::vector<OwnKey> own = {*own_key("Ctrl+K", "Shift+C"), *own_key("S", "none"), *own_key("Page up", "F9")};
    EXPECT_EQ(command_of('K', mod_control, own), Command::previous_channel);
    EXPECT_EQ(command_of('S', 0, own), Command::none);
    EXPECT_EQ(command_of(266, 0, own), Command::record);
    EXPECT_EQ(command_of('Y', 0, own), Command::lighting);
    EXPECT_EQ(key_named("Alt+Ctrl++"), std::pair(int('+'), mod_control | mod_alt));
    for (const char* wrong : {"", "Ctrl+", "Hyper+S", "F13", "Nothing"}) EXPECT_FALSE(key_named(wrong)) << wrong;
    EXPECT_FALSE(own_key("K", "Ctrl+Alt+9")) << "does nothing";
    EXPECT_EQ(command_of(320 + 2, 0, std::vector{*own_key("2", "F9")}), Command::record);
    for (const char* shifted : {"?", "!", "~", "Shift+?"}) EXPECT_FALSE(key_named(shifted)) << shifted;
    const Remembered back = parse_settings("key Ctrl+K = Shift+C\r\nkey S = none \nkey Page up = F9");
    EXPECT_TRUE(back.own_keys == own);
    EXPECT_EQ(parse_settings("key = = S\n").own_keys.at(0).key, int('='));
    const Remembered wrong = parse_settings("key Ctrl+K = Hyper\nkey = S\nkey ? = S\n# key X = Y\n");
    EXPECT_TRUE(wrong.own_keys.empty());
    EXPECT_EQ(wrong.wrong_lines,
              (std::vector<std::string>{"line 1: key Ctrl+K = Hyper", "line 2: key = S", "line 3: key ? = S"}));
}

TEST(Input, BlendersMiddleButtonOrbits) {
    EXPECT_EQ(drag_of(Button::middle, 0, true), Drag::orbit);
    EXPECT_EQ(drag_of(Button::middle, mod_shift, true), Drag::pan);
    EXPECT_EQ(drag_of(Button::middle, mod_control, true), Drag::zoom);
    EXPECT_EQ(drag_of(Button::left, mod_shift, true), Drag::pan);
}

TEST(Input, KeysAreHeldUntilTheyAreReleased) {
    HeldKeys held;
    held.take({.kind = Event::Kind::key_down, .key = 'Z', .place = 'W'});  // as on French keyboards
    held.take({.kind = Event::Kind::key_down, .key = 'D', .place = 'D'});
    EXPECT_TRUE(held.has('W') && held.has('D') && !held.is_fast());
    held.take({.kind = Event::Kind::key_down, .place = key_right_shift});  // pressed last
    EXPECT_TRUE(held.is_fast());
    held.take({.kind = Event::Kind::key_up, .place = key_right_shift, .modifiers = mod_shift});
    held.take({.kind = Event::Kind::key_up, .key = 'Z', .place = 'W'});
    EXPECT_FALSE(held.has('W') || held.is_fast());
    held.clear();
    EXPECT_FALSE(held.has('D'));
}

TEST(Pace, SlowPixelsMakePicturesInMotionCoarse) {
    Pace pace;
    pace.measured(5, 400, 1e6);  // 35 ms are left for pixels of 400 ns
    const double scale = pace.scale(1e6, 40);
    EXPECT_NEAR(scale * scale * 400, 35, 1);
    Pace fast;
    fast.measured(1, 10, 1e6);
    EXPECT_EQ(fast.scale(1e6, 40), 1);
}

TEST(Pace, WhereVerticesTakeAllTheTimePixelsGetHalfAsMuch) {
    Pace pace;
    pace.measured(200, 1000, 1e6);
    const double scale = pace.scale(1e6, 40);
    EXPECT_NEAR(scale * scale * 1000, 100, 1);
}

TEST(Settings, AreReadAsTheyWereWritten) {
    Remembered r;
    r.ui.is_dark = false, r.ui.grid = true, r.ui.open[3] = true, r.ui.record_frames = 12;
    r.width = 900, r.height = 700;
    const Remembered back = parse_settings(settings_text(r));
    EXPECT_FALSE(back.ui.is_dark);
    EXPECT_TRUE(back.ui.grid && back.ui.open[3] && !back.ui.open[2]);
    EXPECT_EQ(back.ui.record_frames, 12);
    EXPECT_EQ(back.width, 900);
    EXPECT_EQ(back.height, 700);
}

TEST(Settings, LinesOfTheUsersOwnStay) {
    Remembered r;
    r.width = 900;
    const std::string text = settings_text(r, "# mine\nkey Ctrl+K = S\nwidth = 1\nwhatever\nwidth = 2");
    EXPECT_TRUE(text.starts_with("# mine\nkey Ctrl+K = S\nwidth = 900\nwhatever\n")) << text;
    EXPECT_EQ(text.find("width = 2"), text.npos);
    EXPECT_NE(text.find("height = 800\n"), text.npos);
    EXPECT_EQ(settings_text(r, text), text);
}

TEST(Settings, OnlyWhatCanBeReadIsWritten) {
    test::TemporaryFolder folder;
    const test::EnvironmentVariable config("XDG_CONFIG_HOME", folder.path().string());
    const std::filesystem::path path = settings_path();
    write_settings({});
    EXPECT_TRUE(std::filesystem::is_regular_file(path));
    std::filesystem::rename(path, folder.path() / "real.conf");
    std::filesystem::create_symlink(folder.path() / "real.conf", path);
    write_settings({.width = 901});
    EXPECT_TRUE(std::filesystem::is_symlink(path));
    EXPECT_EQ(read_settings().width, 901);
    std::ofstream(folder.path() / "real.conf") << std::string(70000, '#');
    write_settings({.width = 902});
    EXPECT_EQ(std::filesystem::file_size(path), 70000u);
}

TEST(Settings, NonsenseIsLeftOut) {
    const Remembered r = parse_settings("width = -5\nheight = 1e9\ndark = maybe\nx\n = \n");
    EXPECT_EQ(r.width, Remembered().width);
    EXPECT_EQ(r.height, Remembered().height);
    EXPECT_TRUE(r.ui.is_dark);
    EXPECT_EQ(r.wrong_lines.size(), 5u);
    EXPECT_TRUE(parse_settings(settings_text(r)).wrong_lines.empty());
}

}  // namespace
}  // namespace rakelight::viewer
