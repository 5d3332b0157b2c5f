// SPDX-License-Identifier: Apache-2.0
// The command line as tables: every setting is an option once, and what people write is read or refused in one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../../../apps/common/command_line.h"
#include "../../../apps/common/manual.h"
#include "../../../apps/common/picture_options.h"
#include "support/thrown_error.h"

#include <rakelight/world/render_keys.h>

namespace rakelight::apps {
namespace {

using test::error_of;

std::vector<Command> commands() {
    const Option output = {
        .name = "output", .group = "Output", .type = "FILE", .help = "Where", .is_required = true, .letter = 'o'};
    return {{"draw",
             "Draws",
             "Behind the options.",
             {{"MODEL", "Models"}},
             joined({{output}, picture_options(), common_options()})},
            {"weigh", "Weighs", nullptr, {{"WHAT", "What", true, false}, {"WHERE", "Where", false, false}}, {}}};
}

CommandLine read(const std::vector<const char*>& words) {
    static const std::vector<Command> all = commands();
    return read_command_line({"tool", "A tool.", "Examples", all}, {words.begin(), words.end()});
}

std::string refused(std::vector<const char*> words) {
    return error_of([&] { read(words); }).what();
}

TEST(PictureOptions, EveryKeyOfRenderIsAnOptionOnceWithHelp) {
    std::multiset<std::string_view> names;
    for (const Option& option : picture_options()) {
        names.insert(option.name);
        EXPECT_TRUE(option.is_setting) << option.name;
        EXPECT_GT(std::string_view(option.help).size(), 8u) << option.name;
        ASSERT_NE(find_render_key(option.name), nullptr) << option.name;
    }
    for (const RenderKey& key : render_keys()) EXPECT_EQ(names.count(key.name), 1u) << key.name;
    EXPECT_EQ(names.size(), render_keys().size());
}

TEST(CommandLine, SettingsAndOtherOptionsAreKeptApart) {
    const CommandLine line = read({"draw", "a.glb", "--samples=4", "b.glb", "-o", "out.png", "--json", "--light",
                                   "ambient:1,1,1", "--edges", "--light=point:0,0,0"});
    EXPECT_EQ(line.command, 0u);
    EXPECT_EQ(line.positionals, (std::vector<std::string>{"a.glb", "b.glb"}));
    EXPECT_EQ(line.given.word("output"), "out.png");
    EXPECT_TRUE(line.given.has("json"));
    EXPECT_FALSE(line.given.has("quiet"));
    EXPECT_EQ(line.given.words("light"), (std::vector<std::string>{"ambient:1,1,1", "point:0,0,0"}));
    std::set<std::string> settings;
    for (const WorldValue& value : line.given.settings()) settings.insert(value.key);
    EXPECT_EQ(settings, (std::set<std::string>{"samples", "light", "edges"}));
    EXPECT_EQ(line.given.first_of({"view", "samples"}), "samples");
    EXPECT_EQ(line.given.first_of({"view"}), "");
}

TEST(CommandLine, ASwitchStandsAloneOrWithOnOrOffBehindIt) {
    const auto shadows = [](std::vector<const char*> words) {
        words.insert(words.begin(), {"draw", "-o", "x.png"});
        const CommandLine line = read(words);
        return line.given.word("shadows") + " " + std::to_string(line.positionals.size());
    };
    EXPECT_EQ(shadows({"--shadows", "a.glb"}), "on 1");
    EXPECT_EQ(shadows({"--shadows", "off", "a.glb"}), "off 1");
    EXPECT_EQ(shadows({"a.glb", "--shadows=on"}), "on 1");
    EXPECT_EQ(refused({"draw", "-o", "x", "a.glb", "--shadows", "maybe"}),
              "--shadows: unknown word 'maybe'; use one of: on, off");
}

TEST(CommandLine, SinglePositionalsComeInTheirOrder) {
    EXPECT_EQ(read({"weigh", "gold", "here"}).positionals, (std::vector<std::string>{"gold", "here"}));
    EXPECT_EQ(read({"weigh", "gold"}).positionals, (std::vector<std::string>{"gold"}));
}

TEST(CommandLine, MistakesAreSaidInOneLine) {
    EXPECT_EQ(refused({"drow"}), "unknown command 'drow'; did you mean draw? see tool --help");
    EXPECT_EQ(refused({"draw", "a", "-o", "b", "--samples"}).find('\n'), std::string::npos);
    EXPECT_EQ(refused({"draw", "a", "-o", "b", "--sampels", "4"}),
              "unknown option '--sampels'; did you mean --samples? see tool draw --help");
    EXPECT_EQ(refused({"draw", "a", "-o", "b", "--samples=4", "--samples=8"}),
              "--samples is given more than once; see tool draw --help");
    EXPECT_EQ(refused({"draw", "a", "-o", "b", "--json=5"}), "--json: must be on or off, not '5'");
    EXPECT_EQ(refused({"draw", "a", "-o", "b", "--view", ""}), "--view: the value is empty");
    EXPECT_EQ(refused({"draw", "a", "-o", "b", "--view="}), "--view=: the value is empty");
    EXPECT_EQ(refused({"draw", "", "-o", "b"}), "the name of a model is empty");
    EXPECT_EQ(refused({"draw", "-o", "b", "-a.glb"}), "'-a.glb' looks like an option; for a file write ./-a.glb");
    EXPECT_NE(refused({"draw", "a"}), "");
    EXPECT_EQ(refused({"help", "draw", "weigh"}), "help takes one command; see tool --help");
}

TEST(CommandLine, HelpIsOfTheProgramOrOfACommand) {
    EXPECT_NE(read({"--help"}).help.find("weigh"), std::string::npos);
    EXPECT_EQ(read({"help", "draw"}).help, read({"draw", "--help"}).help);
    EXPECT_NE(read({"draw", "--help"}).help.find("--crease-angle DEG"), std::string::npos);
    EXPECT_NE(read({"draw", "--help"}).help.find("Behind the options."), std::string::npos);
    EXPECT_TRUE(read({"--version"}).is_version);
    for (const std::string& text : {read({"--help"}).help, read({"draw", "--help"}).help})
        for (std::size_t first = 0; first < text.size();) {
            const std::size_t end = std::min(text.find('\n', first), text.size());
            EXPECT_LE(end - first, 110u) << text.substr(first, end - first);
            first = end + 1;
        }
}

TEST(CommandLine, AHiddenOptionIsKnownButNotShown) {
    std::vector<Option> options = picture_options();
    hide_drawn_lines(options);
    const std::vector<Command> all = {{"look", "Looks", nullptr, {{"MODEL", "Models"}}, options}};
    const Program program{"tool", "", "", all};
    EXPECT_EQ(read_command_line(program, {"look", "--help"}).help.find("--wireframe"), std::string::npos);
    EXPECT_TRUE(read_command_line(program, {"look", "a", "--wireframe"}).given.has("wireframe"));
}

TEST(CommandLine, FlagsAndSwitchesTakeWordsForOnAndOff) {
    for (const char* const on : {"on", "TRUE", "1"})
        EXPECT_TRUE(read({"draw", "a", "-o", "b", "--json", on}).given.has("json")) << on;
    for (const char* const off : {"--json=off", "--json=False", "--json=0"})
        EXPECT_FALSE(read({"draw", "a", "-o", "b", off}).given.has("json")) << off;
    EXPECT_EQ(read({"draw", "--edges", "0", "a", "-o", "b"}).positionals, std::vector<std::string>{"a"});
    EXPECT_EQ(read({"draw", "--json", "off", "a", "--json", "-o", "b"}).given.has("json"), true);
}

TEST(CommandLine, WordsOfOtherProgramsAreAnsweredByOurs) {
    EXPECT_EQ(refused({"draw", "a", "-o", "b", "--fov", "3"}), "--fov: unknown; see --camera-view-angle");
    EXPECT_EQ(refused({"draw", "a", "-o", "b", "--size=3,4"}), "--size: unknown; see --resolution");
    EXPECT_EQ(refused({"weigh", "a", "--fov", "3"}),
              "unknown option '--fov'; see tool weigh --help");  // it has no such thing
}

TEST(CommandLine, AnOptionMayHaveTwoNames) {
    const CommandLine line = read({"draw", "a", "-o", "b", "--background-color", "red"});
    EXPECT_EQ(line.given.word("background"), "red");
    EXPECT_EQ(refused({"draw", "a", "-o", "b", "--background-color=red", "--background=red"}),
              "--background is given more than once; see tool draw --help");
}

TEST(Manual, HasEveryCommandAndOptionThatIsNotHidden) {
    std::vector<Command> all = commands();
    all[0].options[1].is_hidden = true;
    const Program program{"tool", "A tool.", "Footer with \\ and\n.lines", all};
    for (const std::string& page : {man_page(program), markdown_page(program)}) {
        EXPECT_NE(page.find("weigh"), page.npos);
        EXPECT_EQ(page.find("Size of the picture in pixels"), page.npos);
        EXPECT_NE(page.find("Worker threads"), page.npos);
    }
    EXPECT_NE(man_page(program).find("Footer with \\e and\n\\&.lines"), std::string::npos);
    EXPECT_EQ(manual_for(program, {"--man"}), man_page(program));
    EXPECT_EQ(manual_for(program, {"draw", "--man"}), "");
}

TEST(OptionLists, WithoutLeavesTheOthersInTheirOrder) {
    const std::vector<Option> all = picture_options(), fewer = without(all, {"view", "near"});
    EXPECT_EQ(fewer.size() + 2, all.size());
    EXPECT_EQ(find_or_null(fewer, "view"), nullptr);
    EXPECT_NE(find_or_null(fewer, "far"), nullptr);
}

}  // namespace
}  // namespace rakelight::apps
