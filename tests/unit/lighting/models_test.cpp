// SPDX-License-Identifier: Apache-2.0
// The models against their equations: a value table, energy, reciprocity, the horizon, known albedos.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lighting_items.h"

namespace rakelight::lighting_test {
namespace {

constexpr double pi_d = 3.14159265358979323846;

struct Row {
    float n[3], l[3], v[3], e, diffuse, specular[2][3];  ///< [Phong, Blinn-Phong][textbook, no horizon, normalized]
};

std::vector<Row> rows() {
    return {
#define RL_TERMS(nx, ny, nz, lx, ly, lz, vx, vy, vz, e, diffuse, p0, p1, p2, b0, b1, b2) \
    Row{{nx, ny, nz}, {lx, ly, lz}, {vx, vy, vz}, e, diffuse, {{p0, p1, p2}, {b0, b1, b2}}},
#define RL_ATTENUATION(c, l, q, d, expected)
#define RL_RANGE(d, r, expected)
#define RL_CONE(angle, inner, outer, expected)
#include "lighting_values.inc"
#undef RL_TERMS
#undef RL_ATTENUATION
#undef RL_RANGE
#undef RL_CONE
    };
}

vec3 vector(const float (&a)[3]) { return {a[0], a[1], a[2]}; }

TEST(Models, GiveTheValuesOfTheTable) {
    const auto table = rows();
    ASSERT_GE(table.size(), 100u);
    Items items;
    for (const Row& row : table) {
        Item item;
        item.n = vector(row.n), item.l = vector(row.l), item.v = vector(row.v), item.e = row.e;
        items.push(item);
    }
    const Choice columns[] = {{0, textbook, 1}, {0, textbook, 0}, {0, normalized, 1}};
    for (int model : {phong, blinn_phong})
        for (std::size_t c = 0; c < 3; ++c) {
            const Results results = terms(scalar::kernel, items, {model, columns[c].form, columns[c].horizon});
            for (std::size_t i = 0; i < table.size(); ++i) {
                const float expected = table[i].specular[model - 1][c];
                // directions are rounded to float: with exponent e the lobe moves by about e 2^-24 of itself
                EXPECT_NEAR(results[6][i], expected, 1e-6 + expected * (1e-6 + double(table[i].e) * 3e-7))
                    << "model " << model << " column " << c << " row " << i;
                EXPECT_NEAR(results[3][i], table[i].diffuse, 1e-6) << i;
                EXPECT_EQ(results[0][i], 1.0f);
            }
        }
}

TEST(Models, WholePowersAreThoseOfTheSameExponent) {
    Items items;
    for (int i = -8; i <= 4096; ++i) {
        Item item;
        item.s = float(i) / 4096;
        items.push(item);
    }
    for (const auto& [operation, n] : {std::pair{"whole_power_1", 1}, {"whole_power_48", 48}, {"whole_power_1023", 1023}}) {
        const Results results = run(scalar::kernel, operation, items);
        for (std::size_t i = 0; i < items.size(); ++i) {
            const double expected = i < 8 ? 0 : std::pow(double(int(i) - 8) / 4096, n);
            const double smallest = double(std::numeric_limits<float>::min());
            const double lost = expected < 1.01 * smallest ? smallest : 0;  // counts as 0
            EXPECT_NEAR(results[0][i], expected, expected * n * 0x1p-24 + 1.01 * lost) << operation << " of item " << i;
            EXPECT_TRUE(results[0][i] == 0 || results[0][i] >= float(smallest)) << operation << " of item " << i;
        }
    }
}

TEST(Models, AWholeExponentGivesTheLobeOfTheSameExponent) {
    Items items;
    for (const Row& row : rows()) {
        Item item;
        item.n = vector(row.n), item.l = vector(row.l), item.v = vector(row.v), item.e = 48;
        items.push(item);
    }
    for (int model : {phong, blinn_phong})
        for (int form : {textbook, normalized}) {
            const Results any = terms(scalar::kernel, items, {model, form, 1}),
                          whole = terms(scalar::kernel, items, {model, form, 1, 48});
            for (std::size_t i = 0; i < items.size(); ++i)
                EXPECT_NEAR(whole[6][i], any[6][i], 1e-30 + 9e-6 * double(any[6][i])) << model << " item " << i;
        }
}

TEST(Models, ColorsMultiplyTheirOwnTerm) {
    Items items;
    Item item;
    item.ka = {0.1f, 0.2f, 0.3f}, item.kd = {0.5f, 0.25f, 1}, item.ks = {0.2f, 0.4f, 0.8f}, item.e = 10;
    items.push(item);
    lighting::LightParameters light;
    light.kind = lighting::LightKind::directional;
    light.direction[2] = -1;
    light.ambient[0] = 2, light.diffuse[1] = 3, light.specular[2] = 0.5f;
    const Results r = terms(scalar::kernel, items, {blinn_phong, textbook, 1}, &light);
    EXPECT_EQ(r.vector(0, 0), (vec3{0.2f, 0, 0}));
    EXPECT_EQ(r.vector(3, 0), (vec3{0.5f, 0.75f, 1}));
    const vec3 specular = r.vector(6, 0);  // (n.h)^10, and n.h is 1 to 3e-7
    EXPECT_NEAR(specular.x, 0.2f, 2e-6f);
    EXPECT_NEAR(specular.y, 0.4f, 2e-6f);
    EXPECT_NEAR(specular.z, 0.4f, 2e-6f);
}

TEST(Models, AWhiteLambertSurfaceFacingAClassicalLightOfColorOneHasRadianceOne) {
    Items items;
    items.push({});
    const Results r = terms(scalar::kernel, items, {lambert, textbook, 1});
    EXPECT_EQ(r[3][0], 1.0f);
    EXPECT_EQ(r[6][0], 0.0f);
    EXPECT_NEAR(run(scalar::kernel, "lambert_brdf", items)[0][0], 1 / pi_d, 2e-8);
}

TEST(Models, PhotometricLightGivesRadianceOfBrdfTimesIrradiance) {
    Items items;
    Item item;
    item.p = {0, 0, 1};
    items.push(item);
    lighting::LightParameters light;
    light.kind = lighting::LightKind::point;
    light.is_photometric = true;
    light.position[2] = 3;  // 2 m away
    light.intensity[0] = 400;
    const Results r = terms(scalar::kernel, items, {lambert, textbook, 1}, &light);
    EXPECT_NEAR(r[3][0], 400 / 4.0 / pi_d, 1e-4);
    EXPECT_EQ(r[0][0], 0.0f);  // photometric lights have no ambient color
}

/// Midpoint rule over the hemisphere about +z: calls with direction and solid angle.
template <class Call>
void over_hemisphere(int rings, Call call) {
    const int sectors = 2 * rings;
    for (int i = 0; i < rings; ++i) {
        const double low = std::cos(pi_d / 2 * (i + 1) / rings), high = std::cos(pi_d / 2 * i / rings),
                     z = std::cos(pi_d / 2 * (i + 0.5) / rings);
        for (int j = 0; j < sectors; ++j) {
            const double phi = 2 * pi_d * (j + 0.5) / sectors, s = std::sqrt(1 - z * z);
            call(vec3{float(s * std::cos(phi)), float(s * std::sin(phi)), float(z)}, 2 * pi_d * (high - low) / sectors);
        }
    }
}

/// Share of the light from `l` that leaves: integral of the radiance over cos v, by irradiance pi cos l.
double albedo(int model, int form, float e, double angle_rad) {
    Items items;
    std::vector<double> weights;
    const vec3 l{float(std::sin(angle_rad)), 0, float(std::cos(angle_rad))};
    over_hemisphere(256, [&](vec3 v, double solid_angle) {
        Item item;
        item.l = l, item.v = v, item.e = e;
        items.push(item);
        weights.push_back(solid_angle * double(v.z));
    });
    const Results r = terms(scalar::kernel, items, {model, form, 1});
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += double(r[6][i]) * weights[i];
    return sum / (pi_d * std::cos(angle_rad));
}

TEST(Models, TextbookPhongHasTheKnownAlbedos) {
    // Exponent 1: (2/3) ((pi - t) cos t + sin t) / (pi cos t): 2/3 at normal incidence, 1.18 at 75 degrees: not energy
    // conserving.
    for (const double degrees_in : {0.0, 30.0, 60.0, 75.0}) {
        const double t = radians(degrees_in);
        const double expected = 2.0 / 3 * ((pi_d - t) * std::cos(t) + std::sin(t)) / (pi_d * std::cos(t));
        EXPECT_NEAR(albedo(phong, textbook, 1, t), expected, 2e-3) << degrees_in;
    }
    EXPECT_NEAR(albedo(phong, textbook, 1, 0), 0.667, 1e-3);
    EXPECT_NEAR(albedo(phong, textbook, 1, radians(75)), 1.18, 0.005);
}

TEST(Models, NormalizedFormsReflectAllAtNormalIncidenceAndNeverMoreThanAll) {
    for (const int model : {phong, blinn_phong})
        for (const float e : {1.0f, 4.0f, 20.0f, 100.0f}) {
            EXPECT_NEAR(albedo(model, normalized, e, 0), 1, 3e-3) << model << " exponent " << e;
            for (const double degrees_in : {15.0, 40.0, 65.0, 80.0, 88.0})
                EXPECT_LE(albedo(model, normalized, e, radians(degrees_in)), 1.003)
                    << model << " exponent " << e << " at " << degrees_in;
        }
}

TEST(Models, NormalizedFormsAreReciprocal) {
    Random random;
    Items there, back;
    std::vector<float> n_dot_l, n_dot_v;
    for (int i = 0; i < 5000; ++i) {
        Item item;
        item.l = random.direction(), item.v = random.direction(), item.e = random.within(1, 60);
        if (item.l.z < 0.02f || item.v.z < 0.02f) continue;
        there.push(item);
        std::swap(item.l, item.v);
        back.push(item);
        n_dot_l.push_back(item.v.z), n_dot_v.push_back(item.l.z);
    }
    ASSERT_GT(n_dot_l.size(), 1000u);
    for (const int model : {phong, blinn_phong}) {
        const Results a = terms(scalar::kernel, there, {model, normalized, 1}),
                      b = terms(scalar::kernel, back, {model, normalized, 1});
        for (std::size_t i = 0; i < n_dot_l.size(); ++i) {
            const double f_there = double(a[6][i]) / double(n_dot_l[i]), f_back = double(b[6][i]) / double(n_dot_v[i]);
            ASSERT_NEAR(f_there, f_back, 1e-6 + 2e-5 * f_there) << model << " " << i;
        }
    }
}

TEST(Models, LightBelowTheHorizonGivesNothingUnlessThePrintIsAskedFor) {
    Random random;
    Items items;
    for (int i = 0; i < 4000; ++i) {
        Item item;
        item.l = random.direction(), item.v = random.direction(), item.e = random.within(1, 10);
        item.l.z = i % 10 == 0 ? 0.0f : -std::fabs(item.l.z);
        items.push(item);
    }
    for (const Choice choice : all_choices) {
        const Results r = terms(scalar::kernel, items, choice);
        bool any_specular = false;
        for (std::size_t i = 0; i < items.size(); ++i) {
            ASSERT_EQ(r[3][i], 0.0f) << i;
            any_specular |= r[6][i] != 0.0f;
        }
        EXPECT_EQ(any_specular, choice.form == textbook && choice.horizon == 0)
            << "model " << choice.model << " form " << choice.form;
    }
}

TEST(Models, OppositeLightAndViewerHaveNoHalfwayDirection) {
    Items items;
    Item item;
    item.n = {0, 0, 1}, item.l = {1, 0, 0}, item.v = {-1, 0, 0};
    items.push(item);
    EXPECT_EQ(run(scalar::kernel, "blinn_phong_n_dot_h", items)[0][0], 0.0f);
}

TEST(Models, UnlitAddsEmissionToTheBaseColor) {
    Items items;
    Item item;
    item.kd = {0.5f, 0.25f, 1}, item.ks = {0, 1, 2};
    items.push(item);
    EXPECT_EQ(run(scalar::kernel, "unlit", items).vector(0, 0), (vec3{0.5f, 1.25f, 3}));
}

}  // namespace
}  // namespace rakelight::lighting_test
