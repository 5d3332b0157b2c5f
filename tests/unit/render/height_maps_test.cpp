// SPDX-License-Identifier: Apache-2.0
#include "render/height_maps.h"

#include <gtest/gtest.h>

#include "support/scene_builder.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

/// One tilted row among level ones.
Pixels normals() {
    return rgb_pixels(8, 8, [](int, int y) { return std::array<int, 3>{128, y == 2 ? 200 : y == 5 ? 56 : 128, 240}; });
}

Scene scene_with_normal_map() {
    Scene scene;
    scene.materials = {matte(), matte()};
    scene.materials[0].normal_texture = add_texture(scene, picture(normals(), "n.png"));
    scene.materials[0].normal_texture.transform.scale = {3, 3};
    scene.materials[1].normal_texture = scene.materials[0].normal_texture;
    add_object(scene, square_mesh(0));
    return scene;
}

RenderSettings with(Bump bump) {
    RenderSettings s;
    s.bump = bump;
    return s;
}

}  // namespace

TEST(HeightMaps, AreMadeOnceForATechniqueThatReadsThemAndSaid) {
    Context context;
    const Scene made = with_height_maps(scene_with_normal_map(), with(Bump::steep), context);
    ASSERT_EQ(made.textures.size(), 2u);
    for (const Material& m : made.materials) {
        EXPECT_EQ(m.height_texture.texture, 1u);
        EXPECT_EQ(m.height_texture.transform.scale.x, 3);
    }
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_EQ(context.report().entries()[0].message.rfind("height map computed from the normal map", 0), 0u);
    const Pixels heights = made.textures[1].image->decode(*made.textures[1].image, context);
    EXPECT_EQ(heights.width, 8);
    EXPECT_EQ(heights.channels, 1);
}

TEST(HeightMaps, DisplacementByHeightsThatWereGuessedIsAWarningForEachMaterial) {
    Scene scene = scene_with_normal_map();
    scene.materials[0].name = "atlas";
    scene.materials[1].height_texture = scene.materials[1].normal_texture;
    const auto warnings = [&](Bump bump) {
        Context context;
        with_height_maps(scene, with(bump), context);
        std::string places;
        for (const ReportEntry& e : context.report().entries())
            if (e.remark == Remark::warning) places += "[" + e.place + "] " + e.message.substr(0, 49);
        return places;
    };
    EXPECT_EQ(warnings(Bump::displacement), "[atlas] displaced by heights computed from the normal map");
    EXPECT_EQ(warnings(Bump::occlusion), "");
    scene.materials[0].bump = Bump::displacement;
    EXPECT_EQ(warnings(Bump::steep), "[atlas] displaced by heights computed from the normal map");
    scene.materials[0].height_texture = scene.materials[0].normal_texture;
    EXPECT_EQ(warnings(Bump::displacement), "");
}

TEST(HeightMaps, AreNotMadeWhereNobodyReadsThemOrOneIsThere) {
    for (const Bump bump : {Bump::automatic, Bump::none, Bump::normal}) {
        Context context;
        EXPECT_EQ(with_height_maps(scene_with_normal_map(), with(bump), context).textures.size(), 1u);
    }
    Scene scene = scene_with_normal_map();
    scene.materials[0].height_texture = scene.materials[0].normal_texture;
    scene.materials[1].bump = Bump::normal;  // its own choice goes first
    Context context;
    EXPECT_EQ(with_height_maps(scene, with(Bump::parallax), context).textures.size(), 1u);
}

TEST(HeightMaps, ANormalMapThatCannotBeReadLeavesTheMaterialAlone) {
    Scene scene = scene_with_normal_map();
    auto broken = std::make_shared<EncodedImage>(*scene.textures[0].image);
    broken->decode = [](const EncodedImage&, Context&) -> Pixels { throw Error(ErrorCode::bad_file, "broken"); };
    scene.textures[0].image = broken;
    Context context;
    const Scene same = with_height_maps(scene, with(Bump::occlusion), context);
    EXPECT_FALSE(same.materials[0].height_texture);
    ASSERT_FALSE(context.report().entries().empty());
    EXPECT_EQ(context.report().entries()[0].message, "no height map computed from the normal map: broken");
}

TEST(HeightMaps, ATechniqueThatFindsNoneIsAWarning) {
    Scene scene;
    scene.materials = {matte(), matte()};
    const auto warnings = [&](Bump bump) {
        Context context;
        with_height_maps(scene, with(bump), context);
        std::string places;
        for (const ReportEntry& e : context.report().entries()) {
            EXPECT_EQ(e.remark, Remark::warning);
            EXPECT_EQ(e.message.rfind("no bumps: ", 0), 0u) << e.message;
            places += "[" + e.place + "]";
        }
        return places;
    };
    for (const Bump bump :
         {Bump::height, Bump::parallax, Bump::parallax_limited, Bump::steep, Bump::occlusion, Bump::displacement})
        EXPECT_EQ(warnings(bump), "[]") << int(bump);
    for (const Bump bump : {Bump::automatic, Bump::none, Bump::normal}) EXPECT_EQ(warnings(bump), "") << int(bump);
    scene.materials[1].name = "wall";
    scene.materials[1].bump = Bump::steep;
    EXPECT_EQ(warnings(Bump::automatic), "[wall]");
    scene.materials[0].height_texture = add_texture(scene, picture(normals()));
    EXPECT_EQ(warnings(Bump::steep), "[wall]");
    scene.materials[1].bump = Bump::automatic;
    EXPECT_EQ(warnings(Bump::steep), "");
}
