// SPDX-License-Identifier: Apache-2.0
// The isotropic GGX lobe and the metallic-roughness model against glTF 2.0, appendix B: a value table, energy with and
// without compensation, the tables of albedos, reciprocity.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/lighting/albedo_reads.h"
#include "unit/lighting/material_rows.h"

namespace rakelight::lighting_test {
namespace {

TEST(Ggx, GivesTheValuesOfTheTable) { expect_values_of_the_table("ggx_brdf", &MaterialRow::ggx); }

TEST(Ggx, IsReciprocal) { expect_reciprocal("ggx_brdf"); }

TEST(Ggx, MetallicRoughnessWithCompensationIsReciprocal) {
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

TEST(Ggx, SchlickGoesFromNormalToGrazingReflectance) {
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

TEST(Ggx, ADielectricReflectsFourPercentInItsMirrorAndDiffusesTheRest) {
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

TEST(Ggx, StaysWithinOneAndLosesLogTwoOfARoughSurface) {
    EXPECT_NEAR(ggx_albedo(0, 1), 1 - std::log(2.0), 1e-3);
    for (const double alpha : {0.01, 0.05, 0.2, 0.5, 1.0})
        for (const double angle : furnace_degrees)
            EXPECT_LE(ggx_albedo(angle, alpha), 1.002) << alpha << " at " << angle;
}

TEST(Ggx, TheTableHoldsTheAlbedoOfTheLobe) {
    for (const double roughness : {0.1, 0.33, 0.5, 0.71, 0.9, 1.0})
        for (const double angle : furnace_degrees)
            EXPECT_NEAR(lobe_from_table(beam(angle).z, roughness), ggx_albedo(angle, roughness * roughness), 0.005)
                << roughness << " at " << angle;
}

TEST(Ggx, WithCompensationReflectsAllWithinOnePercent) {
    const Outgoing rest = whole_hemisphere();
    for (const double roughness : {0.1, 0.25, 0.4, 0.6, 0.8, 1.0}) {
        const double mean_loss = loss_from_table(roughness);
        double lost = 0;  // integral of (1 - E(v)) cos v
        for (std::size_t i = 0; i < rest.v.size(); ++i)
            lost += (1 - lobe_from_table(rest.v[i].z, roughness)) * rest.v[i].z * rest.solid_angle[i];
        for (const double angle : furnace_degrees) {
            const double from_l = lobe_from_table(beam(angle).z, roughness);
            const double given_back = (1 - from_l) * lost / (pi_d * std::max(mean_loss, 1e-6));
            EXPECT_NEAR(ggx_albedo(angle, roughness * roughness) + given_back, 1, 0.01) << roughness << " at " << angle;
        }
    }
}

TEST(Ggx, TheTableOfSchlicksWeightSplitsTheAlbedo) {
    // lobe (f0 (1 - grazing) + f90 grazing) is what a surface of f0 0.04 reflects of white surroundings
    const lighting::AlbedoTables t = lighting::albedo_tables();
    for (const double roughness : {0.3, 0.6, 1.0})
        for (const double angle : {0.0, 45.0, 75.0, 88.0}) {
            const Direction l = beam(angle);
            const Outgoing out = about_the_mirror(l, roughness * roughness);
            Item like;
            like.ks = {0.04f, 0.04f, 0.04f}, like.e = like.t = float(roughness * roughness);
            Items items = items_of(l, out, like);
            const Results r = material(scalar::kernel, items, {pbr});
            double sum = 0;
            for (std::size_t i = 0; i < out.v.size(); ++i)
                sum += double(r[6][i]) / (pi_d * l.z) * out.v[i].z * out.solid_angle[i];
            const double lobe = lobe_from_table(l.z, roughness), grazing = from_table(t.grazing, l.z, roughness);
            EXPECT_NEAR(lobe * (0.04 * (1 - grazing) + grazing), sum, 0.004) << roughness << " at " << angle;
        }
}

}  // namespace
}  // namespace rakelight::lighting_test
