// SPDX-License-Identifier: Apache-2.0
// Attenuation, spots and normal maps against closed forms.
#include <gtest/gtest.h>

#include <limits>

#include "math/functions.h"
#include "unit/lighting/lighting_items.h"

namespace rakelight::lighting_test {
namespace {

using lighting::LightKind;
using lighting::LightParameters;

struct Attenuation {
    float constant, linear, quadratic, distance, expected;
};
struct Range {
    float distance, range, expected;
};
struct Cone {
    float angle, inner, outer, expected;
};

#define RL_TERMS(...)
#define RL_ATTENUATION(c, l, q, d, expected) Attenuation{c, l, q, d, expected},
#define RL_RANGE(d, r, expected)
#define RL_CONE(angle, inner, outer, expected)
const std::vector<Attenuation> attenuations = {
#include "unit/lighting/lighting_values.inc"
};
#undef RL_ATTENUATION
#undef RL_RANGE
#define RL_ATTENUATION(...)
#define RL_RANGE(d, r, expected) Range{d, r, expected},
const std::vector<Range> ranges = {
#include "unit/lighting/lighting_values.inc"
};
#undef RL_RANGE
#undef RL_CONE
#define RL_RANGE(...)
#define RL_CONE(angle, inner, outer, expected) Cone{angle, inner, outer, expected},
const std::vector<Cone> cones = {
#include "unit/lighting/lighting_values.inc"
};

float cos_degrees(double angle) { return float(math::cos(radians(angle))); }

/// The terms that one light gives to a white Lambert surface that faces it.
Results all_terms(const LightParameters& light, vec3 position = {0, 0, 0}) {
    Items items;
    Item item;
    item.p = position;
    const vec3 to_light = vec3{light.position[0], light.position[1], light.position[2]} - position;
    item.n = normalize_or(to_light, vec3{0, 0, 1});
    items.push(item);
    return terms(scalar::kernel, items, {lambert, textbook, 1}, &light);
}
/// The light's attenuated color.
vec3 diffuse_of(const LightParameters& light, vec3 position = {0, 0, 0}) {
    return all_terms(light, position).vector(3, 0);
}

TEST(Lights, ClassicalAttenuationGivesTheValuesOfTheTable) {
    ASSERT_EQ(attenuations.size(), 5u);
    for (const Attenuation& row : attenuations) {
        LightParameters light;
        light.position[2] = row.distance;
        light.constant_term = row.constant, light.linear_term = row.linear, light.quadratic_term = row.quadratic;
        for (float& c : light.ambient) c = 1;
        EXPECT_FLOAT_EQ(all_terms(light).vector(0, 0).x, row.expected) << row.distance;
        EXPECT_FLOAT_EQ(diffuse_of(light).x, row.distance > 0 ? row.expected : 0) << row.distance;
    }
}

TEST(Lights, AtTheLightItselfOnlyAmbientLightArrives) {
    LightParameters light;
    light.ambient[0] = 0.5f;
    const Results at_it = all_terms(light);
    EXPECT_EQ(at_it.vector(0, 0), (vec3{0.5f, 0, 0}));
    EXPECT_EQ(at_it.vector(3, 0), (vec3{0, 0, 0}));
    EXPECT_EQ(at_it.vector(6, 0), (vec3{0, 0, 0}));
}

TEST(Lights, AttenuationOfAllZerosOrAtNoDistanceIsFinite) {
    LightParameters light;
    light.constant_term = 0, light.quadratic_term = 1;
    EXPECT_TRUE(std::isfinite(diffuse_of(light).x));
    light.quadratic_term = 0;
    light.position[2] = 1;
    EXPECT_TRUE(std::isfinite(diffuse_of(light).x));
    light.position[2] = 3e38f;
    EXPECT_TRUE(std::isfinite(diffuse_of(light).x));
}

TEST(Lights, PhotometricRangeGivesTheValuesOfTheTable) {
    ASSERT_EQ(ranges.size(), 5u);
    for (const Range& row : ranges) {
        LightParameters light;
        light.is_photometric = true;
        light.position[2] = row.distance;
        light.intensity[0] = 3.14159265f;
        light.inverse_range = row.range == 0 ? 0 : 1 / row.range;
        EXPECT_NEAR(diffuse_of(light).x, row.expected, 1e-7) << row.distance;
    }
}

/// Beside what the distance takes: the table's factors are the window over the square of the distance.
TEST(Lights, ClassicalRangeGivesTheWindowOfTheTable) {
    ASSERT_EQ(ranges.size(), 5u);
    for (const LightKind kind : {LightKind::point, LightKind::spot})
        for (const Range& row : ranges) {
            LightParameters light;
            light.kind = kind;
            light.position[2] = row.distance;
            light.cos_cutoff = 0.5f, light.exponent = 0;
            light.constant_term = 2;
            light.ambient[0] = 1;
            light.inverse_range = row.range == 0 ? 0 : 1 / row.range;
            const float window = row.expected * row.distance * row.distance;
            EXPECT_NEAR(diffuse_of(light).x, window / 2, 1e-6) << row.distance << " of " << row.range;
            EXPECT_NEAR(all_terms(light).vector(0, 0).x, window / 2, 1e-6) << "of ambient light";
        }
}

TEST(Lights, TheClassicalRangeIsASphereAboutTheLight) {
    LightParameters light;
    light.position[0] = 3, light.position[1] = -1, light.position[2] = 2;
    light.inverse_range = 1 / 2.5f;
    for (const vec3 from : {vec3{1, 0, 0}, vec3{0, -1, 0}, vec3{0, 0.6f, 0.8f}})
        for (const float distance : {0.0f, 1.0f, 2.4f, 2.5f, 2.6f, 1e20f}) {
            const vec3 p = vec3{3, -1, 2} + from * distance;
            const double ratio = std::min(double(distance), 100.0) / 2.5;
            light.ambient[0] = 1;
            EXPECT_NEAR(all_terms(light, p).vector(0, 0).x, std::max(0.0, 1 - std::pow(ratio, 4)), 2e-6) << distance;
        }
}

TEST(Lights, RangesDoNotEndLightFromAfar) {
    LightParameters light;
    light.inverse_range = 10;
    light.direction[2] = -1, light.position[2] = 5;
    light.kind = LightKind::directional;
    EXPECT_EQ(diffuse_of(light, {0, 0, -100}).x, 1.0f);
    light.kind = LightKind::ambient;
    light.ambient[0] = 0.5f;
    EXPECT_EQ(all_terms(light, {0, 0, -100}).vector(0, 0).x, 0.5f);
}

TEST(Lights, PhotometricConeGivesTheValuesOfTheTable) {
    ASSERT_EQ(cones.size(), 7u);
    for (const Cone& row : cones) {
        LightParameters light;
        light.kind = LightKind::spot;
        light.is_photometric = true;
        light.position[0] = float(math::sin(radians(row.angle))),
        light.position[2] = cos_degrees(row.angle);  // shines down, 1 m away
        light.intensity[0] = 3.14159265f;
        set_cone(light, cos_degrees(row.inner), cos_degrees(row.outer));
        EXPECT_NEAR(diffuse_of(light).x, row.expected, 3e-6) << row.angle;
    }
}

TEST(Lights, PhotometricConeOfNoWidthIsSteepAndFinite) {
    LightParameters light;
    set_cone(light, 0.5f, 0.5f);
    EXPECT_FLOAT_EQ(light.cone_scale, 1000);
    EXPECT_FLOAT_EQ(light.cone_offset, -500);
}

TEST(Lights, ClassicalSpotFallsByThePowerOfTheCosineAndEndsAtTheCutoff) {
    for (const double angle : {0.0, 10.0, 29.9, 30.1, 60.0, 120.0, 180.0}) {
        LightParameters light;
        light.kind = LightKind::spot;
        light.position[0] = float(math::sin(radians(angle))), light.position[2] = cos_degrees(angle);
        light.cos_cutoff = cos_degrees(30), light.exponent = 4;
        const double expected = angle <= 30 ? std::pow(std::cos(radians(angle)), 4) : 0;
        EXPECT_NEAR(diffuse_of(light).x, expected, 2e-6) << angle;
    }
}

TEST(Lights, SpotWithoutExponentIsEvenInsideItsCone) {
    LightParameters light;
    light.kind = LightKind::spot;
    light.position[0] = 0.6f, light.position[2] = 0.8f;
    light.cos_cutoff = 0.5f, light.exponent = 0;
    EXPECT_EQ(diffuse_of(light).x, 1.0f);
}

TEST(Lights, DirectionalLightHasNoAttenuation) {
    LightParameters light;
    light.kind = LightKind::directional;
    light.constant_term = 100;
    light.position[2] = 1;
    EXPECT_EQ(diffuse_of(light, {0, 0, -1e6f}).x, 1.0f);
}

TEST(Lights, AmbientLightGivesItsAmbientColorAlone) {
    Items items;
    items.push({});
    LightParameters light;
    light.kind = LightKind::ambient;
    light.ambient[1] = 0.25f;
    const Results r = terms(scalar::kernel, items, {blinn_phong, textbook, 0}, &light);
    EXPECT_EQ(r.vector(0, 0), (vec3{0, 0.25f, 0}));
    EXPECT_EQ(r.vector(3, 0), (vec3{0, 0, 0}));
    EXPECT_EQ(r.vector(6, 0), (vec3{0, 0, 0}));
}

TEST(Lights, SumAddsEveryLightInOrder) {
    Random random;
    const auto lights = one_light_of_each_kind();
    Items items;
    Item item;
    item.n = random.direction(), item.v = random.direction(), item.p = random.vector(1), item.e = 8;
    items.push(item);
    const Inputs in = items.inputs();
    Results total(3, in.count);
    scalar::kernel.sum(in, lights.data(), int(lights.size()), {blinn_phong, textbook, 1}, total.out());
    float expected = 0;
    for (const auto& light : lights) {
        const Results r = terms(scalar::kernel, items, {blinn_phong, textbook, 1}, &light);
        expected = expected + (r[0][0] + r[3][0] + r[6][0]);
    }
    EXPECT_EQ(total[0][0], expected);
}

vec3 perturbed(vec3 n, vec3 t, float w, vec3 m) {
    Items items;
    Item item;
    item.n = n, item.v = t, item.s = w, item.p = m;
    items.push(item);
    return run(scalar::kernel, "perturb_normal", items).vector(0, 0);
}

TEST(NormalMap, FlatTexelKeepsTheNormalAndRedLeansToTheTangent) {
    const vec3 flat = perturbed({0, 0, 1}, {1, 0, 0}, 1, {0, 0, 1});
    EXPECT_EQ(flat.x, 0);
    EXPECT_EQ(flat.y, 0);
    EXPECT_FLOAT_EQ(flat.z, 1);
    const vec3 red = perturbed({0, 0, 1}, {1, 0, 0}, 1, {0.6f, 0, 0.8f});
    EXPECT_FLOAT_EQ(red.x, 0.6f);
    EXPECT_FLOAT_EQ(red.z, 0.8f);
}

TEST(NormalMap, GreenLeansToTheBitangentAndTurnsWithTheHandedness) {
    // cross(z, x) = y
    EXPECT_FLOAT_EQ(perturbed({0, 0, 1}, {1, 0, 0}, 1, {0, 0.6f, 0.8f}).y, 0.6f);
    EXPECT_FLOAT_EQ(perturbed({0, 0, 1}, {1, 0, 0}, -1, {0, 0.6f, 0.8f}).y, -0.6f);
}

TEST(NormalMap, TexelWithoutDirectionKeepsTheNormal) {
    EXPECT_EQ(perturbed({0, 1, 0}, {1, 0, 0}, 1, {0, 0, 0}), (vec3{0, 1, 0}));
    EXPECT_EQ(perturbed({0, 1, 0}, {1, 0, 0}, 1, {std::numeric_limits<float>::quiet_NaN(), 0, 0}), (vec3{0, 1, 0}));
}

vec3 decoded(const char* operation, vec3 texel, float scale) {
    Items items;
    Item item;
    item.kd = texel, item.s = scale;
    items.push(item);
    return run(scalar::kernel, operation, items).vector(0, 0);
}

TEST(NormalMap, DecodesBothReadingsOfAByte) {
    EXPECT_EQ(decoded("decode_normal", {1, 0, 1}, 0.5f), (vec3{0.5f, -0.5f, 1}));
    EXPECT_EQ(decoded("decode_normal", {0.5f, 0.5f, 1}, 1), (vec3{0, 0, 1}));
    EXPECT_EQ(decoded("decode_twice_normal", {2, 0.5f, 1.25f}, 1), decoded("decode_normal", {1, 0.25f, 0.625f}, 1));
    const vec3 centered = decoded("decode_normal_centered", {128 / 255.0f, 1, 1 / 255.0f}, 1);
    EXPECT_NEAR(centered.x, 0, 1e-6);
    EXPECT_NEAR(centered.y, 1, 1e-6);
    EXPECT_NEAR(centered.z, -1, 1e-6);
}

TEST(NormalMap, TangentsBecomePerpendicularWhateverTheyWere) {
    Random random;
    Items items;
    std::vector<vec3> normals;
    for (int i = 0; i < 4000; ++i) {
        Item item;
        item.n = i == 0 ? vec3{1, 0, 0} : i == 1 ? vec3{0, 1, 0} : i == 2 ? vec3{0, 0, -1} : random.direction();
        item.p = i % 5 == 0 ? item.n * 3.0f : i % 5 == 1 ? vec3{0, 0, 0} : random.vector(i % 5 == 2 ? 1e-6f : 5.0f);
        if (i % 7 == 0) item.p.x = std::numeric_limits<float>::quiet_NaN();
        normals.push_back(item.n);
        items.push(item);
    }
    const Results r = run(scalar::kernel, "orthogonal_tangent", items);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        ASSERT_NEAR(length(r.vector(0, i)), 1, 1e-6) << i;
        ASSERT_NEAR(dot(r.vector(0, i), normals[i]), 0, 1e-3) << i;
    }
}

}  // namespace
}  // namespace rakelight::lighting_test
