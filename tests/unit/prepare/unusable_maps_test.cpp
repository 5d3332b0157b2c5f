// SPDX-License-Identifier: Apache-2.0
// Maps and textures that a mesh has no coordinates for are named, where they would act.
#include <gtest/gtest.h>

#include <array>

#include "prepare/prepare_scene.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

using test::quad_mesh;
using test::remarks;
using test::scene_of;
using test::textured_quad;

TEST(UnusableMaps, WarnsWhereANormalMapCannotBeUsed) {
    Scene scene = scene_of({quad_mesh()});
    TextureUse& use = test::give_texture(scene, &Material::normal_texture);
    Context context;
    EXPECT_TRUE(prepare_scene(scene, {}, context).meshes[0].tangents.empty());
    EXPECT_EQ(remarks(context, Remark::warning, "no texture coordinates"), 1u);
    scene.meshes[0] = textured_quad();
    scene.meshes[0].material = 0;
    use.texcoord_set = 7;
    Context beyond;
    EXPECT_TRUE(prepare_scene(scene, {}, beyond).meshes[0].tangents.empty());
    EXPECT_EQ(remarks(beyond, Remark::warning, "no texture coordinates"), 1u);
}

TEST(UnusableMaps, NamesTheMapThatCannotBeUsedAndOnlyWhereItWouldAct) {
    Scene heights = scene_of({quad_mesh()});
    test::give_texture(heights, &Material::height_texture);
    const auto said = [](const Scene& scene, Bump bump) {
        Context context;
        prepare_scene(scene, {.bump = bump}, context);
        return std::array{
            remarks(context, Remark::warning, "the height map is not used: the mesh has no texture coordinates"),
            remarks(context, Remark::warning, "the normal map is not used: the mesh has no texture coordinates")};
    };
    using Said = std::array<std::uint64_t, 2>;
    for (const Bump bump : {Bump::automatic, Bump::height, Bump::parallax, Bump::parallax_limited, Bump::steep,
                            Bump::occlusion, Bump::displacement})
        EXPECT_EQ(said(heights, bump), (Said{1, 0})) << int(bump);
    for (const Bump bump : {Bump::none, Bump::normal}) EXPECT_EQ(said(heights, bump), (Said{0, 0})) << int(bump);
    Scene normals = scene_of({quad_mesh()});
    test::give_texture(normals, &Material::normal_texture);
    for (const Bump bump : {Bump::automatic, Bump::normal}) EXPECT_EQ(said(normals, bump), (Said{0, 1})) << int(bump);
    EXPECT_EQ(said(normals, Bump::none), (Said{0, 0}));
}

TEST(UnusableMaps, ATextureThatAMeshHasNoCoordinatesForIsWarnedOf) {
    constexpr const char* words = "a texture shows one color";
    for (TextureUse Material::*const role :
         {&Material::base_color_texture, &Material::emission_texture, &Material::occlusion_texture}) {
        Context without, made, other_set;
        Scene scene = scene_of({quad_mesh()});
        TextureUse& use = test::give_texture(scene, role);
        prepare_scene(scene, {}, without);
        EXPECT_EQ(remarks(without, Remark::warning, words), 1u) << test::all_remarks(without);
        EXPECT_EQ(remarks(without, Remark::warning, "'uv'"), 1u);
        prepare_scene(scene, {.uv = UvProjection::box}, made);
        EXPECT_EQ(remarks(made, Remark::warning, words), 0u) << test::all_remarks(made);
        scene.meshes[0].texcoords.emplace_back(std::vector<vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        use.texcoord_set = 1;
        prepare_scene(scene, {}, other_set);
        EXPECT_EQ(remarks(other_set, Remark::warning, words), 1u);
        EXPECT_EQ(remarks(other_set, Remark::warning, "'uv'"), 0u) << "it makes none where there are some";
    }
    Scene unlit = scene_of({quad_mesh()});
    test::give_texture(unlit, &Material::emission_texture);
    unlit.materials[0].model = MaterialModel::unlit;
    Context context;
    prepare_scene(unlit, {}, context);
    EXPECT_EQ(remarks(context, Remark::warning, words), 0u) << "it is not shown";
}

TEST(UnusableMaps, SaysThatAClearcoatsNormalMapIsNotUsedWithoutCoordinates) {
    Scene scene = scene_of({quad_mesh()});
    const TextureUse use = test::give_texture(scene, &Material::emission_texture);
    Material& m = scene.materials[0];
    m.emission_texture = {};
    m.metallic_roughness.clearcoat = 1;
    m.metallic_roughness.clearcoat_normal_texture = use;
    Context context;
    prepare_scene(scene, {}, context);
    EXPECT_EQ(remarks(context, Remark::warning, "the normal map of the clearcoat is not used"), 1u);
    m.metallic_roughness.clearcoat = 0;  // nothing reads it
    Context without;
    prepare_scene(scene, {}, without);
    EXPECT_EQ(remarks(without, Remark::warning, "clearcoat"), 0u);
}

TEST(UnusableMaps, TheClearcoatsNormalMapIsNamedBesideTheSurfacesAndOnItsOwn) {
    Mesh mesh = textured_quad();
    Scene scene = scene_of({mesh});
    const TextureUse use = test::give_texture(scene, &Material::normal_texture);
    MetallicRoughnessParameters& p = scene.materials[0].metallic_roughness;
    p.clearcoat = 1;
    p.clearcoat_normal_texture = use;
    const auto said = [&](std::uint32_t of_surface, std::uint32_t of_coat) {
        scene.materials[0].normal_texture.texcoord_set = of_surface;
        p.clearcoat_normal_texture.texcoord_set = of_coat;
        Context context;
        prepare_scene(scene, {}, context);
        return std::array{remarks(context, Remark::warning, "the normal map is not used: the mesh has no texture"),
                          remarks(context, Remark::warning, "the normal map of the clearcoat is not used"),
                          remarks(context, Remark::warning, "")};
    };
    EXPECT_EQ(said(0, 1), (std::array<std::uint64_t, 3>{0, 0, 0}));
    EXPECT_EQ(said(0, 7), (std::array<std::uint64_t, 3>{0, 1, 1}));
    EXPECT_EQ(said(7, 0), (std::array<std::uint64_t, 3>{1, 0, 1}));
    EXPECT_EQ(said(7, 7), (std::array<std::uint64_t, 3>{1, 1, 2}));
}

}  // namespace
}  // namespace rakelight
