// SPDX-License-Identifier: Apache-2.0
#include "image/tone.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "image/srgb_encoder.h"
#include "math/color.h"

namespace rakelight {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();

TEST(SrgbEncoder, GivesTheExactCodeForEveryFloatFromZeroToOneSampledDensely) {
    const SrgbEncoder& encode = SrgbEncoder::instance();
    for (std::uint32_t bits = 0; bits <= std::bit_cast<std::uint32_t>(1.0f); bits += 509)
        ASSERT_EQ(encode(std::bit_cast<float>(bits)), srgb8_from_linear(std::bit_cast<float>(bits))) << bits;
}

TEST(SrgbEncoder, GivesTheExactCodeAroundEveryStep) {
    const SrgbEncoder& encode = SrgbEncoder::instance();
    for (int code = 1; code <= 255; ++code) {
        const auto middle = std::bit_cast<std::uint32_t>(linear_from_srgb((float(code) - 0.5f) / 255.0f));
        for (std::uint32_t bits = middle - 300; bits < middle + 300; ++bits)
            ASSERT_EQ(encode(std::bit_cast<float>(bits)), srgb8_from_linear(std::bit_cast<float>(bits))) << code;
    }
}

TEST(SrgbEncoder, EveryCodeComesBack) {
    for (std::uint32_t code = 0; code < 256; ++code)
        EXPECT_EQ(SrgbEncoder::instance()(linear_from_srgb8(std::uint8_t(code))), code);
}

TEST(SrgbEncoder, ClampsWhatIsOutsideAndMakesNanBlack) {
    const SrgbEncoder& encode = SrgbEncoder::instance();
    for (const float dark :
         {-infinity, -1.0f, -0.0f, 0.0f, 1e-40f, std::numeric_limits<float>::denorm_min(), nan, -nan})
        EXPECT_EQ(encode(dark), 0u) << dark;
    for (const float bright : {1.0f, std::nextafter(1.0f, 2.0f), 1e30f, infinity})
        EXPECT_EQ(encode(bright), 255u) << bright;
}

TEST(ToSrgb8, EncodesColorsAndKeepsAlphaLinear) {
    const std::vector<vec4> row{{0.5f, 0.0f, 1.0f, 0.5f}, {-1, nan, 2, 3}, {0.214041f, 0.0021f, 0.9f, nan}};
    std::vector<std::uint8_t> rgba(12), rgb(9);
    to_srgb8(row, 4, rgba);
    EXPECT_EQ(rgba, (std::vector<std::uint8_t>{188, 0, 255, 128, 0, 0, 255, 255, 127, 7, 243, 0}));
    to_srgb8(row, 3, rgb);
    EXPECT_EQ(rgb, (std::vector<std::uint8_t>{188, 0, 255, 0, 0, 255, 127, 7, 243}));
    to_srgb8({}, 4, {});
}

}  // namespace
}  // namespace rakelight
