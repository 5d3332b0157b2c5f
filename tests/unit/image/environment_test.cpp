// SPDX-License-Identifier: Apache-2.0
#include "image/maps/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <random>

#include "math/linear.h"

namespace rakelight {
namespace {

/// An equirectangular picture of a function of the direction.
MipChain panorama_of(const std::function<vec3(dvec3)>& light, int height = 128) {
    Pixels p{.width = 2 * height, .height = height, .channels = 3, .component = Component::f32, .is_linear = true};
    p.bytes.resize(p.row_bytes() * std::size_t(p.height));
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const vec3 c = light(equirectangular_direction((x + 0.5) / p.width, (y + 0.5) / p.height));
            std::memcpy(p.row(y) + std::size_t(x) * sizeof c, &c, sizeof c);
        }
    Context context;
    return make_mip_chain(p, ColorSpace::linear, context);
}

std::vector<dvec3> directions(int count) {
    std::mt19937 random(7);
    std::normal_distribution<double> any;
    std::vector<dvec3> out;
    while (int(out.size()) < count)
        out.push_back(normalize_or(dvec3{any(random), any(random), any(random)}, {0, 1, 0}));
    for (const double s : {1.0, -1.0}) out.insert(out.end(), {{s, 0, 0}, {0, s, 0}, {0, 0, s}});
    return out;
}

vec3 look_up(const OctahedralMap& map, dvec3 d) {  // the nearest texel
    const dvec2 uv = octahedral(d);
    return map.at(std::min(int(uv.x * map.size), map.size - 1), std::min(int(uv.y * map.size), map.size - 1));
}

TEST(Environment, DirectionsGoToBothKindsOfPicturesAndBack) {
    for (const dvec3 d : directions(2000)) {
        const dvec2 o = octahedral(d), e = equirectangular(d);
        EXPECT_LT(length(octahedral_direction(o.x, o.y) - d), 1e-12);
        EXPECT_LT(length(equirectangular_direction(e.x, e.y) - d), 1e-7);  // acos beside the poles
    }
    EXPECT_NEAR(equirectangular({0, 0, -1}).x, 0.5, 1e-12);  // the middle column lies along -Z
    EXPECT_NEAR(equirectangular({1, 0, 0}).x, 0.75, 1e-12);  // +X to the right of it
    EXPECT_NEAR(equirectangular({0, 1, 0}).y, 0.0, 1e-12);   // up is row 0
}

TEST(Environment, BordersOfOctahedralMapsGoOnAsTheSphereDoes) {
    OctahedralMap map{16, {}};
    for (int i = 0; i < 256; ++i) {
        const dvec3 d = octahedral_direction((i % 16 + 0.5) / 16, (i / 16 + 0.5) / 16);
        map.texels.push_back({float(d.x), float(d.y), float(d.z)});
    }
    for (int i = -1; i <= 16; ++i)
        for (const auto& [x, y] : {std::pair{-1, i}, std::pair{16, i}, std::pair{i, -1}, std::pair{i, 16}}) {
            const vec3 border = bordered_texel(map, x, y);
            const vec3 inside = map.at(std::clamp(x, 0, 15), std::clamp(y, 0, 15));
            EXPECT_LT(length(border - inside), 0.3f) << x << ' ' << y;  // neighbors on the sphere
            EXPECT_GT(length(border - inside), 0.0f) << x << ' ' << y;  // and not the edge again
        }
}

TEST(Environment, EvenLightStaysEvenInAllThatIsMadeOfIt) {
    Context context;
    const EnvironmentLight light = make_environment_light(panorama_of([](dvec3) { return vec3{1, 2, 0.5f}; }), context);
    ASSERT_EQ(light.mirrored.size(), std::size_t(environment_levels));
    for (const dvec3 d : directions(50)) {
        const vec3 e = irradiance_over_pi(light, cast<float>(d));
        EXPECT_NEAR(e.x, 1, 2e-4);
        EXPECT_NEAR(e.y, 2, 4e-4);
        for (const OctahedralMap& map : light.mirrored) {
            EXPECT_NEAR(look_up(map, d).x, 1, 1e-5);
            EXPECT_NEAR(look_up(map, d).z, 0.5, 1e-5);
        }
    }
}

/// Radiance 1 + a.d: irradiance / pi is 1 + 2/3 a.n exactly (the integral of d over the cosine-weighted half sphere is
/// 2 pi / 3 n), and the mirrored light of a lobe about n is 1 + a.n times the lobe's mean cosine.
TEST(Environment, LightThatGrowsLinearlyGivesItsClosedForm) {
    Context context;
    const dvec3 a{0.3, 0.5, -0.2};
    const auto radiance = [&](dvec3 d) {
        const float v = float(1 + dot(a, d));
        return vec3{v, v, v};
    };
    const EnvironmentLight light = make_environment_light(panorama_of(radiance), context);
    for (const dvec3 d : directions(100)) {
        EXPECT_NEAR(irradiance_over_pi(light, cast<float>(d)).x, 1 + 2.0 / 3 * dot(a, d), 5e-4);
        EXPECT_NEAR(look_up(light.mirrored[0], d).x, 1 + dot(a, d), 0.02);
    }
}

/// A polynomial of degree 2 is in the band: quadratic irradiance is 1/4 of the harmonic of order 2.
TEST(Environment, QuadraticLightIsInTheBandOfTheHarmonics) {
    Context context;
    const EnvironmentLight light = make_environment_light(
        panorama_of([](dvec3 d) {
            return vec3{float(2 + 3 * d.z * d.z - 1), float(2 + d.x * d.y), float(2 + d.x * d.x - d.y * d.y)};
        }),
        context);
    for (const dvec3 d : directions(100)) {
        const vec3 e = irradiance_over_pi(light, cast<float>(d));
        EXPECT_NEAR(e.x, 2 + 0.25 * (3 * d.z * d.z - 1), 2e-3);
        EXPECT_NEAR(e.y, 2 + 0.25 * d.x * d.y, 2e-3);
        EXPECT_NEAR(e.z, 2 + 0.25 * (d.x * d.x - d.y * d.y), 2e-3);
    }
}

/// The mean that level l claims to hold, by brute force: all directions of a fine grid, each by its weight D(h) n.l / 4
/// (as many half vectors fall there).
double mirrored_by_brute_force(const std::function<double(dvec3)>& light, dvec3 n, double roughness) {
    const double alpha2 = std::pow(roughness, 4);
    double sum = 0, weights = 0;
    constexpr int rows = 256;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 2 * rows; ++x) {
            const dvec3 l = equirectangular_direction((x + 0.5) / (2 * rows), (y + 0.5) / rows);
            const double n_dot_l = dot(n, l);
            if (n_dot_l <= 0) continue;
            const dvec3 h = normalize_or(n + l, n);
            const double cos2 = dot(n, h) * dot(n, h), base = cos2 * (alpha2 - 1) + 1;
            const double weight = alpha2 / (base * base) * n_dot_l * std::sin(pi * (y + 0.5) / rows);
            sum += light(l) * weight;
            weights += weight;
        }
    return sum / weights;
}

TEST(Environment, MirroredLightIsTheMeanOverTheLobeWithinAPercentOfTheBrightest) {
    Context context;
    const auto light = [](dvec3 d) { return 0.2 + (d.y > 0.6 ? 2.0 : 0.0) + (d.x > 0.3 && d.z < 0 ? 1.0 : 0.0); };
    const EnvironmentLight made = make_environment_light(panorama_of(
                                                             [&](dvec3 d) {
                                                                 const float v = float(light(d));
                                                                 return vec3{v, v, v};
                                                             },
                                                             512),
                                                         context);
    for (std::size_t level = 2; level < made.mirrored.size(); ++level) {
        const double roughness = double(level) / (environment_levels - 1);
        for (const dvec3 d : directions(3)) {
            const OctahedralMap& map = made.mirrored[level];
            const dvec2 uv = octahedral(d);  // at the texel's own middle
            const int x = std::min(int(uv.x * map.size), map.size - 1),
                      y = std::min(int(uv.y * map.size), map.size - 1);
            const dvec3 middle = octahedral_direction((x + 0.5) / map.size, (y + 0.5) / map.size);
            EXPECT_NEAR(map.at(x, y).x, mirrored_by_brute_force(light, middle, roughness), 0.032) << level;
        }
    }
}

TEST(Environment, IsTheSameToTheBitForAnyNumberOfThreads) {
    Context one({.threads = 1}), four({.threads = 4});
    const MipChain chain = panorama_of([](dvec3 d) {
        return vec3{float(1 + d.x), float(std::abs(d.y)), float(d.z * d.z * 5)};
    });
    const EnvironmentLight a = make_environment_light(chain, one), b = make_environment_light(chain, four);
    EXPECT_EQ(a.irradiance, b.irradiance);
    for (std::size_t l = 0; l < a.mirrored.size(); ++l) EXPECT_TRUE(a.mirrored[l].texels == b.mirrored[l].texels) << l;
}

TEST(Environment, TheStudioIsNeutralAndLightsAWhiteSurfaceThatFacesItsKeyLightByAboutOne) {
    for (const dvec3 d : directions(5000)) {
        ASSERT_GT(studio_radiance(d), 0.05);
        ASSERT_LT(studio_radiance(d), 6);
    }
    Context context;
    const EnvironmentLight light =
        make_environment_light(make_mip_chain(studio_panorama(), ColorSpace::linear, context), context);
    double brightest = 0;
    dvec3 where{};
    for (const dvec3 d : directions(2000)) {
        const vec3 e = irradiance_over_pi(light, cast<float>(d));
        EXPECT_EQ(e.x, e.y);
        EXPECT_EQ(e.x, e.z);
        if (double(e.x) > brightest) brightest = double(e.x), where = d;
    }
    EXPECT_NEAR(brightest, 1, 0.1);
    EXPECT_LT(where.x, 0);  // upper left in front
    EXPECT_GT(where.y, 0);
    EXPECT_GT(where.z, 0);
}

}  // namespace
}  // namespace rakelight
