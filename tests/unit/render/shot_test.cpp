// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include <rakelight/render/picture.h>
#include <rakelight/render/session.h>
#include <rakelight/render/shot.h>

#include "support/thrown_error.h"

namespace rakelight {
namespace {

PictureRequest small_request() {
    PictureRequest request;
    request.input = "builtin:teapot";
    request.settings.width = 64, request.settings.height = 48;
    return request;
}

/// The picture of a session.
Frame frame_of(const PictureRequest& request, Context& context) {
    const auto loaded = std::make_shared<const Scene>(load(request.input, request.load, context));
    PictureRequest decided = request;
    Session session;
    Frame frame;
    session.render(decide(session, loaded, decided, {}, {}, {}, context), frame, context);
    return frame;
}

TEST(Shots, LightsAreScaledAndCutAsRequested) {
    Context context;
    PictureRequest request = small_request();
    Light lamp;
    lamp.quadratic = 1;
    request.lights = std::vector<Light>{lamp};
    request.light_intensity = 3;
    request.light_cutoff = 0.01;
    const std::vector<Light> lights = requested_lights({}, request, {});
    ASSERT_EQ(lights.size(), 1u);
    EXPECT_EQ(lights[0].diffuse, (vec3{3, 3, 3}));
    EXPECT_NEAR(lights[0].range, std::sqrt(300), 1);  // 3 / d^2 = 0.01
}

TEST(Shots, MaterialsOfTheRequestAreInThePicture) {
    Context context;
    PictureRequest request = small_request();
    const Frame plain = frame_of(request, context);
    request.materials.color = vec3{1, 0, 0};
    const Frame red = frame_of(request, context);
    const std::size_t middle = 24 * 64 + 32;
    EXPECT_GT(plain.color[middle].y, 0.05f);
    EXPECT_LT(red.color[middle].y, 0.5f * plain.color[middle].y);
}

TEST(Shots, DepthOfAChannelGoesFromWhiteToDarkGray) {
    Context context;
    PictureRequest request = small_request();
    request.settings.channels = channel_depth;
    const Frame frame = frame_of(request, context);
    const std::vector<std::uint32_t> codes = channel_codes(frame, channel_depth, {.depth_low = 0, .depth_high = 1000});
    ASSERT_EQ(codes.size(), 64u * 48u);
    EXPECT_EQ(codes[0], 0xff000000u);  // nothing is there
    EXPECT_GT(codes[24 * 64 + 32] & 255u, 250u);
    EXPECT_THROW(channel_codes(frame, channel_normal, {}), Error);
    EXPECT_THROW(channel_codes(frame, channel_depth | channel_normal, {}), Error);
}

TEST(Shots, ADecisionWantsAScene) {
    Context context;
    PictureRequest request = small_request();
    Session session;
    const Error error = test::error_of([&] { decide(session, nullptr, request, {}, {}, {}, context); });
    EXPECT_EQ(error.code(), ErrorCode::usage);
    EXPECT_EQ(error.reason(), "there is no scene to draw");
}

TEST(Shots, TheCallerMayChooseTheCamera) {
    Context context;
    PictureRequest request = small_request();
    const auto loaded = std::make_shared<const Scene>(load(request.input, request.load, context));
    Session session;
    Camera chosen;
    chosen.to_world = translation(dvec3{1, 2, 30});
    const Scene* seen = nullptr;
    const auto camera = [&](const Scene& scene) {
        seen = &scene;
        return chosen;
    };
    const Shot shot = decide(session, loaded, request, {}, camera, {}, context);
    EXPECT_EQ(shot.camera, chosen);
    ASSERT_NE(seen, nullptr);
    EXPECT_EQ(seen, &session.show(loaded, request, {}, context)) << "the scene that the session shows";
}

TEST(Shots, DisplayValuesKeepTheColorOfTheBackground) {
    Context context;
    PictureRequest request = small_request();
    request.look = Look::plain;
    request.tone.exposure_ev = 2;
    request.settings.background = {0.25f, 0.5f, 1, 1};
    const Shot shown = plan_shot({}, request, {}, {}, context);
    EXPECT_EQ(shown.behind, request.settings.background);
    EXPECT_FALSE(shown.settings.composites_background);
    const Shot linear = plan_shot({}, request, {}, {.is_linear = true}, context);
    EXPECT_EQ(linear.behind, vec4{});
    EXPECT_TRUE(linear.settings.composites_background);
}

TEST(Shots, TheSmallPictureMayBeLeftOut) {
    Context context;
    const auto background_by = [&](const ShotOptions& options) {
        PictureRequest request = small_request();
        request.look = Look::standard;
        request.materials.color = vec3{0.1f, 0.1f, 0.1f};
        const auto loaded = std::make_shared<const Scene>(load(request.input, request.load, context));
        Session session;
        const Shot shot = decide(session, loaded, request, {}, {}, options, context);
        EXPECT_EQ(shot.settings.background, request.settings.background);
        return request.settings.background;
    };
    const vec4 given = small_request().settings.background;
    EXPECT_EQ(background_by({.without_adjusting = true}), given);
    EXPECT_NE(background_by({}), given) << "what is seen of it asks for a light one";
}

TEST(Shots, PixelsOfACancelledPictureAreKeptOnRequest) {
    for (const bool keeps : {true, false}) {
        Context* running = nullptr;
        Context context({.threads = 1, .progress = [&](std::string_view stage, double done) {
                             if (stage == "render" && done > 0.3) running->cancel();
                         }});
        running = &context;
        PictureRequest request = small_request();
        request.look = Look::plain;
        request.settings.height = 480;
        request.keep_partial = keeps;
        Pixels pixels;
        if (!keeps) {
            EXPECT_EQ(test::error_of([&] { render_picture(request, pixels, context); }).code(), ErrorCode::failed);
            continue;
        }
        const PictureResult result = render_picture(request, pixels, context);
        EXPECT_GT(result.done, 0);
        EXPECT_LT(result.done, 1);
        EXPECT_EQ(pixels.bytes.size(), std::size_t(64 * 480 * pixels.channels));
    }
}

TEST(Shots, WordsStandInTheOrderOfTheBits) {
    const std::vector<std::string> words = channel_words();
    for (std::size_t i = 0; i < words.size(); ++i) EXPECT_EQ(channels_by_name(words[i]), 1u << i);
}

}  // namespace
}  // namespace rakelight
