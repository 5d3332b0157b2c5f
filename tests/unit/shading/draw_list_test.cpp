// SPDX-License-Identifier: Apache-2.0
// What every engine draws of a scene, and what is chosen for each draw.
#include "shading/draw_list.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include <rakelight/scene/motion.h>

#include "shading/draw_choices.h"
#include "shading/edge_lengths.h"
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

/// A leaf whose mask a clip moves.
struct MovingLeaf {
    std::shared_ptr<std::atomic<int>> decoded = std::make_shared<std::atomic<int>>(0);
    Scene scene;
    MovingLeaf() {
        auto image = std::make_shared<EncodedImage>();
        image->decode = [count = decoded](const EncodedImage&, Context&) {
            ++*count;
            Pixels p{.width = 32, .height = 32, .channels = 4};
            for (int i = 0; i < 32 * 32; ++i)
                for (const int c : {90, 160, 50, std::max(0, 255 - 12 * std::abs(i % 32 - 16))})
                    p.bytes.push_back(std::byte(c));
            return p;
        };
        Material m = matte();
        m.alpha_mode = AlphaMode::mask;
        m.base_color_texture = {.texture = 0};
        scene.textures.push_back({.image = image});
        scene.textures[0].sampler.mip = MipFilter::linear;
        scene.materials = {m};
        add_object(scene, square_mesh(0));
        AnimationChannel cutoff{.element = 0, .path = AnimationPath::material, .property = "alpha_cutoff"};
        cutoff.times = std::vector<float>{0, 1}, cutoff.values = std::vector<float>{0.1f, 0.9f};
        AnimationChannel color{.element = 0, .path = AnimationPath::material, .property = "base_color"};
        color.times = cutoff.times, color.values = std::vector<float>{1, 1, 1, 1, 1, 1, 1, 0.95f};
        scene.animations = {{.name = "fade", .channels = {cutoff, color}}};
    }
    Scene at(double time_s) const {
        const ClipTime clip{0, time_s};
        return scene_at(scene, {&clip, 1});
    }
};

TEST(DrawList, AMaskThatMovesIsPreparedForEachCutoffAndDecodedTwice) {
    const MovingLeaf leaf;
    Context context({.threads = 1});
    TextureCache textures;
    const test::FakePacker packer;
    for (int frame = 0; frame < 16; ++frame) {
        const DrawList list = make_draw_list(leaf.at(frame / 15.0), textures, packer, context);
        const DrawMaterial& m = list.material(list.draws[0]);
        EXPECT_FLOAT_EQ(m.texel_cutoff, float((0.1 + 0.8 * frame / 15) / (1 - 0.05 * frame / 15)));
        ASSERT_TRUE(m.maps[role_base_color]);
    }
    EXPECT_EQ(packer.packed, 16);
    EXPECT_EQ(*leaf.decoded, 2) << "the second cutoff has shown that it moves";
    make_draw_list(leaf.scene, textures, packer, context);
    EXPECT_EQ(*leaf.decoded, 2);
    textures.update({}, packer, context);
    EXPECT_EQ(context.memory().charged(), 0u);
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
    EXPECT_FLOAT_EQ(r.to_uv[0][0], 0.25f);
    EXPECT_FLOAT_EQ(r.to_uv[1][1], -1.0f);  // v down, twice as many widths a height, half of them by the scale
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

/// A square of side 2 whose sides are `pixels` long, seen from the front.
PictureCamera view_of(double pixels, bool is_parallel, double z_near = 0.1) {
    Camera camera = test::flat_camera();
    camera.projection = is_parallel ? Projection::orthographic : Projection::perspective;
    camera.vertical_fov_rad = 2 * std::atan(1.0 / 5), camera.z_near = z_near, camera.z_far = 1e4;
    RenderSettings s{.width = 64, .height = 64};
    camera.half_height = 64 / pixels;
    camera.to_world = translation(dvec3{0, 0, 5 * 64 / pixels});
    return make_picture_camera(camera, camera.to_world, s);
}

TEST(ChooseShading, SmallTrianglesThatNeedNoPixelsAreShadedByGouraud) {
    Scene scene;
    scene.materials = {matte()};
    add_object(scene, square_mesh(0));
    const Made plain(std::move(scene)), bumps(bumpy());
    Context context({.threads = 1});
    RenderSettings s;
    s.shading = Shading::automatic;
    const double side = automatic_gouraud_px / std::sqrt(2.0);  // the diagonal is the longest edge
    for (const bool is_parallel : {false, true}) {
        const PictureCamera small = view_of(0.99 * side, is_parallel), large = view_of(1.01 * side, is_parallel);
        EXPECT_EQ(choose_shading(plain.list, s, small, context)[0], Shading::gouraud);
        EXPECT_EQ(choose_shading(plain.list, s, large, context)[0], Shading::phong);
        EXPECT_EQ(choose_shading(bumps.list, s, small, context)[0], Shading::phong);
        RenderSettings with_shadows = s;
        with_shadows.shadows = true;
        EXPECT_EQ(choose_shading(plain.list, with_shadows, small, context)[0], Shading::phong);
    }
    EXPECT_EQ(measured_meshes(plain.list, s), std::set<std::uint32_t>{0});
    EXPECT_TRUE(measured_meshes(bumps.list, s).empty());
    EXPECT_TRUE(measured_meshes(plain.list, {}).empty());
    EXPECT_TRUE(context.report().entries().empty());
}

TEST(ChooseShading, TrianglesThatPassTheEndsOfTheViewAndThoseOutsideOfItAreShadedByPhong) {
    Scene scene;
    scene.materials = {matte()};
    add_object(scene, square_mesh(0));
    dmat4 away;
    away[3].x = 1000;
    add_object(scene, square_mesh(0), away);
    const Made made(std::move(scene));
    EXPECT_TRUE(edges_are_within(made.list, made.draw(0), view_of(1, true), 2));
    EXPECT_FALSE(edges_are_within(made.list, made.draw(1), view_of(1, true), 2)) << "it is not in the picture";
    dmat4 turned;
    turned[0] = {0, 0, 1e-3, 0}, turned[2] = {1, 0, 0, 0};
    Scene crossing;
    crossing.materials = {matte()};
    add_object(crossing, square_mesh(0), turned);
    const Made crosses(std::move(crossing));
    EXPECT_FALSE(edges_are_within(crosses.list, crosses.draw(0), view_of(1, true, 320), 2)) << "the near plane cuts it";
}

}  // namespace
}  // namespace rakelight::shading
