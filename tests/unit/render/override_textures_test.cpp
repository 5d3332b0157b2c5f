// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/picture.h>

#include "support/scene_builder.h"
#include "support/shared.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {
std::string bricks() { return (source_dir() / "data/bricks/normal.png").string(); }
}  // namespace

TEST(OverrideTextures, NothingAskedForSharesEverything) {
    Scene scene;
    add_object(scene, square_mesh());
    Context context;
    const Scene same = override_textures(scene, {}, context);
    EXPECT_TRUE(same.materials.empty());
    EXPECT_EQ(same.meshes[0].positions, scene.meshes[0].positions);
}

TEST(OverrideTextures, EveryMaterialGetsThePictureAlsoTheDefaultOne) {
    Scene scene;
    scene.materials.push_back(matte());
    add_object(scene, square_mesh(0));
    add_object(scene, square_mesh());
    Context context;
    const Scene changed =
        override_textures(scene, {.base_color = {}, .normal = bricks(), .normal_scale = 0.5}, context);
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

TEST(OverrideTextures, AFolderAndAFileThatIsNoPictureAreErrors) {
    Context context;
    const std::string folder = source_dir().string(), text = (source_dir() / "README.md").string();
    for (const auto& [path, code] : {std::pair{folder, ErrorCode::not_found}, std::pair{text, ErrorCode::bad_file}}) {
        try {
            override_textures(Scene{}, {.base_color = path}, context);
            FAIL() << path;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), code);
            EXPECT_EQ(e.file(), path);
            EXPECT_EQ(e.place(), "");
        }
    }
}

TEST(OverrideTextures, APictureThatIsNotThereIsAnError) {
    Context context;
    try {
        override_textures(Scene{}, {.normal = "no/such.png"}, context);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::not_found);
        EXPECT_EQ(e.file(), "no/such.png");
    }
}
