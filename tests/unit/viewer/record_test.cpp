// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/motion/record.h"

#include <rakelight/io/image_sources.h>

#include "looks.h"

namespace rakelight::viewer {
namespace {

class Record : public Looks {
protected:
    Look lit_from_the_camera(const Model& m) {
        Look look = first_look(m);
        changing_lights(look, m, width, height) = {{.light = {.position = {1, 2, 5}}, .follows_camera = true}};
        return look;
    }
    int files() {
        int count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) count += entry.is_regular_file();
        return count;
    }
    const std::string folder = folder_.file("turn");
};

TEST_F(Record, LightsThatFollowTheCameraGoAroundWithIt) {
    const auto m = model(write_model());
    const Look look = lit_from_the_camera(*m);
    const Look half = turned(look, *m, width, height, pi);
    const dvec3 center = seen_eye(look, *m, width, height).focal, before = (*look.lights)[0].light.position;
    const dvec3 after = (*half.lights)[0].light.position;
    EXPECT_NEAR(after.x, 2 * center.x - before.x, 1e-9);
    EXPECT_NEAR(after.y, before.y, 1e-9);
    EXPECT_NEAR(after.z, 2 * center.z - before.z, 1e-9);
}

TEST_F(Record, ItsPicturesAreThoseOfTurnedLooks) {
    const auto m = model(write_model());
    const Look look = lit_from_the_camera(*m);
    const Turn turn = record_turn(m, look, width, height, 4, folder, context_);
    EXPECT_EQ(turn.written, 4);
    EXPECT_EQ(files(), 4);
    const ImageHandle image = image_from_file(folder + "/0002.png");
    const Pixels pixels = image->decode(*image, context_);
    const std::vector<std::uint32_t> codes = to_srgb8(drawn(m, turned(look, *m, width, height, pi / 2)));
    ASSERT_EQ(pixels.bytes.size(), 3 * codes.size());
    for (std::size_t i = 0; i < pixels.bytes.size(); ++i)
        ASSERT_EQ(std::uint32_t(pixels.bytes[i]), codes[i / 3] >> 8 * (i % 3) & 255) << i;
}

TEST_F(Record, WhatIsWrittenStaysWhenItIsCancelled) {
    const auto m = model(write_model());
    Context* running = nullptr;
    Context context({.threads = 1, .progress = [&](std::string_view, double fraction) {
                         if (fraction > 0.5) running->cancel();
                     }});
    running = &context;
    const Turn turn = record_turn(m, first_look(*m), width, height, 4, folder, context);
    EXPECT_GE(turn.written, 2);
    EXPECT_LT(turn.written, 4);
    EXPECT_EQ(files(), turn.written);
    context_.cancel();
    EXPECT_EQ(record_turn(m, first_look(*m), width, height, 4, folder + "-2", context_).written, 0);
    EXPECT_FALSE(std::filesystem::exists(folder + "-2"));
}

TEST_F(Record, ItSaysHowFarItCame) {
    EXPECT_EQ(to_text(Turn{72, 72}, "a"), "wrote 72 pictures to a");
    EXPECT_EQ(to_text(Turn{51, 72}, "a"), "cancelled: 51 of 72 pictures are in a");
    EXPECT_EQ(to_text(Turn{0, 72}, "a"), "cancelled: none of 72 pictures was made");
}

}  // namespace
}  // namespace rakelight::viewer
