// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "support/thrown_error.h"
#include "unit/render/fake_engine.h"

namespace rakelight {
namespace {

TEST(Frame, KeepsEveryPixelAndChannelOfAWindow) {
    test::FakeEngine engine;
    Context context({.threads = 3});
    RenderSettings settings{
        .width = 300, .height = 200, .window = {17, 5, 130, 91}, .channels = channel_depth | channel_object};
    Frame frame;
    engine.render({}, settings, frame, context);
    ASSERT_EQ(frame.color.size(), 130u * 91u);
    ASSERT_EQ(frame.depth.size(), 130u * 91u);
    EXPECT_TRUE(frame.normal.empty());
    EXPECT_EQ(frame.width, 300);
    for (int y = 5; y < 96; ++y)
        for (int x = 17; x < 147; ++x) {
            const std::size_t at = std::size_t(y - 5) * 130 + std::size_t(x - 17);
            ASSERT_EQ(frame.color[at], test::FakeEngine::color_at(x, y)) << x << ' ' << y;
            ASSERT_EQ(frame.depth[at], test::FakeEngine::depth_at(x, y));
            ASSERT_EQ(frame.object[at], std::uint32_t(y));
        }
}

TEST(Frame, AnEmptyWindowMeansTheWholePicture) {
    Frame frame;
    frame.begin(4, 3, {}, channel_depth | channel_normal | channel_material);
    EXPECT_EQ(frame.window, (Window{0, 0, 4, 3}));
    EXPECT_EQ(frame.color.size(), 12u);
    EXPECT_TRUE(std::isinf(frame.depth[11]));
    EXPECT_EQ(frame.normal[0], (vec3{0, 0, 0}));
    EXPECT_EQ(frame.material[5], no_index);
    EXPECT_TRUE(frame.object.empty());
}

TEST(Frame, BeginsAnewForASmallerPicture) {
    Frame frame;
    frame.begin(8, 8, {}, channel_depth);
    frame.begin(1, 1, {}, 0);
    EXPECT_EQ(frame.color.size(), 1u);
    EXPECT_TRUE(frame.depth.empty());
}

TEST(Frame, OneThatNoMachineCanHoldIsRefusedInOneLine) {
    Frame frame;
    const Error error = test::error_of([&] { frame.begin(1 << 30, 1 << 20, {}, channel_depth); });
    EXPECT_EQ(error.code(), ErrorCode::failed);
    EXPECT_EQ(error.reason(), "a frame of 1073741824 x 1048576 pixels needs 21474836480 MiB, more than available");
    EXPECT_EQ(test::error_of([&] { frame.begin(1 << 30, 1 << 30, {}, 0); }).code(), ErrorCode::failed);
    frame.begin(1 << 30, 1 << 20, {5, 5, 2, 2}, 0);  // of a small window all is well
    EXPECT_EQ(frame.color.size(), 4u);
}

}  // namespace
}  // namespace rakelight
