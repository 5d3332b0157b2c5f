// SPDX-License-Identifier: Apache-2.0
#include "scene/materials/material_table.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace rakelight {
namespace {

TEST(MaterialTable, EachRoleHasItsNumberItsOwnNamesAndItsOwnPlaceInTheMaterial) {
    Material m;
    std::set<std::string> names, keys;
    std::set<const TextureUse*> places;
    for (const TextureRole& role : texture_roles()) {
        EXPECT_EQ(&role, &texture_roles()[std::size_t(role.number)]) << role.name;
        EXPECT_TRUE(names.insert(role.name).second) << role.name;
        EXPECT_TRUE(keys.insert(role.key).second) << role.key;
        EXPECT_TRUE(places.insert(&role.in(m)).second) << role.name;
        const Material& same = m;
        EXPECT_EQ(&role.in(same), &role.in(m)) << role.name;
        EXPECT_EQ((role.general != nullptr) + (role.classical != nullptr) + (role.metallic_roughness != nullptr), 1);
    }
    EXPECT_EQ(places.size(), std::size_t(texture_role_count));
}

TEST(MaterialTable, ATextureOfALayerThatIsNotThereIsSilenced) {
    Material m;
    const TextureRole& coat = texture_roles()[role_clearcoat_roughness];
    EXPECT_TRUE(coat.layer.silences(m));
    m.metallic_roughness.clearcoat = 0.5f;
    EXPECT_FALSE(coat.layer.silences(m));
    EXPECT_TRUE(coat.factor.silences(m));
    EXPECT_FALSE(texture_roles()[role_base_color].layer.silences(m));
    EXPECT_FALSE(texture_roles()[role_base_color].factor.silences(m));
}

TEST(MaterialTable, EachParameterHasOnePlaceAndDefaultsWithinItsRange) {
    const MetallicRoughnessParameters defaults;
    std::set<std::string> keys;
    for (const MaterialParameter& p : metallic_roughness_parameters()) {
        EXPECT_TRUE(keys.insert(p.key).second) << p.key;
        EXPECT_EQ((p.number != nullptr) + (p.color != nullptr), 1) << p.key;
        if (!p.number) continue;
        EXPECT_GE(double(defaults.*p.number), p.low) << p.key;
        EXPECT_LE(double(defaults.*p.number), p.high) << p.key;
    }
}

}  // namespace
}  // namespace rakelight
