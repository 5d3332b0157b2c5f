// SPDX-License-Identifier: Apache-2.0
// Data channels in files: which files, which numbers in them, which colors for the eye.
#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <fstream>

#include "image/false_color.h"
#include "render/channel_view.h"
#include "unit/render/picture_fixture.h"

namespace rakelight {
namespace {

namespace fs = std::filesystem;

class ChannelsInFiles : public test::PictureFiles {
protected:
    std::string text(const std::string& name) {
        std::ifstream stream(file(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    PictureResult draw(const PictureRequest& request) {
        PictureResult result;
        result.channel_range = {.depth_low = 0, .depth_high = 100, .low = {0, 0, 0}, .high = {1, 1, 1}};
        return PictureFiles::draw(request, result);
    }
};

/// "normal.X", the type as the file's list of channels holds it: 0 UINT, 1 HALF, 2 FLOAT.
bool lists(const std::string& exr, const std::string& name, char type) {
    return exr.find(name + std::string(1, '\0') + std::string(1, type) + std::string(3, '\0')) != std::string::npos;
}

constexpr std::uint32_t three = channel_depth | channel_normal | channel_object;

TEST_F(ChannelsInFiles, LayersStandBesideTheColorOfAnExr) {
    const PictureResult result = draw({.output = file("a.exr"),
                                       .settings = {.width = 70, .height = 66, .channels = three},
                                       .channel_files = channel_files_layers});
    EXPECT_TRUE(result.channel_files.empty());
    const std::string exr = text("a.exr");
    for (const char* name : {"R", "G", "B", "depth.Z", "normal.X", "normal.Y", "normal.Z"})
        EXPECT_TRUE(lists(exr, name, 2)) << name;
    EXPECT_TRUE(lists(exr, "object.I", 0));
    const Pixels p = decode("a.exr");
    ASSERT_EQ(p.channels, 3);
    EXPECT_EQ(reinterpret_cast<const float*>(p.row(65))[3 * 69], test::FakeEngine::color_at(69, 65).x);
}

TEST_F(ChannelsInFiles, LayersOfAPictureThatIsNoExrGoToOneWithLinearColor) {
    const PictureResult result = draw({.output = file("a.png"),
                                       .settings = {.width = 20, .height = 10, .channels = three},
                                       .channel_files = channel_files_layers});
    EXPECT_EQ(result.channel_files, std::vector<std::string>{file("a.channels.exr")});
    const Pixels p = decode("a.channels.exr");
    EXPECT_EQ(reinterpret_cast<const float*>(p.row(7))[3 * 13], test::FakeEngine::color_at(13, 7).x);
    EXPECT_TRUE(lists(text("a.channels.exr"), "object.I", 0));
}

TEST_F(ChannelsInFiles, HalvesAreForColorsAlone) {
    draw({.output = file("a.exr"),
          .settings = {.width = 20, .height = 10, .channels = three | channel_depth},
          .channel_files = channel_files_layers,
          .half_colors = true});
    const std::string exr = text("a.exr");
    EXPECT_TRUE(lists(exr, "R", 1));
    EXPECT_TRUE(lists(exr, "depth.Z", 2));
    const Pixels p = decode("a.exr");
    EXPECT_NEAR(reinterpret_cast<const float*>(p.row(7))[3 * 13], test::FakeEngine::color_at(13, 7).x, 1e-4f);
}

TEST_F(ChannelsInFiles, EveryWayOfWritingThemGoesTogether) {
    const PictureResult result =
        draw({.output = file("a.png"),
              .settings = {.width = 20, .height = 10, .channels = channel_depth | channel_object},
              .channel_files = channel_files_exr | channel_files_layers | channel_files_png});
    EXPECT_EQ(result.channel_files,
              (std::vector<std::string>{file("a.depth.exr"), file("a.object.exr"), file("a.channels.exr"),
                                        file("a.depth.png"), file("a.object.png")}));
    const Pixels p = decode("a.object.png");
    const auto* at = reinterpret_cast<const std::uint8_t*>(p.row(3));
    EXPECT_EQ((Code{at[0], at[1], at[2]}), Code{});
    EXPECT_EQ((Code{at[3], at[4], at[5]}), color_of_number(3));
}

TEST_F(ChannelsInFiles, AlphaIsMultipliedInOnceInExr) {
    Frame frame;
    frame.begin(1, 1, {}, 0);
    frame.color[0] = {0.5f, 0.25f, 1, 0.5f};
    save(frame, file("a.exr"));
    const Pixels p = decode("a.exr");
    ASSERT_EQ(p.channels, 4);
    EXPECT_EQ(reinterpret_cast<const float*>(p.row(0))[0], 0.5f);
    EXPECT_EQ(reinterpret_cast<const float*>(p.row(0))[3], 0.5f);
}

/// One pixel of a channel as PNG files show it.
template <class... Values>
Code shown(std::uint32_t channel, Values... values) {
    const std::uint32_t words[] = {std::bit_cast<std::uint32_t>(values)...};
    const ChannelRange range{.depth_low = 2, .depth_high = 4, .low = {-1, 0, 0}, .high = {1, 2, 0}};
    Code c;
    view_row(info_of(channel), range, words, 1, &c.r);
    return c;
}

TEST(ChannelView, DirectionsAreShiftedIntoColors) {
    EXPECT_EQ(shown(channel_normal, 1.0f, 0.0f, -1.0f), (Code{255, 128, 0}));
    EXPECT_EQ(shown(channel_tangent, 0.0f, 1.0f, 0.0f, -1.0f), (Code{128, 255, 128}));
    EXPECT_EQ(shown(channel_normal, 0.0f, 0.0f, 0.0f), Code{});
}

TEST(ChannelView, DepthGoesFromWhiteToDarkGray) {
    EXPECT_EQ(shown(channel_depth, 2.0f), (Code{255, 255, 255}));
    EXPECT_EQ(shown(channel_depth, 4.0f), (Code{32, 32, 32}));
    EXPECT_EQ(shown(channel_depth, 9.0f), (Code{32, 32, 32}));
    EXPECT_EQ(shown(channel_depth, std::numeric_limits<float>::infinity()), Code{});
}

TEST(ChannelView, PositionsSpanTheBoxAndAFlatBoxIsInTheMiddle) {
    EXPECT_EQ(shown(channel_position, 1.0f, 1.0f, 0.0f), (Code{255, 128, 128}));
}

TEST(ChannelView, CoordinatesWrap) {
    EXPECT_EQ(shown(channel_uv, 1.0f, 0.0f), (Code{255, 0, 0}));
    EXPECT_EQ(shown(channel_uv, 3.5f, -0.75f), (Code{128, 64, 0}));
}

TEST(ChannelView, OverdrawDoublesStepByStep) {
    EXPECT_EQ(shown(channel_overdraw, 0u), Code{});
    EXPECT_EQ(shown(channel_overdraw, 1u), heat(0));
    EXPECT_EQ(shown(channel_overdraw, 3u), heat(0.375));
    EXPECT_EQ(shown(channel_overdraw, 4u), heat(0.5));
    EXPECT_EQ(shown(channel_overdraw, 4000000000u), heat(1));
}

TEST(ChannelView, NumbersAreColorsAndNothingIsBlack) {
    EXPECT_EQ(shown(channel_triangle, 5u), color_of_number(5));
    EXPECT_EQ(shown(channel_object, no_index), Code{});
    EXPECT_EQ(shown(channel_barycentric, 0.25f, 0.75f, 0.0f), (Code{64, 191, 0}));
    EXPECT_EQ(shown(channel_diffuse, 1.0f, 0.5f, 0.0f), (Code{255, 188, 0}));
}

TEST(ChannelNames, WordsAndGroupsAreUnderstood) {
    EXPECT_EQ(channels_by_name("face-normal"), channel_face_normal);
    EXPECT_EQ(channels_by_name("lighting"), channels_lighting);
    EXPECT_EQ(channels_by_name("all"), channels_all);
    EXPECT_THROW(channels_by_name("smell"), Error);
    EXPECT_THROW(channels_by_name(""), Error);
}

}  // namespace
}  // namespace rakelight
