// SPDX-License-Identifier: Apache-2.0
#include <rakelight/render/picture.h>

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <fstream>

#include "math/color.h"
#include "render/output/picture_sink.h"
#include "unit/render/picture_fixture.h"
#include "unit/render/test_scene.h"

namespace rakelight {
namespace {

namespace fs = std::filesystem;

class Picture : public test::PictureFiles {
protected:
    std::size_t count_files() const {
        return std::size_t(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
    }
};

/// The pixel of the fake engine as an 8-bit file holds it.
std::array<std::uint8_t, 3> expected_pixel(int x, int y) {
    const vec4 c = test::FakeEngine::color_at(x, y);
    return {srgb8_from_linear(c.x), srgb8_from_linear(c.y), srgb8_from_linear(c.z)};
}

std::array<std::uint8_t, 3> pixel(const Pixels& p, int x, int y) {
    const auto* at = reinterpret_cast<const std::uint8_t*>(p.row(y)) + std::size_t(x) * std::size_t(p.channels);
    return {at[0], at[1], at[2]};
}

TEST_F(Picture, PngHoldsDisplayValuesOfEveryPixel) {
    const PictureResult result = draw({.output = file("a.png"), .settings = {.width = 130, .height = 70}});
    EXPECT_EQ(result.width, 130);
    const Pixels p = decode("a.png");
    ASSERT_EQ(p.channels, 3);
    ASSERT_EQ(p.width, 130);
    ASSERT_EQ(p.height, 70);
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 130; ++x) ASSERT_EQ(pixel(p, x, y), expected_pixel(x, y)) << x << ' ' << y;
    EXPECT_EQ(count_files(), 1u);
}

TEST_F(Picture, AWindowIsTheSamePixelsAsInTheWholePicture) {
    const PictureResult result =
        draw({.output = file("w.png"), .settings = {.width = 400, .height = 300, .window = {33, 71, 90, 65}}});
    EXPECT_EQ(result.width, 90);
    EXPECT_EQ(result.height, 65);
    const Pixels p = decode("w.png");
    ASSERT_EQ(p.width, 90);
    for (int y = 0; y < 65; ++y)
        for (int x = 0; x < 90; ++x) ASSERT_EQ(pixel(p, x, y), expected_pixel(33 + x, 71 + y));
}

TEST_F(Picture, AVeryLargePictureIsOnePassThatComesInStrips) {
    // 65536 wide: 64 MiB are 320 rows of three bytes a pixel
    const PictureResult result = draw({.output = file("b.png"), .settings = {.width = 65536, .height = 400}});
    EXPECT_EQ(engine_.windows, (std::vector<Window>{{0, 0, 65536, 400}}));
    EXPECT_EQ(engine_.strips, (std::vector<int>{320, 80}));
    EXPECT_EQ(result.stats.triangles_in, 7u);
    EXPECT_EQ(result.stats.pixels_covered, 65536u * 400u);
}

TEST_F(Picture, StripsJoinWithoutASeam) {
    draw({.output = file("s.png"), .settings = {.width = 32768, .height = 760, .window = {100, 30, 32000, 720}}});
    const Pixels p = decode("s.png");
    ASSERT_EQ(engine_.strips.size(), 2u);
    for (int y = 0; y < 720; ++y)
        for (int x = 0; x < 32000; x += 997)
            ASSERT_EQ(pixel(p, x, y), expected_pixel(100 + x, 30 + y)) << x << ' ' << y;
}

TEST_F(Picture, ATransparentBackgroundGivesAlphaAsTheFormatWantsIt) {
    PictureSink sink({Component::u8, 4});
    sink.begin(3, 1, {}, 0);
    const vec4 row[3] = {{0.25f, 0, 0, 0.5f}, {0, 0, 0, 0}, {1, 1, 1, 1}};
    sink.tile({.area = {0, 0, 3, 1}, .color = row});
    const auto* out = reinterpret_cast<const std::uint8_t*>(sink.color_row(0));
    EXPECT_EQ(out[0], srgb8_from_linear(0.25f));
    EXPECT_EQ(out[3], 128);
    EXPECT_EQ(out[7], 0);
    EXPECT_EQ(out[8], 255);
    EXPECT_EQ(out[11], 255);
    PictureSink linear({Component::f32, 4});
    linear.begin(3, 1, {}, 0);
    linear.tile({.area = {0, 0, 3, 1}, .color = row});
    EXPECT_EQ(reinterpret_cast<const float*>(linear.color_row(0))[0], 0.125f);
    draw({.output = file("t.png"), .settings = {.width = 8, .height = 8, .background = {0, 0, 0, 0}}});
    EXPECT_EQ(decode("t.png").channels, 4);
}

TEST_F(Picture, DisplayValuesOfFourBytesMayBeWrittenIntoThePictureItself) {
    PictureSink sink({Component::u8, 4});
    sink.begin(200, 150, {64, 10, 100, 90}, channel_depth);
    const DisplayRows rows = sink.display_rows({70, 12, 3, 2});
    ASSERT_NE(rows.first, nullptr);
    EXPECT_EQ(rows.stride, 100u);
    rows.first[1 * rows.stride + 2] = 0xff030201;  // pixel (72, 13)
    const float depth[6] = {1, 2, 3, 4, 5, 6};
    sink.display_tile({.area = {70, 12, 3, 2}, .depth = depth}, {});  // leaves the colors alone
    const std::byte* const pixel = sink.color_row(13 - 10) + std::ptrdiff_t(4 * (72 - 64));
    for (int c = 0; c < 3; ++c) EXPECT_EQ(std::to_integer<int>(pixel[c]), c + 1);
    EXPECT_EQ(std::bit_cast<float>(sink.channel_row(0, 3)[72 - 64]), 6.0f);
    EXPECT_EQ(PictureSink({Component::u8, 3}).display_rows({0, 0, 1, 1}).first, nullptr);
    EXPECT_EQ(PictureSink({Component::f32, 4}).display_rows({0, 0, 1, 1}).first, nullptr);
    EXPECT_EQ(PictureSink({Component::u8, 4}, ToneCurve({ToneMapping::agx, 0})).display_rows({0, 0, 1, 1}).first,
              nullptr);
}

TEST_F(Picture, ToneMappingActsOnDisplayValuesAndLeavesLinearFilesAlone) {
    const ToneSettings tone{ToneMapping::neutral, 1};
    const vec4 row[1] = {{0.2f, 0.9f, 3, 1}};
    const vec3 mapped = ToneCurve(tone)(row[0].xyz());
    PictureSink display({Component::u8, 3}, ToneCurve(tone));
    EXPECT_TRUE(PictureSink({Component::u8, 3}).wants_srgb8());
    EXPECT_FALSE(display.wants_srgb8());  // the engine's own codes know no curve
    display.begin(1, 1, {}, 0);
    display.tile({.area = {0, 0, 1, 1}, .color = row});
    const auto* codes = reinterpret_cast<const std::uint8_t*>(display.color_row(0));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(codes[c], srgb8_from_linear(mapped[c]));
    PictureSink linear({Component::f32, 3}, ToneCurve(tone));
    linear.begin(1, 1, {}, 0);
    linear.tile({.area = {0, 0, 1, 1}, .color = row});
    EXPECT_EQ(reinterpret_cast<const float*>(linear.color_row(0))[2], 3.0f);
    draw({.output = file("d.png"), .tone = {ToneMapping::none, -1}, .settings = {.width = 8, .height = 8}});
    const Pixels darker = decode("d.png");
    const vec4 full = test::FakeEngine::color_at(5, 6);
    EXPECT_EQ(std::to_integer<int>(darker.row(6)[3 * 5]), srgb8_from_linear(full.x / 2));
    EXPECT_THROW(check_request({.output = file("d.png"), .tone = {ToneMapping::agx, 99}}), Error);
}

TEST_F(Picture, PixelsThatAreNotNumbersBecomeBlackNotGarbage) {
    PictureSink sink({Component::u8, 4});
    sink.begin(1, 1, {}, 0);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const vec4 row[1] = {{nan, nan, nan, nan}};
    sink.tile({.area = {0, 0, 1, 1}, .color = row});
    const auto* out = reinterpret_cast<const std::uint8_t*>(sink.color_row(0));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(out[i], 0);
}

TEST_F(Picture, ChannelsGoToFilesBesideThePicture) {
    const std::uint32_t all = channel_depth | channel_normal | channel_object;
    const PictureResult result =
        draw({.output = file("c.v1.png"), .settings = {.width = 70, .height = 66, .channels = all}});
    EXPECT_EQ(result.channel_files,
              (std::vector<std::string>{file("c.v1.depth.exr"), file("c.v1.normal.exr"), file("c.v1.object.exr")}));
    EXPECT_EQ(count_files(), 4u);
    const Pixels depth = decode("c.v1.depth.exr");
    ASSERT_EQ(depth.component, Component::f32);
    ASSERT_EQ(depth.width, 70);
    const auto value = [](const Pixels& p, int x, int y) {
        return reinterpret_cast<const float*>(p.row(y))[std::size_t(x) * std::size_t(p.channels)];
    };
    EXPECT_EQ(value(depth, 69, 65), test::FakeEngine::depth_at(69, 65));
    const Pixels object = decode("c.v1.object.exr");
    EXPECT_EQ(value(object, 0, 12), -1.0f);
    EXPECT_EQ(value(object, 5, 12), 12.0f);
}

TEST_F(Picture, ExrHoldsLinearLight) {
    draw({.output = file("l.exr"), .settings = {.width = 64, .height = 2}});
    const Pixels p = decode("l.exr");
    ASSERT_EQ(p.component, Component::f32);
    EXPECT_FLOAT_EQ(reinterpret_cast<const float*>(p.row(1))[std::size_t(40) * std::size_t(p.channels)], 40 / 255.0f);
}

class FailingEngine final : public Engine {
public:
    std::string name() const override { return "failing"; }
    EngineCapabilities capabilities() const override { return {.channels = channels_all}; }
    void set_lights(std::vector<Light>) override {}
    void prepare(Scene scene, Context&) override { scene_ = std::move(scene); }
    const Scene& scene() const override { return scene_; }
    RenderStats render(const Camera&, const RenderSettings&, Sink&, Context&) override {
        throw Error(ErrorCode::failed, "cancelled");
    }

private:
    Scene scene_;
};

TEST_F(Picture, NothingIsLeftBehindWhenAnEngineFails) {
    Session failing = test::session_of_nothing<FailingEngine>();
    const PictureRequest request{.output = file("x.png"), .settings = {.channels = channel_depth}};
    {
        FileTarget target(request);
        PictureResult result;
        EXPECT_THROW(draw_shot(failing, {.settings = request.settings}, request, target, nullptr, result, context_),
                     Error);
    }
    EXPECT_EQ(count_files(), 0u);
}

TEST_F(Picture, ChannelFileNamesKeepTheFolder) {
    EXPECT_EQ(channel_file("out.d/a.png", "depth"), "out.d/a.depth.exr");
    EXPECT_EQ(channel_file("a", "depth"), "a.depth.exr");
}

ErrorCode refusal(const PictureRequest& request) {
    try {
        check_request(request);
    } catch (const Error& error) {
        return error.code();
    }
    ADD_FAILURE() << "accepted";
    return ErrorCode::check_failed;
}

TEST_F(Picture, RequestsAreCheckedBeforeAnythingIsLoaded) {
    const std::string good = file("a.png");
    check_request({.output = good});
    check_request({.output = file("a.EXR")});
    EXPECT_EQ(refusal({.output = file("a.txt")}), ErrorCode::usage);
    EXPECT_EQ(refusal({.output = file("png")}), ErrorCode::usage);
    EXPECT_EQ(refusal({.output = ""}), ErrorCode::usage);
    check_request({.output = file("no/such/folder/a.png")});  // folders are made when the picture is written
    EXPECT_FALSE(std::filesystem::exists(file("no")));
    std::ofstream(file("plain")) << "no folder";
    EXPECT_EQ(refusal({.output = file("plain/a.png")}), ErrorCode::failed);
    EXPECT_EQ(refusal({.output = good, .engine = "hard"}), ErrorCode::usage);
    EXPECT_EQ(refusal({.output = good, .settings = {.width = 0}}), ErrorCode::usage);
    EXPECT_EQ(refusal({.output = good, .settings = {.height = 65537}}), ErrorCode::usage);
    EXPECT_EQ(refusal({.output = good, .settings = {.window = {0, 0, 1281, 1}}}), ErrorCode::usage);
    EXPECT_EQ(refusal({.output = good, .settings = {.window = {1, 0, 2147483647, 1}}}), ErrorCode::usage);
    EXPECT_EQ(refusal({.output = file("a.jpg"), .settings = {.background = {0, 0, 0, 0}}}), ErrorCode::usage);
    fs::create_directory(folder_ / "folder.png");
    EXPECT_EQ(refusal({.output = file("folder.png")}), ErrorCode::failed);
}

TEST_F(Picture, TheWholeWayGivesDefaultLightsAndReportsABlankPicture) {
    auto blank = std::make_unique<test::FakeEngine>();
    blank->covered = false;
    Session session(std::move(blank));
    const PictureResult result = test::draw_picture(
        {.input = "builtin:teapot", .output = file("teapot.png"), .settings = {.width = 40, .height = 30}}, session,
        context_);
    EXPECT_GT(result.triangles, 1000u);
    EXPECT_EQ(result.objects, 6u);
    EXPECT_EQ(session.engine().scene().lights.size(), 3u);
    bool warned = false;
    for (const ReportEntry& r : context_.report().entries()) warned |= r.message.find("no pixel") != std::string::npos;
    EXPECT_TRUE(warned);
    EXPECT_TRUE(fs::exists(file("teapot.png")));
}

TEST_F(Picture, AskedForLightsReplaceAllOthers) {
    PictureRequest request{.input = "builtin:teapot", .output = file("lit.png"), .settings = {.width = 4, .height = 4}};
    request.lights = std::vector<Light>(2);
    test::draw_picture(request, session_, context_);
    EXPECT_EQ(engine_.prepared.lights.size(), 2u);
    request.lights = std::vector<Light>();
    test::draw_picture(request, session_, context_);
    EXPECT_TRUE(engine_.prepared.lights.empty());
}

TEST_F(Picture, AnUnknownBuiltinModelIsNotFound) {
    try {
        load("builtin:bunny", {}, context_);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::not_found);
    }
}

}  // namespace
}  // namespace rakelight
