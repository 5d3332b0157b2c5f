// SPDX-License-Identifier: Apache-2.0
// Oren-Nayar, Ward, GGX and its layers against their equations: a value table, limits, reciprocity, the horizon.
// Energy: furnace_test.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "lighting_items.h"

namespace rakelight::lighting_test {
namespace {

constexpr double pi_d = 3.14159265358979323846;

struct Row {
    float l[3], v[3], ax, ay, sigma, oren_nayar, ward_1992, ward_duer, ward_bounded, ggx, ggx_anisotropic, sheen;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all = {
#define RL_MATERIAL(lx, ly, lz, vx, vy, vz, ...) Row{{lx, ly, lz}, {vx, vy, vz}, __VA_ARGS__},
#include "material_values.inc"
#undef RL_MATERIAL
    };
    return all;
}

Item item_of(const Row& row) {
    Item item;
    item.l = {row.l[0], row.l[1], row.l[2]}, item.v = {row.v[0], row.v[1], row.v[2]};
    item.p = {1, 0, 0};
    item.ka = {row.ax, row.ay, 0};
    item.s = row.sigma, item.e = row.ax, item.t = row.ay;
    return item;
}

Items items_of_rows() {
    Items items;
    for (const Row& row : rows()) items.push(item_of(row));
    return items;
}

TEST(MaterialModels, GiveTheValuesOfTheTable) {
    ASSERT_GE(rows().size(), 100u);
    Items items = items_of_rows();
    const std::pair<const char*, float Row::*> columns[] = {{"oren_nayar_brdf", &Row::oren_nayar},
                                                            {"ward_1992_brdf", &Row::ward_1992},
                                                            {"ward_duer_brdf", &Row::ward_duer},
                                                            {"ward_bounded_brdf", &Row::ward_bounded},
                                                            {"ggx_brdf", &Row::ggx},
                                                            {"ggx_anisotropic_brdf", &Row::ggx_anisotropic},
                                                            {"sheen_brdf", &Row::sheen}};
    for (const auto& [operation, expected] : columns) {
        const Results r = run(scalar::kernel, operation, items);
        for (std::size_t i = 0; i < rows().size(); ++i) {
            // directions are rounded to float; narrow lobes are steep there
            const double value = double(rows()[i].*expected);
            EXPECT_NEAR(r[0][i], value, 2e-6 + 6e-5 * value) << operation << " row " << i;
        }
    }
}

TEST(MaterialModels, OrenNayarWithoutSlopesIsLambertToTheBit) {
    Items items;
    for (Row row : rows()) {
        row.ax = 0;  // sigma
        items.push(item_of(row));
    }
    const Results got = material(scalar::kernel, items, {oren_nayar});
    const Results expected = terms(scalar::kernel, items, {lambert, textbook, 1});
    for (std::size_t i = 0; i < items.size(); ++i) EXPECT_EQ(got[3][i], expected[3][i]) << i;
}

TEST(MaterialModels, OrenNayarIsFlatterThanLambertWithTheLightBehindTheViewer) {
    Items items;
    for (const float x : {0.0f, 0.5f, 0.9f, 0.99f}) {
        Item item;
        item.l = item.v = {x, 0, std::sqrt(1 - x * x)};
        item.s = 0.5f;
        items.push(item);
    }
    const Results r = run(scalar::kernel, "oren_nayar_brdf", items);
    EXPECT_LT(r[0][0], 1 / pi_d);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_GT(r[0][i], r[0][i - 1]) << i;
}

/// A turn about the normal of both directions, and so of what is anisotropic.
vec3 turned(vec3 d, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {float(c * double(d.x) - s * double(d.y)), float(s * double(d.x) + c * double(d.y)), d.z};
}

TEST(MaterialModels, EqualWidthsMakeWardAndGgxIsotropic) {
    Random random;
    Items straight, oblique;
    for (const Row& row : rows()) {
        Item item = item_of(row);
        item.ka.y = item.ka.x;
        straight.push(item);
        const double angle = double(random.within(-3, 3));
        item.l = turned(item.l, angle), item.v = turned(item.v, angle);
        oblique.push(item);
    }
    for (const char* operation : {"ward_1992_brdf", "ward_duer_brdf", "ward_bounded_brdf", "ggx_anisotropic_brdf"}) {
        const Results a = run(scalar::kernel, operation, straight), b = run(scalar::kernel, operation, oblique);
        for (std::size_t i = 0; i < straight.size(); ++i)
            EXPECT_NEAR(a[0][i], b[0][i], 2e-6 + 1e-4 * double(a[0][i])) << operation << " " << i;
    }
    const Results plain = run(scalar::kernel, "ggx_brdf", straight),
                  general = run(scalar::kernel, "ggx_anisotropic_brdf", straight);
    for (std::size_t i = 0; i < straight.size(); ++i)
        EXPECT_NEAR(plain[0][i], general[0][i], 2e-6 + 3e-5 * double(plain[0][i])) << i;
}

TEST(MaterialModels, AWideTangentStretchesTheHighlightAlongIt) {
    Items items;
    for (const vec3 v : {vec3{0.3f, 0, 0.953939f}, vec3{0, 0.3f, 0.953939f}}) {
        Item item;
        item.v = v, item.p = {1, 0, 0}, item.ka = {0.4f, 0.1f, 0};
        items.push(item);
    }
    for (const char* operation : {"ward_bounded_brdf", "ggx_anisotropic_brdf"}) {
        const Results r = run(scalar::kernel, operation, items);
        EXPECT_GT(r[0][0], 3 * r[0][1]) << operation;
    }
}

TEST(MaterialModels, AreReciprocal) {
    Items there = items_of_rows(), back;
    for (const Row& row : rows()) {
        Item item = item_of(row);
        std::swap(item.l, item.v);
        back.push(item);
    }
    for (const char* operation : {"oren_nayar_brdf", "ward_1992_brdf", "ward_duer_brdf", "ward_bounded_brdf",
                                  "ggx_brdf", "ggx_anisotropic_brdf", "sheen_brdf"}) {
        const Results a = run(scalar::kernel, operation, there), b = run(scalar::kernel, operation, back);
        for (std::size_t i = 0; i < there.size(); ++i)
            EXPECT_NEAR(a[0][i], b[0][i], 1e-6 + 2e-5 * double(a[0][i])) << operation << " " << i;
    }
}

TEST(MaterialModels, MetallicRoughnessWithCompensationIsReciprocal) {
    Random random;
    Items there, back;
    std::vector<double> cosine_l, cosine_v;
    for (int i = 0; i < 3000; ++i) {
        Item item;
        item.l = random.direction(), item.v = random.direction();
        item.l.z = std::fabs(item.l.z), item.v.z = std::fabs(item.v.z);
        if (item.l.z < 0.05f || item.v.z < 0.05f) continue;
        item.ks = random.color(), item.kd = random.color();
        item.ka = {random.unit(), random.unit(), 0.7f};  // albedos towards l, v, and the mean
        item.e = item.t = random.within(0.2f, 1);
        there.push(item);
        cosine_l.push_back(double(item.l.z)), cosine_v.push_back(double(item.v.z));
        std::swap(item.l, item.v), std::swap(item.ka.x, item.ka.y);
        back.push(item);
    }
    for (const MaterialChoice choice : {MaterialChoice{pbr}, MaterialChoice{pbr, 2, 1}, MaterialChoice{pbr, 2, 0, 1}}) {
        const Results a = material(scalar::kernel, there, choice), b = material(scalar::kernel, back, choice);
        for (std::size_t i = 0; i < cosine_l.size(); ++i)
            for (const std::size_t c : {3u, 6u}) {  // diffuse and specular: radiance over n.l
                const double f = double(a[c][i]) / cosine_l[i];
                ASSERT_NEAR(f, double(b[c][i]) / cosine_v[i], 1e-5 + 5e-5 * f) << c << " item " << i;
            }
    }
}

TEST(MaterialModels, LightBelowTheHorizonGivesNothing) {
    Random random;
    Items items;
    for (int i = 0; i < 4000; ++i) {
        Item item;
        item.l = random.direction(), item.v = random.direction();
        item.l.z = i % 10 == 0 ? 0.0f : -std::fabs(item.l.z);
        item.ka = {0.5f, 0.5f, 0.5f}, item.e = item.t = random.within(0.05f, 1), item.p = random.direction();
        items.push(item);
    }
    for (const MaterialChoice choice : all_materials) {
        const Results r = material(scalar::kernel, items, choice);
        for (std::size_t i = 0; i < items.size(); ++i)
            for (std::size_t c = 3; c < 9; ++c)
                ASSERT_EQ(r[c][i], 0.0f) << "model " << choice.model << " column " << c << " item " << i;
    }
}

TEST(MaterialModels, SchlickGoesFromNormalToGrazingReflectance) {
    Items items;
    for (const float c : {1.0f, 0.5f, 0.0f}) {
        Item item;
        item.s = c;
        items.push(item);
    }
    const Results r = run(scalar::kernel, "schlick_weight", items);
    EXPECT_EQ(r[0][0], 0.0f);
    EXPECT_EQ(r[0][1], 0.03125f);
    EXPECT_EQ(r[0][2], 1.0f);
}

TEST(MaterialModels, ADielectricReflectsFourPercentInItsMirrorAndDiffusesTheRest) {
    Items items;
    Item item;  // l = v = n: D V = 1 / (4 pi alpha^2), radiance pi times f0 times that
    item.ks = {0.04f, 0.04f, 0.04f}, item.kd = {0.5f, 0.25f, 1}, item.ka = {0.1f, 0.2f, 0.3f}, item.e = item.t = 0.5f;
    items.push(item);
    const Results r = material(scalar::kernel, items, {pbr});
    EXPECT_NEAR(r[6][0], 0.04 / (4 * 0.25), 1e-6);
    EXPECT_NEAR(r[3][0], 0.5 * 0.96, 1e-6);
    EXPECT_NEAR(r[4][0], 0.25 * 0.96, 1e-6);
    EXPECT_NEAR(r[2][0], 0.3, 1e-7);
}

TEST(MaterialModels, ACoatTakesWhatItReflectsFromTheMaterialBelow) {
    Items items;
    Item item;
    item.ks = {0.04f, 0.04f, 0.04f}, item.kd = {0.5f, 0.5f, 0.5f}, item.ka = {1, 0, 0}, item.e = 0.5f, item.t = 0.5f;
    items.push(item);
    const Results bare = material(scalar::kernel, items, {pbr}),
                  coated = material(scalar::kernel, items, {pbr, 2, 0, 0, 0, 1});
    EXPECT_NEAR(coated[3][0], 0.96f * bare[3][0], 1e-6);
    EXPECT_NEAR(coated[6][0], 0.96f * bare[6][0] + 0.04f / (4 * 0.25f), 1e-6);  // the coat's own lobe, as wide
}

TEST(MaterialModels, SheenDarkensTheMaterialBelowByItsAlbedo) {
    Items items;
    Item item;
    item.l = {0.6f, 0, 0.8f}, item.v = {-0.6f, 0, 0.8f};
    item.ks = {0.2f, 0.5f, 0}, item.kd = {1, 1, 1}, item.ka = {0.3f, 0.4f, 0}, item.e = item.t = 0.5f;
    items.push(item);
    const Results bare = material(scalar::kernel, items, {pbr}),
                  under = material(scalar::kernel, items, {pbr, 2, 0, 0, 1});
    EXPECT_NEAR(under[3][0], (1 - 0.5f * 0.4f) * bare[3][0], 1e-6);  // the greater albedo, the greatest component
}

}  // namespace
}  // namespace rakelight::lighting_test
