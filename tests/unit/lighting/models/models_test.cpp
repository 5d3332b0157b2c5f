// SPDX-License-Identifier: Apache-2.0
// What holds for every model: colors multiply their own term, whole powers, nothing from below the horizon, unlit.
// Each model has a test file of its own.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "unit/lighting/lighting_items.h"

namespace rakelight::lighting_test {
namespace {

TEST(Models, WholePowersAreThoseOfTheSameExponent) {
    Items items;
    for (int i = -8; i <= 4096; ++i) {
        Item item;
        item.s = float(i) / 4096;
        items.push(item);
    }
    for (const auto& [operation, n] :
         {std::pair{"whole_power_1", 1}, {"whole_power_48", 48}, {"whole_power_1023", 1023}}) {
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

TEST(Models, LightBelowTheHorizonGivesMaterialsNothing) {
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

TEST(Models, UnlitAddsEmissionToTheBaseColor) {
    Items items;
    Item item;
    item.kd = {0.5f, 0.25f, 1}, item.ks = {0, 1, 2};
    items.push(item);
    EXPECT_EQ(run(scalar::kernel, "unlit", items).vector(0, 0), (vec3{0.5f, 1.25f, 3}));
}

}  // namespace
}  // namespace rakelight::lighting_test
