// SPDX-License-Identifier: Apache-2.0
#include "shading/choices.h"

#include <gtest/gtest.h>

#include "shading/shading_choice.h"

namespace rakelight::shading {
namespace {

TEST(Choices, AMaterialsOwnLightingComesBeforeThePicturesAndAutomaticGoesByItsKind) {
    Material m;
    EXPECT_EQ(lighting_of(m, Lighting::automatic), Lighting::pbr);
    m.model = MaterialModel::classical;
    EXPECT_EQ(lighting_of(m, Lighting::automatic), Lighting::blinn_phong);
    EXPECT_EQ(lighting_of(m, Lighting::ward), Lighting::ward);
    m.lighting = Lighting::lambert;
    EXPECT_EQ(lighting_of(m, Lighting::ward), Lighting::lambert);
}

TEST(Choices, ReliefTechniquesAreThoseThatReadHeights) {
    EXPECT_EQ(relief_technique(Bump::height), relief_height);
    EXPECT_EQ(relief_technique(Bump::parallax), relief_parallax);
    EXPECT_EQ(relief_technique(Bump::parallax_limited), relief_limited);
    EXPECT_EQ(relief_technique(Bump::steep), relief_steep);
    EXPECT_EQ(relief_technique(Bump::occlusion), relief_occlusion);
    for (const Bump bump : {Bump::none, Bump::normal, Bump::displacement})
        EXPECT_EQ(relief_technique(bump), relief_none);
}

TEST(Choices, BackFacesAreLeftOutWhereAskedForAndOfSingleSidedMaterialsByThemselves) {
    Material m;
    EXPECT_FALSE(is_two_sided(m));
    m.double_sided = true;
    EXPECT_TRUE(is_two_sided(m));
    m = {};
    m.model = MaterialModel::classical;
    EXPECT_TRUE(is_two_sided(m));
    EXPECT_TRUE(culled_sides(Cull::automatic, false).back);
    EXPECT_FALSE(culled_sides(Cull::automatic, true).back);
    EXPECT_TRUE(culled_sides(Cull::back, true).back);
    EXPECT_FALSE(culled_sides(Cull::none, false).back);
    EXPECT_TRUE(culled_sides(Cull::front, false).front);
    EXPECT_FALSE(culled_sides(Cull::front, false).back);
}

TEST(ShadingChoice, TheLastRuleThatFitsRulesThenTheMaterialThenTheNode) {
    Scene scene;
    scene.nodes.resize(2);
    scene.nodes[0].name = "top";
    scene.nodes[0].shading = Shading::flat;
    scene.nodes[1].parent = 0;
    scene.materials.resize(1);
    scene.materials[0].name = "paint";
    RenderSettings settings;
    settings.material_shading = true;
    EXPECT_EQ(ShadingChoice(scene, settings).of(1, no_index), Shading::flat);  // of the node above
    scene.materials[0].shading = Shading::gouraud;
    EXPECT_EQ(ShadingChoice(scene, settings).of(1, 0), Shading::gouraud);
    settings.shading_rules = {{ShadingRule::Of::material, "paint", Shading::unlit},
                              {ShadingRule::Of::object, "top", Shading::phong}};
    EXPECT_EQ(ShadingChoice(scene, settings).of(1, 0), Shading::phong);  // the later one, and what hangs from it
    settings.shading_rules.pop_back();
    EXPECT_EQ(ShadingChoice(scene, settings).of(1, 0), Shading::unlit);
    settings.shading_rules.clear();
    settings.material_shading = false;
    EXPECT_TRUE(ShadingChoice(scene, settings).is_all_alike());
    EXPECT_EQ(ShadingChoice(scene, settings).of(1, 0), settings.shading);
}

}  // namespace
}  // namespace rakelight::shading
