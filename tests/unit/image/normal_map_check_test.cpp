// SPDX-License-Identifier: Apache-2.0
#include "image/maps/normal_map_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <rakelight/math/vector.h>

#include "math/color.h"

using namespace rakelight;

namespace {

constexpr int size = 64;

struct Codes {
    std::vector<std::uint32_t> texels;
    NormalMapCheck check() const { return check_normal_map(texels, size, size, size); }
};

/// The map of round bumps, eight on a side.
Codes bumps(bool green_down) {
    Codes c;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double a = 2 * pi * 8 * (x + 0.5) / size, b = 2 * pi * 8 * (y + 0.5) / size;
            const double p = 0.4 * std::cos(a) * std::sin(b), q = -0.4 * std::sin(a) * std::cos(b);  // q upwards
            const double n[3] = {-p, green_down ? q : -q, 1}, length = std::sqrt(p * p + q * q + 1);
            std::uint32_t t = 0xff000000u;
            for (int k = 0; k < 3; ++k) t |= std::uint32_t(std::lround((n[k] / length * 0.5 + 0.5) * 255)) << (8 * k);
            c.texels.push_back(t);
        }
    return c;
}

}  // namespace

TEST(NormalMapCheck, GreenUpAndGreenDownAreToldApart) {
    EXPECT_TRUE(bumps(true).check().green.is_down());
    EXPECT_FALSE(bumps(true).check().green.is_up());
    EXPECT_TRUE(bumps(false).check().green.is_up());
    EXPECT_FALSE(bumps(false).check().green.is_down());
}

TEST(NormalMapCheck, TexelsThatPointIntoTheSurfaceAreCounted) {
    Codes c = bumps(false);
    for (const std::size_t i : {0u, 70u, 4095u}) c.texels[i] = (c.texels[i] & 0xff00ffffu) | 127u << 16;
    c.texels[5] = (c.texels[5] & 0xff00ffffu) | 128u << 16;  // barely out of it
    EXPECT_EQ(c.check().below, 3u);
    EXPECT_EQ(c.check().texels, 4096u);
}

TEST(NormalMapCheck, CodesThatWereSavedAsSrgbAreSeen) {
    Codes c = bumps(false);
    EXPECT_FALSE(c.check().looks_srgb());
    for (std::uint32_t& t : c.texels) {
        std::uint32_t to = 0xff000000u;
        for (int k = 0; k < 3; ++k)
            to |= std::uint32_t(srgb8_from_linear(float(t >> (8 * k) & 255u) / 255.0f)) << (8 * k);
        t = to;
    }
    EXPECT_TRUE(c.check().looks_srgb());
}

TEST(NormalMapCheck, AGrayPictureLooksLikeHeightsAndNoNormalMapDoes) {
    Codes gray = bumps(false), flat = bumps(false);
    std::mt19937 random(3);
    for (std::uint32_t& t : gray.texels) {  // the red of bumps, each channel off by up to 1 as JPEG leaves it
        const std::uint32_t v = std::clamp(t & 255u, 1u, 254u);
        t = 0xff000000u | (v - random() % 2) | (v + random() % 2) << 8 | v << 16;
    }
    EXPECT_TRUE(gray.check().looks_like_heights());
    EXPECT_FALSE(gray.check().looks_like_normals());
    for (std::uint32_t& t : flat.texels) t = 0xffff8080u;
    EXPECT_FALSE(flat.check().looks_like_heights());
    EXPECT_FALSE(bumps(false).check().looks_like_heights());
}

TEST(NormalMapCheck, MapsTooSmallToSayAnythingSayNothing) {
    const std::vector<std::uint32_t> one{0xff8080ffu};
    EXPECT_EQ(check_normal_map(one, 1, 1, 1).texels, 0u);
    EXPECT_FALSE(check_normal_map(one, 1, 1, 1).looks_like_heights());
}
