// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/environment_table.h"

#include <gtest/gtest.h>

#include <cstring>

#include "image/maps/environment.h"
#include "math/linear.h"
#include "support/scene_builder.h"
#include "unit/shading/fixed_random.h"

namespace rakelight::shading {
namespace {

using test::chi_square_deviation;
using test::FixedRandom;

/// A gray picture of floats whose texel (x, y) is value(x, y).
template <class Value>
MipChain float_sky(int width, int height, const Value& value) {
    Pixels pixels{.width = width, .height = height, .channels = 1, .component = Component::f32, .is_linear = true};
    std::vector<float> values;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) values.push_back(float(value(x, y)));
    pixels.bytes.resize(values.size() * sizeof(float));
    std::memcpy(pixels.bytes.data(), values.data(), pixels.bytes.size());
    Context context({.threads = 1});
    return make_mip_chain(pixels, ColorSpace::srgb, context);
}

MipChain one_texel(int width, int height, int bright_x, int bright_y, double value = 100) {
    return float_sky(width, height, [=](int x, int y) { return x == bright_x && y == bright_y ? value : 0.0; });
}

MipChain uneven_sky(int width, int height) {
    FixedRandom random(7);
    return float_sky(width, height, [&](int, int) { return std::pow(random(), 6); });
}

struct Table {
    Context context{{.threads = 1}};
    EnvironmentTable table;
    explicit Table(const MipChain& sky) : table(sky, context) {}
};

/// Over the sphere, by the middles of equal parts in angle.
template <class Value>
double integral(const Value& value, int rows = 600) {
    double sum = 0;
    for (int y = 0; y < rows; ++y) {
        const double v = (y + 0.5) / rows, area = 2 * (pi / rows) * (pi / rows) * std::sin(pi * v);
        for (int x = 0; x < rows; ++x)
            sum += area * double(value(cast<float>(equirectangular_direction((x + 0.5) / rows, v))));
    }
    return sum;
}

double length_of(vec3 d) { return std::sqrt(dot(cast<double>(d), cast<double>(d))); }

TEST(EnvironmentTable, ItsDensityIntegratesToOne) {
    for (const auto& [width, height] : {std::pair{40, 20}, {100, 25}, {1, 1}, {3, 50}}) {
        const Table made(uneven_sky(width, height));
        EXPECT_NEAR(integral([&](vec3 d) { return made.table.pdf(d); }), 1, 2e-3) << width;
    }
}

TEST(EnvironmentTable, ChoosesDirectionsAsItsDensitySays) {
    const Table made(uneven_sky(24, 12));
    constexpr int samples = 400000, columns = 48, rows = 24;  // four bins a texel
    FixedRandom random(8);
    std::vector<double> counts(columns * rows), expected;
    for (int i = 0; i < samples; ++i) {
        const vec3 d = made.table.sample({random(), random()}).direction;
        ASSERT_NEAR(length_of(d), 1, 1e-6);
        const dvec2 uv = equirectangular(cast<double>(d));
        ++counts[std::min(std::size_t(uv.y * rows), std::size_t(rows - 1)) * columns +
                 std::size_t(uv.x * columns) % columns];
    }
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const double area = 2 * pi / columns * (std::cos(pi * y / rows) - std::cos(pi * (y + 1) / rows));
            const dvec3 d = equirectangular_direction((x + 0.5) / columns, (y + 0.5) / rows);
            expected.push_back(samples * area * double(made.table.pdf(cast<float>(d))));
        }
    EXPECT_LT(chi_square_deviation(counts, expected), 4);
}

TEST(EnvironmentTable, TheDensityOfASampleIsThatOfItsDirection) {
    const Table made(uneven_sky(200, 100));
    FixedRandom random(9);
    constexpr int samples = 20000;
    int others = 0;  // directions are floats: on an edge the texel beside it may be meant
    for (int i = 0; i < samples; ++i) {
        const EnvironmentTable::Sample s = made.table.sample({random(), random()});
        ASSERT_GT(s.pdf, 0);
        if (made.table.pdf(s.direction) != s.pdf) ++others;
    }
    EXPECT_LE(others, 4);
}

TEST(EnvironmentTable, AnAxisIsWhereTheTextOfThePictureHasIt) {
    const struct {
        int x, y;
        vec3 direction;
    } places[] = {{64, 32, {0, 0, -1}}, {96, 32, {1, 0, 0}}, {0, 32, {0, 0, 1}},
                  {32, 32, {-1, 0, 0}}, {5, 0, {0, 1, 0}},   {5, 63, {0, -1, 0}}};
    for (const auto& place : places) {
        const Table made(one_texel(128, 64, place.x, place.y));
        FixedRandom random(10);
        int near = 0;
        for (int i = 0; i < 1000; ++i)
            if (dot(made.table.sample({random(), random()}).direction, place.direction) > std::cos(radians(8.0)))
                ++near;
        EXPECT_GT(near, 980) << place.x << " " << place.y;
        if (place.direction.y == 0) {
            EXPECT_GT(made.table.pdf(place.direction), 1) << place.x << " " << place.y;
        }
    }
}

TEST(EnvironmentTable, ASingleBrightTexelIsFoundAndSoIsWhatBilinearSamplingBringsBeside) {
    const Table made(one_texel(64, 32, 20, 10));
    const auto pdf = [&](double x, double y) {
        return double(made.table.pdf(cast<float>(equirectangular_direction(x / 64, y / 32))));
    };
    const double area = 2 * pi / 64 * (std::cos(pi * 10 / 32) - std::cos(pi * 11 / 32));
    EXPECT_NEAR(pdf(20.5, 10.5) * area, 0.75 * 0.75, 0.01) << "the mean of the bilinear picture over its texel";
    EXPECT_NEAR(pdf(21.5, 10.5) / pdf(20.5, 10.5), 1 / 6.0, 0.01);
    EXPECT_NEAR(pdf(20.5, 11.5) / pdf(20.5, 10.5), 1 / 6.0, 0.01);
    EXPECT_NEAR(pdf(50.5, 30.5), 0.005 / (4 * pi), 1e-4) << "the even share";
}

TEST(EnvironmentTable, EveryDirectionHasDensityWhereThereIsAnyLight) {
    const Table made(one_texel(256, 128, 3, 4));
    double least = 1;
    integral([&](vec3 d) { return least = std::min(least, double(made.table.pdf(d))); }, 200);
    EXPECT_GT(least, 0.004 / (4 * pi));
}

TEST(EnvironmentTable, LargePicturesAreLookedAtAsSmallOnes) {
    Table made(one_texel(4096, 2048, 3000, 700, 1e6));
    FixedRandom random(11);
    const vec3 bright = cast<float>(equirectangular_direction(3000.5 / 4096, 700.5 / 2048));
    int near = 0;
    for (int i = 0; i < 1000; ++i)
        if (dot(made.table.sample({random(), random()}).direction, bright) > std::cos(radians(0.8))) ++near;
    EXPECT_GT(near, 970);
    EXPECT_EQ(made.context.memory().charged(), AliasTable::bytes_for(1024 * 512));
}

TEST(EnvironmentTable, LightThatTheSmallVersionRoundsToBlackIsStillFound) {
    Context context({.threads = 1});
    const auto dim = test::rgb_pixels(2048, 1024, [](int x, int y) {
        const int code = x == 900 && y == 300 ? 1 : 0;
        return std::array{code, code, code};
    });
    const Table made(make_mip_chain(dim, ColorSpace::srgb, context));
    ASSERT_FALSE(made.table.empty());
    EXPECT_NEAR(made.table.pdf({0, 0.6f, -0.8f}), 1 / (4 * pi), 1e-6) << "evenly: nothing is known of where it is";
}

TEST(EnvironmentTable, ABlackPictureAndNoneGiveNoDirections) {
    for (const MipChain& sky : {float_sky(16, 8, [](int, int) { return 0.0; }), MipChain()}) {
        Table made(sky);
        EXPECT_TRUE(made.table.empty());
        EXPECT_EQ(made.table.sample({0.5, 0.5}).pdf, 0);
        EXPECT_EQ(made.table.pdf({0, 1, 0}), 0);
        EXPECT_EQ(made.context.memory().charged(), 0u);
    }
}

TEST(EnvironmentTable, NegativeLightCountsAsNone) {
    const Table made(float_sky(64, 32, [](int x, int) { return x < 32 ? -5.0 : 1.0; }));
    EXPECT_NEAR(made.table.pdf({-1, 0, 0}), 0.005 / (4 * pi), 1e-4);
    EXPECT_GT(made.table.pdf({1, 0, 0}), 1.9 / (4 * pi));
}

TEST(EnvironmentTable, DirectionsOfAnyLengthHaveADensityThoseOfNoneHaveNot) {
    const Table made(uneven_sky(64, 32));
    EXPECT_EQ(made.table.pdf({3, 1, 2}), made.table.pdf({0.3f, 0.1f, 0.2f}));
    EXPECT_EQ(made.table.pdf({0, 0, 0}), 0);
    EXPECT_EQ(made.table.pdf({std::nanf(""), 0, 1}), 0);
    EXPECT_EQ(made.table.pdf({std::numeric_limits<float>::infinity(), 0, 0}), 0);
}

/// What it is for: the mean of light by density is all light, with little noise.
TEST(EnvironmentTable, LightByDensityIsAllLight) {
    const auto sky = [](int x, int y) { return x == 40 && y == 9 ? 5000.0 : 0.2 + 0.01 * y; };
    const MipChain chain = float_sky(64, 32, sky);
    const Table made(chain);
    const auto light = [&](vec3 d) {  // bilinear, as engines have it
        const dvec2 uv = equirectangular(cast<double>(d));
        const double x = uv.x * 64 - 0.5, y = std::clamp(uv.y * 32 - 0.5, 0.0, 31.0);
        const int x0 = int(std::floor(x)), y0 = std::min(int(y), 30);
        const auto row = [&](int at) {
            const double left = sky((x0 + 64) % 64, at), right = sky((x0 + 65) % 64, at);
            return left + (right - left) * (x - x0);
        };
        return row(y0) + (row(y0 + 1) - row(y0)) * (y - y0);
    };
    const double all = integral(light, 2400);
    FixedRandom random(12);
    constexpr int samples = 200000;
    double sum = 0, squares = 0;
    for (int i = 0; i < samples; ++i) {
        const EnvironmentTable::Sample s = made.table.sample({random(), random()});
        const double value = light(s.direction) / double(s.pdf) / all;
        sum += value, squares += value * value;
    }
    const double mean = sum / samples, variance = squares / samples - mean * mean;
    EXPECT_NEAR(mean, 1, 0.006);
    EXPECT_LT(variance, 1) << "uniform directions have about 300";
}

EnvironmentFactors turned_by(float cosine, float sine) {
    EnvironmentFactors e{};
    e.turn[0][0] = e.turn[2][2] = cosine, e.turn[1][1] = 1;
    e.turn[2][0] = sine, e.turn[0][2] = -sine;
    return e;
}

TEST(EnvironmentFactors, TurnThePictureAboutTheVertical) {
    EnvironmentFactors turned = turned_by(0, 1);  // a quarter turn: as a node of the scene turns, -Z to -X
    EXPECT_EQ(from_picture(turned, {0, 0, -1}), (vec3{-1, 0, 0}));
    EXPECT_EQ(from_picture(turned, {1, 0, 0}), (vec3{0, 0, -1}));
    EXPECT_EQ(to_picture(turned, {-1, 0, 0}), (vec3{0, 0, -1}));
    turned = turned_by(0.6f, 0.8f);
    const vec3 d{0.48f, 0.6f, 0.64f}, back = to_picture(turned, from_picture(turned, d));
    EXPECT_NEAR(back.x, d.x, 1e-6);
    EXPECT_EQ(back.y, d.y);
    EXPECT_NEAR(back.z, d.z, 1e-6);
}

TEST(EnvironmentTable, NeedsNoMoreMemoryThanItMay) {
    Context context({.threads = 1, .max_memory = 1000});
    const MipChain sky = uneven_sky(64, 32);
    EXPECT_THROW(EnvironmentTable(sky, context), Error);
    EXPECT_EQ(context.memory().charged(), 0u);
}

}  // namespace
}  // namespace rakelight::shading
