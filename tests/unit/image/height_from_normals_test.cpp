// SPDX-License-Identifier: Apache-2.0
// Height maps from normal maps: heights that are known come back.
#include "image/maps/height_from_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include <rakelight/math/vector.h>

#include "image/maps/fourier.h"

using namespace rakelight;

namespace {

/// A periodic relief [widths] and its slopes along u and v (down).
struct Wave {
    double height, along_u, along_v;
};
Wave wave(double u, double v) {
    const double a = 2 * pi * (2 * u + v), b = 2 * pi * 3 * v;
    return {0.01 * std::cos(a) + 0.004 * std::sin(b), -0.01 * 4 * pi * std::sin(a),
            -0.01 * 2 * pi * std::sin(a) + 0.004 * 6 * pi * std::cos(b)};
}

Pixels normal_map(int width, int height, bool green_down, double lean = 0) {
    Pixels p;
    p.width = width, p.height = height, p.channels = 3;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Wave w = wave((x + 0.5) / width, (y + 0.5) / height);
            // v counts heights of the picture, a height is height / width widths.
            const double n[3] = {-w.along_u + lean, w.along_v * width / height * (green_down ? -1 : 1), 1};
            const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + 1);
            for (const double c : n) p.bytes.push_back(std::byte(int(std::lround((c / length * 0.5 + 0.5) * 255))));
        }
    return p;
}

double height_at(const Pixels& p, int x, int y) {
    std::uint16_t code;
    std::memcpy(&code, p.row(y) + 2 * x, 2);
    return code / 65535.0;
}

/// Largest difference from the relief, in parts of its depth.
double error_of(const HeightsFromNormals& got) {
    double low = 1e9, high = -1e9, worst = 0;
    const int w = got.heights.width, h = got.heights.height;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const double z = wave((x + 0.5) / w, (y + 0.5) / h).height;
            low = std::fmin(low, z), high = std::fmax(high, z);
        }
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const double expected = (wave((x + 0.5) / w, (y + 0.5) / h).height - low) / (high - low);
            worst = std::fmax(worst, std::fabs(height_at(got.heights, x, y) - expected));
        }
    return std::fmax(worst, std::fabs(got.depth / (high - low) - 1));
}

}  // namespace

TEST(HeightFromNormals, GivesBackThePeriodicReliefThatTheMapWasMadeOf) {
    Context context;
    EXPECT_LT(error_of(heights_from_normals(normal_map(64, 64, false), false, context)), 0.01);
    EXPECT_LT(error_of(heights_from_normals(normal_map(64, 64, true), true, context)), 0.01);
}

TEST(HeightFromNormals, TakesAnySizeAndLeavesOutALeanOfTheWhole) {
    Context context;
    EXPECT_LT(error_of(heights_from_normals(normal_map(60, 35, false), false, context)), 0.015);
    EXPECT_LT(error_of(heights_from_normals(normal_map(97, 64, false), false, context)), 0.015);
    EXPECT_LT(error_of(heights_from_normals(normal_map(64, 64, false, 0.2), false, context)), 0.02);
}

TEST(HeightFromNormals, AFlatMapHasNoDepthAndLiesOnTop) {
    Pixels flat;
    flat.width = flat.height = 5, flat.channels = 3;
    for (int i = 0; i < 25; ++i)
        for (const int c : {128, 128, 255}) flat.bytes.push_back(std::byte(c));
    Context context;
    const HeightsFromNormals got = heights_from_normals(flat, false, context);
    EXPECT_EQ(got.depth, 0);
    EXPECT_EQ(height_at(got.heights, 2, 2), 1);
}

TEST(HeightFromNormals, LargeMapsComeOutSmallerAndAsDeep) {
    Context context;
    const HeightsFromNormals got = heights_from_normals(normal_map(4096, 64, false), false, context);
    EXPECT_EQ(got.heights.width, 2048);
    EXPECT_EQ(got.heights.height, 32);
    EXPECT_LT(error_of(heights_from_normals(normal_map(2304, 256, false), false, context)), 0.015);
}

TEST(HeightFromNormals, ThreadsChangeNoBit) {
    Context one({.threads = 1}), two({.threads = 2});
    const Pixels map = normal_map(50, 50, false);
    EXPECT_EQ(heights_from_normals(map, false, one).heights.bytes, heights_from_normals(map, false, two).heights.bytes);
}

TEST(HeightFromNormals, GivesBackAllThatItChargesToTheBudget) {
    Context context;
    heights_from_normals(normal_map(60, 35, false), false, context);
    EXPECT_EQ(context.memory().charged(), 0);
    Context small({.max_memory = 60 * 35 * 40});  // enough for the slopes, not for the texels too
    EXPECT_THROW(heights_from_normals(normal_map(60, 35, false), false, small), Error);
    EXPECT_EQ(small.memory().charged(), 0);
}

TEST(HeightFromNormals, SidesThatArePrimeAreStretchedToTheNextOf2And3And5) {
    for (const auto& [n, friendly] : {std::pair<std::size_t, std::size_t>{1, 1}, {7, 8}, {97, 100}, {2039, 2048}})
        EXPECT_EQ(good_fft_size(n), friendly);
    Context context;
    const HeightsFromNormals prime = heights_from_normals(normal_map(509, 251, false), false, context);
    EXPECT_EQ(prime.heights.width, 512);
    EXPECT_EQ(prime.heights.height, 256);
    EXPECT_LT(error_of(prime), 0.01);
    const HeightsFromNormals near = heights_from_normals(normal_map(512, 256, false), false, context);
    EXPECT_NEAR(prime.depth / near.depth, 1, 0.002);
    double worst = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x)
            worst = std::fmax(worst, std::fabs(height_at(prime.heights, x, y) - height_at(near.heights, x, y)));
    EXPECT_LT(worst, 0.005);
}
