// SPDX-License-Identifier: Apache-2.0
// What every engine draws of a scene, and what is chosen for each draw.
#include "shading/draw_list.h"

#include <gtest/gtest.h>

#include "shading/draw_choices.h"
#include "shading/shading_choice.h"
#include "shading/text_numbers.h"
#include "support/scene_builder.h"
#include "unit/shading/fake_textures.h"

namespace rakelight::shading {
namespace {

using test::add_object;
using test::matte;
using test::picture;
using test::rgb_pixels;
using test::square_mesh;

struct Made {
    Context context{{.threads = 1}};
    TextureCache textures;
    test::FakePacker packer;
    DrawList list;
    explicit Made(Scene scene) : list(make_draw_list(std::move(scene), textures, packer, context)) {}
    const Draw& draw(std::size_t i) const { return list.draws[i]; }
};

/// A picture of one color as a texture of the scene.
TextureUse texture(Scene& scene, std::array<int, 3> color) {
    Texture t;
    t.image = picture(rgb_pixels(2, 2, [color](int, int) { return color; }));
    scene.textures.push_back(t);
    return {.texture = std::uint32_t(scene.textures.size() - 1)};
}

/// A square whose material has a height and a normal map.
Scene bumpy() {
    Scene scene;
    Material m = matte();
    m.normal_texture = texture(scene, {128, 128, 255});
    m.height_texture = texture(scene, {200, 200, 200});
    m.height_scale = 2;
    scene.materials = {m};
    add_object(scene, square_mesh(0));
    return scene;
}

TEST(DrawList, PlacesMeshesWithTheirBoundsAndSaysWhichAreMirrored) {
    Scene scene;
    scene.materials = {matte()};
    add_object(scene, square_mesh(0), translation(dvec3{10, 0, 0}));
    dmat4 mirror;
    mirror[0].x = -1;
    add_object(scene, square_mesh(), mirror);
    const Made made(std::move(scene));
    ASSERT_EQ(made.list.draws.size(), 2u);
    EXPECT_FALSE(made.draw(0).mirrored);
    EXPECT_TRUE(made.draw(1).mirrored);
    EXPECT_EQ(made.list.bounds.low.x, -1);
    EXPECT_EQ(made.list.bounds.high.x, 11);
    EXPECT_EQ(made.list.material(made.draw(0)).scene_material, 0u);
    EXPECT_EQ(made.list.material(made.draw(1)).scene_material, no_index);
    EXPECT_EQ(made.list.scene_material(made.list.material(made.draw(1))).name, Material().name);
}

TEST(DrawList, MapsThatCannotBeHadAreNotThereAndTakeTheirEmissionWithThem) {
    Scene scene = bumpy();
    auto broken = std::make_shared<EncodedImage>();
    broken->decode = [](const EncodedImage&, Context&) -> Pixels { throw Error(ErrorCode::bad_file, "cut off"); };
    scene.textures.push_back({.image = broken});
    scene.materials[0].emission = {1, 2, 3};
    scene.materials[0].emission_texture = {.texture = 2};
    const Made made(std::move(scene));
    const DrawMaterial& m = made.list.material(made.draw(0));
    EXPECT_TRUE(m.maps[role_normal]);
    EXPECT_TRUE(m.maps[role_height]);
    EXPECT_FALSE(m.maps[role_emission]);
    EXPECT_FALSE(m.maps[role_base_color]);
    EXPECT_EQ(m.factors.emission[2], 0.0f);
}

TEST(DrawList, ACoatsNormalMapIsLeftOutWhereTheMeshHasNoCoordinatesForIt) {
    Scene scene;
    Material m;
    m.model = MaterialModel::metallic_roughness;
    m.metallic_roughness.clearcoat = 1;
    m.metallic_roughness.clearcoat_normal_texture = texture(scene, {128, 128, 255});
    scene.materials = {m};
    add_object(scene, square_mesh(0));
    Mesh bare = square_mesh(0);
    bare.texcoords.clear();
    add_object(scene, bare);
    const Made made(std::move(scene));
    EXPECT_TRUE(made.list.material(made.draw(0)).maps[role_clearcoat_normal]);
    EXPECT_FALSE(made.list.material(made.draw(1)).maps[role_clearcoat_normal]);
    EXPECT_EQ(made.list.material(made.draw(1)).scene_material, 0u);
    EXPECT_EQ(made.list.material(made.draw(1)).factors.clearcoat, 1.0f);
}

TEST(DrawChoices, BumpsFallBackToWhatTheMapsAndTheMeshHave) {
    const RenderSettings steep{.bump = Bump::steep};
    const Made made(bumpy());
    EXPECT_EQ(bump_of(made.list, made.draw(0), steep), Bump::steep);
    EXPECT_EQ(bump_of(made.list, made.draw(0), {.bump = Bump::normal}), Bump::normal);
    EXPECT_EQ(bump_of(made.list, made.draw(0), {.bump = Bump::none}), Bump::none);
    Scene flat = bumpy();
    flat.materials[0].height_texture = {};
    const Made without(std::move(flat));
    EXPECT_EQ(bump_of(without.list, without.draw(0), steep), Bump::normal) << "no heights";
    Scene bare = bumpy();
    bare.meshes[0].texcoords.clear();
    const Made uncoordinated(std::move(bare));
    EXPECT_EQ(bump_of(uncoordinated.list, uncoordinated.draw(0), steep), Bump::none) << "no coordinates";
}

TEST(DrawChoices, AReliefIsAsDeepAsItsMapAndSteppedWithinWhatAPictureCanBeWaitedFor) {
    Scene scene = bumpy();
    scene.materials[0].height_texture.transform.scale = {4, 2};
    const Made made(std::move(scene));
    RenderSettings s{.bump = Bump::occlusion};
    s.relief.depth = 0.1f;
    s.relief.min_steps = 5000, s.relief.max_steps = 9000, s.relief.refinement_steps = 99;
    const ReliefFactors r = relief_of(made.list, made.draw(0), s, 2);  // a map twice as wide as high
    EXPECT_EQ(r.technique, relief_occlusion);
    EXPECT_FLOAT_EQ(r.depth, 0.2f);
    EXPECT_EQ(r.max_steps, 1024);
    EXPECT_EQ(r.min_steps, 1024);
    EXPECT_EQ(r.refinement_steps, 32);
    EXPECT_FLOAT_EQ(r.to_uv[0], 0.25f);
    EXPECT_FLOAT_EQ(r.to_uv[1], -1.0f);  // v down, twice as many widths a height, half of them by the scale
    EXPECT_FLOAT_EQ(r.to_map[0][0], 1.0f);
    EXPECT_FLOAT_EQ(r.to_map[1][1], -2.0f);
    EXPECT_EQ(relief_of(made.list, made.draw(0), {.bump = Bump::normal}, 2).technique, relief_none);
}

TEST(DrawChoices, MasksEndAtTheirCutoffReliefsThatEndAtTheirEdgeAtOneHalf) {
    MaterialFactors opaque{}, masked{};
    opaque.alpha_cutoff = -1, masked.alpha_cutoff = 0.25f;
    EXPECT_EQ(mask_cutoff(opaque, false), -1.0f);
    EXPECT_EQ(mask_cutoff(opaque, true), 0.5f);
    EXPECT_EQ(mask_cutoff(masked, true), 0.25f);
}

TEST(DrawChoices, FrontFacesTurnWithTheWindingAndWithMirrors) {
    const Made made(bumpy());
    Draw mirrored = made.draw(0);
    mirrored.mirrored = true;
    RenderSettings turned;
    turned.cull = Cull::back, turned.front_face = FrontFace::clockwise;
    EXPECT_TRUE(culling_of(made.list, made.draw(0), {}).front_is_negative);
    EXPECT_FALSE(culling_of(made.list, mirrored, {}).front_is_negative);
    EXPECT_FALSE(culling_of(made.list, made.draw(0), turned).front_is_negative);
    EXPECT_TRUE(culling_of(made.list, mirrored, turned).front_is_negative);
    EXPECT_TRUE(culling_of(made.list, made.draw(0), turned).back);
    EXPECT_FALSE(culling_of(made.list, made.draw(0), {}).back) << "its format says nothing about sides";
}

TEST(ChooseShading, SmallTrianglesThatNeedNoPixelsAreShadedByGouraud) {
    Scene scene;
    scene.materials = {matte()};
    add_object(scene, square_mesh(0));
    Scene with_bumps = bumpy();
    const Made plain(std::move(scene)), bumps(std::move(with_bumps));
    Context context({.threads = 1});
    RenderSettings s;
    s.shading = Shading::automatic;
    const auto all = [](std::uint32_t, double) { return true; };
    const auto none_is = [](std::uint32_t, double) { return false; };
    EXPECT_EQ(choose_shading(plain.list, s, all, context)[0], Shading::gouraud);
    EXPECT_EQ(choose_shading(plain.list, s, none_is, context)[0], Shading::phong);
    EXPECT_EQ(choose_shading(bumps.list, s, all, context)[0], Shading::phong);
    s.shadows = true;
    EXPECT_EQ(choose_shading(plain.list, s, all, context)[0], Shading::phong);
    EXPECT_TRUE(context.report().entries().empty());
}

TEST(ChooseShading, AnEngineThatCannotSayHowLongEdgesAreShadesByPhongAndSaysSo) {
    const Made made(bumpy());
    Context context({.threads = 1});
    RenderSettings s;
    s.shading = Shading::automatic;
    EXPECT_EQ(choose_shading(made.list, s, {}, context)[0], Shading::phong);
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_EQ(context.report().entries()[0].remark, Remark::note);
    s.shading = Shading::flat;
    EXPECT_EQ(choose_shading(made.list, s, {}, context)[0], Shading::flat);
    EXPECT_EQ(context.report().entries().size(), 1u) << "nothing is automatic";
}

}  // namespace
}  // namespace rakelight::shading
