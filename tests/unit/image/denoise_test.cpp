// SPDX-License-Identifier: Apache-2.0
#include "image/denoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

#include <rakelight/math/linear.h>

#include "support/thrown_error.h"

namespace rakelight {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// What a pixel shows.
struct Seen {
    float light = 1;
    vec3 albedo{0.5f, 0.5f, 0.5f}, normal{0, 0, 1}, position{};
};
using Scene = std::function<Seen(int x, int y)>;

Seen flat(int x, int y) { return {.position = {float(x), float(y), 0}}; }

struct Picture {
    int width, height;
    std::vector<vec3> color, variance, albedo, normal, position, clean;
    std::size_t at(int x, int y) const { return std::size_t(y * width + x); }
    NoisyPicture view() const { return {width, height, color, variance, albedo, normal, position}; }
};

/// [0, 1)
float uniform(std::uint32_t& state) {
    state = state * 1664525u + 1013904223u;
    std::uint32_t mixed = (state ^ state >> 15) * 0x2c1b3c6du;
    mixed = (mixed ^ mixed >> 12) * 0x297a2d39u;
    return float(mixed >> 8) * 0x1p-24f;
}

/// Means of samples that are 3 u^2 of the clean color (mean 1, variance 0.8), each channel on its own.
Picture render(int width, int height, int samples, const Scene& scene, std::uint32_t seed = 1) {
    Picture out{width, height, {}, {}, {}, {}, {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Seen seen = scene(x, y);
            vec3 mean, variance;
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0, squares = 0;
                for (int s = 0; s < samples; ++s) {
                    const double u = double(uniform(seed)), v = double(seen.light * seen.albedo[c]) * 3 * u * u;
                    sum += v, squares += v * v;
                }
                mean[c] = float(sum / samples);
                variance[c] = float(std::fmax(0.0, squares / samples - sum / samples * sum / samples) / (samples - 1));
            }
            out.color.push_back(mean), out.variance.push_back(variance);
            out.albedo.push_back(seen.albedo), out.normal.push_back(seen.normal);
            out.position.push_back(seen.position), out.clean.push_back(seen.albedo * seen.light);
        }
    return out;
}

std::vector<vec3> denoised(const NoisyPicture& picture, int threads = 2, Isa isa = best_isa()) {
    Context context({.threads = threads});
    std::vector<vec3> out(picture.color.size());
    denoise_into(picture, out, context, isa);
    return out;
}
std::vector<vec3> denoised(const Picture& picture) { return denoised(picture.view()); }

/// Root of the mean square of (a - clean) / clean over columns from..to - 1.
double relative_error(const Picture& p, const std::vector<vec3>& a, int from, int to) {
    double sum = 0;
    for (int y = 0; y < p.height; ++y)
        for (int x = from; x < to; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const double clean = double(p.clean[p.at(x, y)][c]), d = (double(a[p.at(x, y)][c]) - clean) / clean;
                sum += d * d;
            }
    return std::sqrt(sum / (3.0 * p.height * (to - from)));
}
double relative_error(const Picture& p, const std::vector<vec3>& a) { return relative_error(p, a, 0, p.width); }

double mean(const std::vector<vec3>& colors) {
    double sum = 0;
    for (const vec3& c : colors) sum += double(c.x) + double(c.y) + double(c.z);
    return sum / (3.0 * double(colors.size()));
}

bool same_bits(const std::vector<vec3>& a, const std::vector<vec3>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(vec3)) == 0;
}

TEST(Denoise, TakesNineTenthsOfTheErrorFromAFlatPictureAndKeepsItsEnergy) {
    for (const int samples : {16, 64, 256}) {
        const Picture p = render(90, 70, samples, flat);
        const std::vector<vec3> out = denoised(p);
        EXPECT_LT(relative_error(p, out), relative_error(p, p.color) / 10) << samples;
        EXPECT_NEAR(mean(out) / mean(p.color), 1, 0.01) << samples;
    }
}

TEST(Denoise, TakesTheErrorFromATextureAndKeepsIt) {
    const Picture p = render(90, 70, 64, [](int x, int y) {
        Seen s = flat(x, y);
        std::uint32_t seed = std::uint32_t(y * 977 + x);
        for (std::size_t c = 0; c < 3; ++c) s.albedo[c] = 0.4f + 0.3f * uniform(seed);
        return s;
    });
    EXPECT_LT(relative_error(p, denoised(p)), relative_error(p, p.color) / 7);
}

constexpr int edge = 40;  ///< the first column of the right half

TEST(Denoise, KeepsAnEdgeOfAlbedo) {
    const Picture p = render(80, 60, 64, [](int x, int y) {
        Seen s = flat(x, y);
        if (x >= edge) s.albedo = {0.05f, 0.9f, 0.1f};
        return s;
    });
    EXPECT_LT(relative_error(p, denoised(p), edge - 1, edge + 1), 0.02);
}

TEST(Denoise, KeepsAnEdgeOfTheNormal) {
    const Picture p = render(80, 60, 64, [](int x, int y) {
        Seen s = flat(x, y);
        if (x >= edge) s.light = 0.8f, s.normal = {0.8f, 0, 0.6f};
        return s;
    });
    EXPECT_LT(relative_error(p, denoised(p), edge - 1, edge + 1), 0.02);
}

TEST(Denoise, KeepsAnEdgeOfDepthBetweenParallelPlanes) {
    Picture p = render(80, 60, 64, [](int x, int y) {
        Seen s = flat(x, y);
        if (x >= edge) s.light = 0.8f, s.position.z = -100;
        return s;
    });
    EXPECT_LT(relative_error(p, denoised(p), edge - 1, edge + 1), 0.02);
    p.position.clear();
    EXPECT_GT(relative_error(p, denoised(p), edge - 1, edge + 1), 0.02) << "what positions are for";
}

TEST(Denoise, KeepsTheEdgeOfAShadowThatOnlyColorsShow) {
    const Picture p = render(80, 60, 64, [](int x, int y) {
        Seen s = flat(x, y);
        if (x >= edge) s.light = 0.3f;
        return s;
    });
    const std::vector<vec3> out = denoised(p);
    EXPECT_LT(relative_error(p, out, edge - 1, edge + 1), 0.05);
    EXPECT_LT(relative_error(p, out), relative_error(p, p.color) / 5);
}

TEST(Denoise, LeavesColorsOfZeroVarianceAsTheyAre) {
    Picture p = render(70, 50, 2, flat);
    p.variance.assign(p.variance.size(), {});
    const std::vector<vec3> out = denoised(p);
    for (std::size_t i = 0; i < out.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(out[i][c], p.color[i][c], 1e-5f * p.color[i][c]) << i;
    p.color.assign(p.color.size(), {1, 2, 3});
    for (const vec3& c : denoised(p)) ASSERT_NEAR(c.z, 3.0f, 3e-5f);
}

TEST(Denoise, KeepsTheEdgeBetweenASurfaceAndABackgroundWithout) {
    const Picture p = render(80, 60, 64, [](int x, int y) {
        if (x >= edge) return Seen{.light = 0.6f, .albedo = {1, 1, 1}, .normal = {}, .position = {}};
        return flat(x, y);
    });
    EXPECT_LT(relative_error(p, denoised(p), edge - 1, edge + 1), 0.04);
}

/// A scene with edges, noise, fireflies and pixels that are not finite.
Picture busy_picture(int width, int height) {
    Picture p = render(width, height, 16, [](int x, int y) {
        Seen s = flat(x, y);
        if ((x / 23 + y / 17) % 2) s.light = 0.4f;
        if (x % 31 < 7) s.albedo = {0.9f, 0.2f, 0.04f};
        if (y % 41 < 9) s.normal = {0, 0.6f, 0.8f};
        return s;
    });
    for (std::size_t i = 50; i < p.color.size(); i += 997)
        p.color[i] = {90, 80, 70}, p.variance[i] = {8000, 6000, 5000};
    for (std::size_t i = 77; i < p.color.size(); i += 1999) p.color[i].y = nan;
    return p;
}

TEST(Denoise, GivesAWindowWithItsGuardBandTheBitsOfTheWhole) {
    const Picture whole = busy_picture(210, 150);
    const std::vector<vec3> of_whole = denoised(whole);
    struct Window {
        int x, y, width, height;
    };
    for (const Window w :
         {Window{50, 40, 30, 20}, Window{0, 0, 70, 64}, Window{130, 100, 80, 50}, Window{64, 0, 1, 1}}) {
        const int left = std::max(0, w.x - denoise_radius), right = std::min(210, w.x + w.width + denoise_radius);
        const int top = std::max(0, w.y - denoise_radius), bottom = std::min(150, w.y + w.height + denoise_radius);
        Picture part{right - left, bottom - top, {}, {}, {}, {}, {}, {}};
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const std::size_t i = whole.at(x, y);
                part.color.push_back(whole.color[i]), part.variance.push_back(whole.variance[i]);
                part.albedo.push_back(whole.albedo[i]), part.normal.push_back(whole.normal[i]);
                part.position.push_back(whole.position[i]);
            }
        const std::vector<vec3> of_part = denoised(part);
        for (int y = w.y; y < w.y + w.height; ++y)
            for (int x = w.x; x < w.x + w.width; ++x)
                ASSERT_EQ(of_part[part.at(x - left, y - top)], of_whole[whole.at(x, y)]) << x << "," << y;
    }
}

TEST(Denoise, HasTheSameBitsForAnyThreadsAndInstructionSet) {
    const Picture p = busy_picture(150, 100);
    const std::vector<vec3> one = denoised(p.view(), 1, Isa::scalar);
    EXPECT_TRUE(same_bits(one, denoised(p.view(), 4, Isa::scalar)));
    for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512})
        if (is_available(isa)) {
            EXPECT_TRUE(same_bits(one, denoised(p.view(), 2, isa))) << name(isa);
        }
}

TEST(Denoise, FillsPixelsThatAreNotFiniteFromTheirNeighbors) {
    Picture p = render(60, 50, 64, flat);
    const std::vector<vec3> before = denoised(p);
    const std::size_t bad = p.at(30, 25);
    for (const float value : {nan, std::numeric_limits<float>::infinity(), 1e30f, -1.0f}) {
        p.color[bad] = {0.5f, value, 0.5f};
        const std::vector<vec3> after = denoised(p);
        for (std::size_t i = 0; i < after.size(); ++i) ASSERT_NEAR(after[i].y, before[i].y, 0.02f) << value;
    }
    p.color[bad] = {}, p.variance[bad] = p.albedo[bad] = p.normal[bad] = p.position[bad] = {nan, nan, nan};
    const std::vector<vec3> after = denoised(p);
    for (std::size_t i = 0; i < after.size(); ++i)
        if (i != bad) {
            ASSERT_NEAR(after[i].y, before[i].y, 0.02f);
        }
    EXPECT_TRUE(std::isfinite(after[bad].x));
}

TEST(Denoise, DoesNotSmearFireflies) {
    Picture p = render(60, 50, 64, flat);
    const std::vector<vec3> before = denoised(p);
    for (const std::size_t i : {p.at(30, 25), p.at(31, 25), p.at(30, 26), p.at(0, 0)})
        p.color[i] = {1000, 900, 800}, p.variance[i] = {1e6f, 8.1e5f, 6.4e5f};  // one sample has it all
    const std::vector<vec3> after = denoised(p);
    for (std::size_t i = 0; i < after.size(); ++i) ASSERT_NEAR(after[i].x, before[i].x, 0.02f) << i;
}

TEST(Denoise, KeepsASmallBrightThingThatIsNoNoise) {
    Picture p = render(60, 50, 64, flat);
    const std::size_t i = p.at(30, 25);
    p.color[i] = {20, 20, 20}, p.variance[i] = {0.04f, 0.04f, 0.04f};
    const std::vector<vec3> out = denoised(p);
    EXPECT_NEAR(out[i].x, 20, 0.5);
    EXPECT_NEAR(out[p.at(31, 25)].x, 0.5, 0.1);
}

TEST(Denoise, TakesSmallPicturesAndBlackOnes) {
    EXPECT_TRUE(denoised(Picture{}).empty());
    for (const int size : {1, 2, 5}) {
        const Picture p = render(size, 1, 4, flat);
        for (const vec3& c : denoised(p)) EXPECT_NEAR(c.x, 0.5f, 0.5f);
    }
    Picture black = render(20, 20, 4, flat);
    for (auto* const plane : {&black.color, &black.variance, &black.albedo, &black.normal, &black.position})
        plane->assign(plane->size(), {});
    for (const vec3& c : denoised(black)) EXPECT_EQ(c, vec3());
}

TEST(Denoise, RefusesSpansOfOtherSizes) {
    const Picture p = render(8, 4, 4, flat);
    const auto error_with = [&](auto change) {
        NoisyPicture view = p.view();
        change(view);
        return test::error_of([&] {
            Context context({.threads = 1});
            std::vector<vec3> out(p.color.size());
            denoise_into(view, out, context);
        });
    };
    const std::span<const vec3> part = std::span(p.color).first(31);
    EXPECT_EQ(error_with([&](NoisyPicture& v) { v.color = part; }).reason(),
              "denoising: the color has 31 pixels, the picture 32");
    for (const auto member :
         {&NoisyPicture::variance, &NoisyPicture::albedo, &NoisyPicture::normal, &NoisyPicture::position})
        EXPECT_EQ(error_with([&](NoisyPicture& v) { v.*member = part; }).code(), ErrorCode::usage);
    EXPECT_EQ(error_with([&](NoisyPicture& v) { v.width = -8; }).code(), ErrorCode::usage);
    EXPECT_EQ(error_with([&](NoisyPicture& v) { v.height = 5; }).code(), ErrorCode::usage);
}

TEST(Denoise, EndsWhenCancelledAndStaysWithinTheMemoryBudget) {
    const Picture p = render(8, 4, 4, flat);
    std::vector<vec3> out(p.color.size());
    Context cancelled({.threads = 1});
    cancelled.cancel();
    EXPECT_EQ(test::error_of([&] { denoise_into(p.view(), out, cancelled); }).code(), ErrorCode::failed);
    Context small({.threads = 1, .max_memory = 1000});
    EXPECT_EQ(test::error_of([&] { denoise_into(p.view(), out, small); }).code(), ErrorCode::bad_file);
    Context enough({.threads = 1});
    denoise_into(p.view(), out, enough);
    EXPECT_EQ(enough.memory().charged(), 0u);
}

}  // namespace
}  // namespace rakelight
