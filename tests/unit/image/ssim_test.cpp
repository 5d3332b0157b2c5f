// SPDX-License-Identifier: Apache-2.0
#include "image/compare/ssim.h"

#include <gtest/gtest.h>

#include "metric_pictures.h"

namespace rakelight {
namespace {

using namespace test;

TEST(MeanSsim, IsWhatThePapersFormulaGives) {
    Context context({.threads = 1});
    for (const MetricValues& v : metric_values()) {
        const DisplayPicture a = display(v.a, metric_width, metric_height, context);
        const DisplayPicture b = display(v.b, metric_width, metric_height, context);
        EXPECT_NEAR(mean_ssim(a, b, context).value(), v.ssim, 1e-12) << v.name;
        EXPECT_NEAR(mean_ssim(b, a, context).value(), v.ssim, 1e-12) << v.name;
    }
}

TEST(MeanSsim, IsExactlyOneForEqualPictures) {
    Context context({.threads = 1});
    for (const PictureFormula formula : {noise_code, ramp, checks, black})
        EXPECT_EQ(mean_ssim(display(formula, 40, 30, context), display(formula, 40, 30, context), context), 1.0);
}

TEST(MeanSsim, OfTwoGraysHasAClosedForm) {  // nothing but eq. 6: (2 m n + C1) / (m^2 + n^2 + C1)
    Context context({.threads = 1});
    const double m = 128 / 255.0, n = 130 / 255.0, c1 = 1e-4;
    EXPECT_NEAR(mean_ssim(display(gray, 20, 20, context), display(gray_130, 20, 20, context), context).value(),
                (2 * m * n + c1) / (m * m + n * n + c1), 1e-12);
}

TEST(MeanSsim, NeedsElevenPixelsASide) {
    Context context({.threads = 1});
    EXPECT_TRUE(mean_ssim(display(ramp, 11, 11, context), display(step, 11, 11, context), context));
    EXPECT_FALSE(mean_ssim(display(ramp, 10, 30, context), display(step, 10, 30, context), context));
    EXPECT_FALSE(mean_ssim(display(ramp, 30, 10, context), display(step, 30, 10, context), context));
    EXPECT_FALSE(mean_ssim({}, {}, context));
}

TEST(MeanSsim, SeesADifferenceInTheLastRowAndColumnOfAWindow) {
    Context context({.threads = 1});
    const DisplayPicture a = display(noise_code, 266, 138, context);  // one window of results, with its margin
    for (const std::size_t at : {std::size_t(265), std::size_t(137 * 266)}) {
        DisplayPicture b = display(noise_code, 266, 138, context);
        b.codes[at] ^= 0xff;
        EXPECT_LT(mean_ssim(a, b, context).value(), 1.0) << at;
    }
}

TEST(MeanSsim, HasTheSameBitsForAnyNumberOfThreads) {
    Context one({.threads = 1}), four({.threads = 4});
    const DisplayPicture a = display(noise_code, 700, 300, one), b = display(other_noise, 700, 300, one);
    EXPECT_EQ(mean_ssim(a, b, one), mean_ssim(a, b, four));
}

}  // namespace
}  // namespace rakelight
