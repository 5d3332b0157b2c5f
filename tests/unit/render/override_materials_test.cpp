// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/render/picture.h>

#include "support/scene_builder.h"
#include "support/shared.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {
std::string bricks() { return (source_dir() / "data/bricks/normal.png").string(); }
}  // namespace

TEST(OverrideMaterials, NothingAskedForSharesEverything) {
    Scene scene;
    add_object(scene, square_mesh());
    Context context;
    const Scene same = override_materials(scene, {}, context);
    EXPECT_TRUE(same.materials.empty());
    EXPECT_EQ(same.meshes[0].positions, scene.meshes[0].positions);
}

TEST(OverrideMaterials, EveryMaterialGetsThePictureAlsoTheDefaultOne) {
    Scene scene;
    scene.materials.push_back(matte());
    add_object(scene, square_mesh(0));
    add_object(scene, square_mesh());
    Context context;
    const Scene changed =
        override_materials(scene, {.base_color = {}, .normal = bricks(), .normal_scale = 0.5}, context);
    ASSERT_EQ(changed.materials.size(), 2u);
    for (const Mesh& mesh : changed.meshes) {
        const Material& m = changed.materials[mesh.material];
        ASSERT_TRUE(m.normal_texture);
        EXPECT_EQ(changed.textures[m.normal_texture.texture].image->path, bricks());
        EXPECT_EQ(m.normal_scale, 0.5f);
        EXPECT_FALSE(m.base_color_texture);
    }
    EXPECT_TRUE(context.report().entries().empty());
}

TEST(OverrideMaterials, AFolderAndAFileThatIsNoPictureAreErrors) {
    Context context;
    const std::string folder = source_dir().string(), text = (source_dir() / "README.md").string();
    for (const auto& [path, code] : {std::pair{folder, ErrorCode::not_found}, std::pair{text, ErrorCode::bad_file}}) {
        try {
            override_materials(Scene{}, {.base_color = path}, context);
            FAIL() << path;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), code);
            EXPECT_EQ(e.file(), path);
            EXPECT_EQ(e.place(), "");
        }
    }
}

TEST(OverrideMaterials, APictureThatIsNotThereIsAnError) {
    Context context;
    try {
        override_materials(Scene{}, {.normal = "no/such.png"}, context);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::not_found);
        EXPECT_EQ(e.file(), "no/such.png");
    }
}

TEST(OverrideMaterials, FactorsGoToEveryMaterialAndRoughnessMakesClassicalOnesMetallicRoughness) {
    Scene scene;
    scene.materials.resize(2);
    scene.materials[0].model = MaterialModel::classical;
    scene.materials[0].classical.specular = {0.5f, 0.5f, 0.5f};
    scene.materials[1].alpha_mode = AlphaMode::mask;
    Context context;
    const Scene plain = override_materials(scene, {.color = vec3{0.1f, 0.2f, 0.3f}}, context);
    EXPECT_EQ(plain.materials[0].model, MaterialModel::classical);
    EXPECT_EQ(plain.materials[0].classical.ambient, (vec3{0.1f, 0.2f, 0.3f}));
    EXPECT_EQ(plain.materials[1].base_color, (vec4{0.1f, 0.2f, 0.3f, 1}));
    EXPECT_EQ(plain.materials[1].alpha_mode, AlphaMode::mask);
    const Scene rough = override_materials(scene, {.opacity = 0.25, .roughness = 0.5, .metallic = 1.0}, context);
    for (const Material& m : rough.materials) {
        EXPECT_EQ(m.model, MaterialModel::metallic_roughness);
        EXPECT_EQ(m.metallic_roughness.roughness, 0.5f);
        EXPECT_EQ(m.metallic_roughness.metallic, 1.0f);
        EXPECT_EQ(m.base_color.w, 0.25f);
        EXPECT_EQ(m.alpha_mode, AlphaMode::blend);
    }
}

TEST(OverrideMaterials, RoughnessGivesAClassicalMaterialWithoutHighlightThatOfAPlastic) {
    Scene scene;
    scene.materials.resize(2);
    for (Material& m : scene.materials) {
        m.model = MaterialModel::classical;
        m.base_color = {0.2f, 0.4f, 0.6f, 1};
    }
    scene.materials[0].classical.specular = {0, 0, 0};
    scene.materials[1].classical.specular = {0.01f, 0, 0};
    scene.materials[1].specular_form = SpecularForm::normalized;
    Context context;
    const Scene rough = override_materials(scene, {.roughness = 0.1}, context);
    const MetallicRoughnessParameters &made = rough.materials[0].metallic_roughness,
                                      &kept = rough.materials[1].metallic_roughness;
    EXPECT_EQ(rough.materials[0].model, MaterialModel::metallic_roughness);
    EXPECT_EQ(rough.materials[0].base_color, (vec4{0.2f, 0.4f, 0.6f, 1}));
    EXPECT_EQ(made.metallic, 0.0f);
    EXPECT_EQ(made.roughness, 0.1f);
    EXPECT_EQ(made.specular, 1.0f);
    EXPECT_EQ(made.specular_color, (vec3{1, 1, 1}));
    EXPECT_NEAR(kept.specular * kept.specular_color.x * 0.04f, 0.01f, 1e-6f);  // what the file says stays
    EXPECT_EQ(kept.specular_color.y, 0.0f);
    EXPECT_EQ(override_materials(scene, {.opacity = 0.5}, context).materials[0].model, MaterialModel::classical);
}

TEST(OverrideMaterials, AHeightMapAndTheReadingOfNormalMapsGoToEveryMaterial) {
    Scene scene;
    scene.materials.resize(2);
    scene.materials[1].height_scale = 0.01f;
    Context context;
    const Scene changed =
        override_materials(scene, {.height = bricks(), .green_down = true, .centered_normals = true}, context);
    for (const Material& m : changed.materials) {
        EXPECT_EQ(changed.textures.at(m.height_texture.texture).image->path, bricks());
        EXPECT_EQ(m.height_scale, 1.0f);
        EXPECT_TRUE(m.green_down && m.centered_normals);
    }
}
