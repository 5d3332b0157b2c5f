// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include <rakelight/picture.h>
#include <rakelight/session.h>
#include <rakelight/shot.h>

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

TEST(Shots, WordsStandInTheOrderOfTheBits) {
    const std::vector<std::string> words = channel_words();
    for (std::size_t i = 0; i < words.size(); ++i) EXPECT_EQ(channels_by_name(words[i]), 1u << i);
}

}  // namespace
}  // namespace rakelight
