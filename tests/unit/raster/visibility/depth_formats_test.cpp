// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/visibility/depth_formats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace rakelight;
using namespace rakelight::raster;

namespace {
constexpr Visibility formats[] = {Visibility::z16, Visibility::z24, Visibility::z32, Visibility::z_float,
                                  Visibility::z_reversed};
constexpr DepthRange lecture{1, 1000, false};

double stored_at(Visibility format, double distance, const DepthRange& r) {
    return stored_depth(format, reversed_depth(distance, r), r);
}
double distance_of_part(double part, const DepthRange& r) { return r.z_near + part * (r.z_far - r.z_near); }
}  // namespace

TEST(DepthFormats, TheFirst2PercentOfTheLecturesRangeGet95Point3PercentOfTheDepthsNot98) {
    EXPECT_NEAR(standard_depth(distance_of_part(0.02, lecture), lecture), 0.9533, 5e-5);
    // z' = 0.98 where z = far near / (far - 0.98 (far - near))
    const double at_98 = 1000 / (1000 - 0.98 * 999);
    EXPECT_NEAR(standard_depth(at_98, lecture), 0.98, 1e-12);
    EXPECT_NEAR((at_98 - 1) / 999, 0.0467, 5e-5);
    const DepthRange wider{1, 2400, false};
    EXPECT_NEAR(standard_depth(distance_of_part(0.02, wider), wider), 0.98, 5e-5);
}

TEST(DepthFormats, ShareOfTheCodesInTheFirst2PercentIsCountedNotOnlyComputed) {
    int codes = 0;
    double last = -1;
    for (int i = 0; i <= 2000000; ++i) {
        const double code = stored_at(Visibility::z16, distance_of_part(0.02 * i / 2000000, lecture), lecture);
        codes += code != last;
        last = code;
    }
    EXPECT_NEAR(codes / 65536.0, 0.9533, 1e-4);
}

TEST(DepthFormats, NearIsZeroAndFarIsTheLargestNumber) {
    for (const DepthRange& r : {lecture, DepthRange{0.1, 50, true}}) {
        for (const Visibility f : {Visibility::z16, Visibility::z24, Visibility::z32, Visibility::z_float})
            EXPECT_EQ(stored_at(f, r.z_near, r), 0);
        EXPECT_EQ(stored_at(Visibility::z16, r.z_far, r), 65535);
        EXPECT_EQ(stored_at(Visibility::z24, r.z_far, r), 16777215);
        EXPECT_EQ(stored_at(Visibility::z32, r.z_far, r), 4294967295.0);
        EXPECT_EQ(stored_at(Visibility::z_float, r.z_far, r), 1);
        EXPECT_EQ(stored_at(Visibility::z_reversed, r.z_near, r), -1);
    }
}

TEST(DepthFormats, WhatIsFartherNeverHasTheLesserNumber) {
    for (const Visibility f : formats) {
        double last = -2;
        for (double d = 1; d <= 1000; d *= 1.0001) {
            const double code = stored_at(f, d, lecture);
            EXPECT_GE(code, last);
            last = code;
        }
    }
}

TEST(DepthFormats, AStepIsTheDistanceInWhichTheStoredNumberChangesOnce) {
    for (const DepthRange& r : {lecture, DepthRange{0.1, 1000, false}, DepthRange{0.5, 80, true}})
        for (const Visibility f : formats)
            for (const double d : {2.1, 7.3, 23.0, 61.0}) {
                const double step = depth_step(f, d, r);
                int changes = 0;
                double last = stored_at(f, d, r);
                const int tries = 4000;
                for (int i = 1; i <= tries; ++i) {
                    const double code = stored_at(f, d + step * 20 * i / tries, r);
                    changes += code != last;
                    last = code;
                }
                const double far_end = d + 20 * step,
                             slope = r.orthographic ? 1 : d / far_end;  // steps grow on the way
                EXPECT_NEAR(changes, 20 * slope, 1.1)
                    << int(f) << " at " << d << " of " << r.z_far << (r.orthographic ? " parallel" : "");
            }
}

TEST(DepthFormats, AnInfiniteFarPlaneHasTheLimitOfTheFormula) {
    const DepthRange r{0.5, std::numeric_limits<double>::infinity(), false};
    EXPECT_DOUBLE_EQ(standard_depth(2, r), 0.75);
    EXPECT_EQ(stored_at(Visibility::z16, 1e12, r), 65535);
    EXPECT_NEAR(depth_step(Visibility::z16, 2, r), 4 / 0.5 / 65535, 1e-12);
}

TEST(DepthFormats, TheStandardFloatIsHardlyFinerThan24BitsFarAwayAndTheReversedOneIsThousandsOfTimesFiner) {
    const DepthRange r{0.1, 1000, false};
    EXPECT_NEAR(depth_step(Visibility::z_float, 900, r) / depth_step(Visibility::z24, 900, r), 1.0, 1e-3);
    EXPECT_GT(depth_step(Visibility::z24, 900, r) / depth_step(Visibility::z_reversed, 900, r), 4000);
}
