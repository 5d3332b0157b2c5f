// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include <rakelight/picture_parts.h>
#include <rakelight/session.h>

namespace rakelight {
namespace {

PictureRequest small_request() {
    PictureRequest request;
    request.input = "builtin:teapot";
    request.settings.width = 64, request.settings.height = 48;
    return request;
}

/// The picture step by step, as a window makes it.
Frame frame_by_parts(const PictureRequest& request, Context& context) {
    Scene scene = with_requested_surfaces(load(request.input, request.load, context), request, context);
    const Camera camera = choose_camera(scene, request.view, 64.0 / 48.0, context);
    scene.lights = requested_lights(scene, request, camera);
    Session session;
    session.set(std::move(scene), request.prepare);
    Frame frame;
    session.render(camera, request.settings, frame, context);
    return frame;
}

TEST(PictureParts, LightsAreScaledAndCutAsRequested) {
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

TEST(PictureParts, MaterialsOfTheRequestAreInThePicture) {
    Context context;
    PictureRequest request = small_request();
    const Frame plain = frame_by_parts(request, context);
    request.materials.color = vec3{1, 0, 0};
    const Frame red = frame_by_parts(request, context);
    const std::size_t middle = 24 * 64 + 32;
    EXPECT_GT(plain.color[middle].y, 0.05f);
    EXPECT_LT(red.color[middle].y, 0.5f * plain.color[middle].y);
}

TEST(PictureParts, DepthOfAChannelGoesFromWhiteToDarkGray) {
    Context context;
    PictureRequest request = small_request();
    request.settings.channels = channel_depth;
    const Frame frame = frame_by_parts(request, context);
    const std::vector<std::uint32_t> codes = channel_codes(frame, channel_depth, {.depth_low = 0, .depth_high = 1000});
    ASSERT_EQ(codes.size(), 64u * 48u);
    EXPECT_EQ(codes[0], 0xff000000u);  // nothing is there
    EXPECT_GT(codes[24 * 64 + 32] & 255u, 250u);
    EXPECT_THROW(channel_codes(frame, channel_normal, {}), Error);
    EXPECT_THROW(channel_codes(frame, channel_depth | channel_normal, {}), Error);
}

TEST(PictureParts, WordsStandInTheOrderOfTheBits) {
    const std::vector<std::string> words = channel_words();
    for (std::size_t i = 0; i < words.size(); ++i) EXPECT_EQ(channels_by_name(words[i]), 1u << i);
}

}  // namespace
}  // namespace rakelight
