// SPDX-License-Identifier: Apache-2.0
#include "image/compare/flip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "image/compare/flip_color.h"
#include "image/compare/flip_kernels.h"
#include "metric_pictures.h"

namespace rakelight {
namespace {

using namespace test;

TEST(MeanFlip, IsWhatThePapersFormulasGive) {
    Context context({.threads = 1});
    for (const MetricValues& v : metric_values()) {
        const DisplayPicture a = display(v.a, metric_width, metric_height, context);
        const DisplayPicture b = display(v.b, metric_width, metric_height, context);
        std::vector<float> map;
        EXPECT_NEAR(mean_flip(a, b, v.pixels_per_degree, context, &map), v.flip, 1e-6) << v.name;
        EXPECT_NEAR(double(map.at(9 * metric_width + 12)), v.flip_of_pixel, 1e-6) << v.name;
        EXPECT_NEAR(mean_flip(b, a, v.pixels_per_degree, context), v.flip, 1e-6) << v.name;
    }
}

TEST(MeanFlip, IsZeroForEqualPictures) {
    Context context({.threads = 1});
    for (const PictureFormula formula : {noise_code, ramp, checks, black})
        EXPECT_EQ(mean_flip(display(formula, 40, 30, context), display(formula, 40, 30, context), 67, context), 0);
}

TEST(MeanFlip, OfGreenAndBlueIsOne) {  // the largest distance that the paper maps to 1
    Context context({.threads = 1});
    EXPECT_NEAR(mean_flip(display(green, 9, 9, context), display(blue, 9, 9, context), 67, context), 1, 1e-6);
}

/// What a pixel's error depends on lies within the filters' radius: a part of a picture has the same errors, wherever the picture's
/// windows begin.
TEST(MeanFlip, MapHasNoSeamsWhereWindowsMeet) {
    Context context({.threads = 2});
    constexpr int width = 300, height = 160, left = 240, top = 110, part_width = 40, part_height = 40, margin = 10;
    std::vector<float> whole, part;
    mean_flip(display(noise_code, width, height, context), display(other_noise, width, height, context), 67, context,
              &whole);
    const auto cut = [&](int shift) {
        return to_display(
            picture_of<std::uint8_t>(part_width, part_height, 3,
                                     [&](int x, int y, int c) { return noise(x + left + shift, y + top, c) & 255; }),
            context);
    };
    mean_flip(cut(0), cut(100), 67, context, &part);
    ASSERT_EQ(whole.size(), std::size_t(width * height));
    for (int y = margin; y < part_height - margin; ++y)
        for (int x = margin; x < part_width - margin; ++x)
            ASSERT_EQ(part[std::size_t(y * part_width + x)], whole[std::size_t((y + top) * width + x + left)])
                << x << "," << y;
}

/// Windows that are equal are passed over: not beside a difference that their margins show.
TEST(MeanFlip, ADifferenceReachesTheFiltersRadiusIntoTheNextWindow) {
    Context context({.threads = 1});
    const DisplayPicture a = display(gray, 600, 300, context);
    for (const int x : {255, 256})
        for (const int y : {127, 128}) {  // about the corner of four windows
            DisplayPicture b = display(gray, 600, 300, context);
            b.codes[std::size_t(y * 600 + x)] ^= 0xff;
            std::vector<float> map;
            mean_flip(a, b, 67, context, &map);
            const auto error = [&](int dx, int dy) { return map[std::size_t((y + dy) * 600 + x + dx)]; };
            for (const int sign : {-1, 1}) {
                EXPECT_GT(error(10 * sign, 0), 0.0f) << x << "," << y;
                EXPECT_GT(error(0, 10 * sign), 0.0f) << x << "," << y;
                EXPECT_EQ(error(11 * sign, 0), 0.0f) << x << "," << y;
                EXPECT_EQ(error(0, 11 * sign), 0.0f) << x << "," << y;
            }
        }
}

TEST(MeanFlip, HasTheSameBitsForAnyNumberOfThreads) {
    Context one({.threads = 1}), four({.threads = 4});
    const DisplayPicture a = display(noise_code, 700, 300, one), b = display(other_noise, 700, 300, one);
    EXPECT_EQ(mean_flip(a, b, 67, one), mean_flip(a, b, 67, four));
}

TEST(MeanFlip, TakesOnePixelAndNoneAndAllDistances) {
    Context context({.threads = 1});
    EXPECT_EQ(mean_flip({}, {}, 67, context), 0);
    const DisplayPicture a = display(black, 1, 1, context), b = display(white, 1, 1, context);
    for (const double ppd : {flip_least_ppd, 3.0, 67.0, flip_most_ppd})
        EXPECT_NEAR(mean_flip(a, b, ppd, context), 0.967379182244885, 1e-6) << ppd;
}

TEST(FlipKernels, HaveThePapersSizesAndSums) {
    for (const double ppd : {1.0, 20.0, 67.0, 1000.0}) {
        const flip::ContrastKernels c = flip::contrast_kernels(ppd);
        const flip::FeatureKernels f = flip::feature_kernels(ppd);
        for (const flip::Kernel& k : {c.achromatic, c.red_green, c.blue_yellow[0], c.blue_yellow[1], f.gaussian}) {
            double sum = 0;
            for (const double w : k) sum += w;
            EXPECT_NEAR(sum, 1, 1e-12) << ppd;
        }
        EXPECT_NEAR(c.blue_yellow_share[0] + c.blue_yellow_share[1], 1, 1e-12);
        for (const flip::Kernel& k : {f.edge, f.point}) {
            double positive = 0, negative = 0;
            for (const double w : k) (w > 0 ? positive : negative) += w;
            EXPECT_NEAR(positive, 1, 1e-12) << ppd;
            EXPECT_NEAR(negative, -1, 1e-12) << ppd;
        }
    }
    EXPECT_EQ(flip::contrast_kernels(67).radius, 10);
    EXPECT_EQ(flip::feature_kernels(67).radius, 9);
}

TEST(FlipColor, OpponentAndBackLeavesColorsAsTheyAre) {
    // L of linear 0.5 is 116 * 0.5^(1/3) - 16, and grays have no a and b
    const dvec3 gray = flip::lab_of_opponent(flip::opponent_from_linear({0.5, 0.5, 0.5}));
    EXPECT_NEAR(gray.x, 76.06926101415557, 1e-11);
    EXPECT_NEAR(gray.y, 0, 1e-9);
    EXPECT_NEAR(gray.z, 0, 1e-9);
    for (double light = 0.009; light <= 1; light *= 1.01)
        EXPECT_NEAR(flip::lab_of_opponent(flip::opponent_from_linear({light, light, light})).x,
                    116 * std::cbrt(light) - 16, 1e-9)
            << light;
    const dvec3 dark = flip::lab_of_opponent(flip::opponent_from_linear({0.001, 0.001, 0.001}));
    EXPECT_NEAR(dark.x, 0.9032962962962963, 1e-11);  // on the straight piece: 903.2963 * 0.001
}

}  // namespace
}  // namespace rakelight
