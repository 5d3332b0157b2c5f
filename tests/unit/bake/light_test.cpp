// SPDX-License-Identifier: Apache-2.0
// Light in maps: against rooms whose radiosity is known, by the map `light` of bakes and by lightmaps.
#include <rakelight/bake/bake.h>
#include <rakelight/bake/lightmap.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include "math/color.h"
#include "support/environment_variable.h"
#include "support/thrown_error.h"
#include "unit/radiosity/box_scene.h"

namespace rakelight {
namespace {

using radiosity::diffuse;
using radiosity::placed_square;
using radiosity::room;
using namespace test;

class MapsOfLight : public testing::Test {
protected:
    void SetUp() override {
        if (!can_bake()) GTEST_SKIP() << "this build follows no rays";
    }
    Lightmap lightmap(Scene scene, const LightmapOptions& options = {.width = 160, .height = 120, .chart_margin = 2}) {
        Lightmap made =
            with_lightmap(std::move(scene), {.elements = 1500, .unshot = 0.001}, options, solution_, report_, context_);
        validate(made.scene);
        return made;
    }
    Context context_{{.threads = 2}};
    RadiosityReport solution_;
    LightmapReport report_;
};

/// Radiance that a lightmap shows at a corner of a triangle, by the nearest texel.
vec3 shown_at(const Lightmap& made, const Mesh& mesh, std::uint32_t vertex) {
    const Material& m = made.scene.materials[mesh.material];
    const vec2 uv = mesh.texcoords[m.emission_texture.texcoord_set][vertex];
    const int x = std::min(int(uv.x * float(made.picture.width)), made.picture.width - 1),
              y = std::min(int(uv.y * float(made.picture.height)), made.picture.height - 1);
    vec3 out;
    for (int k = 0; k < 3; ++k) out[std::size_t(k)] = linear_from_srgb8(std::uint8_t(made.picture.row(y)[3 * x + k]));
    return out * m.emission;
}

TEST_F(MapsOfLight, AFurnaceIsBakedAsEmissionOverOneMinusAlbedo) {
    const Material glowing = diffuse({0.5f, 0.2f, 0}, {1, 1, 1});
    const Scene box = room(glowing, glowing);
    BakeOptions options;
    options.maps = {BakeMap::light, BakeMap::height}, options.width = options.height = 96;
    options.make_coordinates = true, options.chart_margin = 2, options.light_elements = 1500;
    const BakeResult result = bake_maps(box, box, options, context_);
    ASSERT_EQ(result.maps[0].channels, 3);
    EXPECT_EQ(result.report.missed, 0u);
    EXPECT_GE(result.report.radiosity.elements, 300u);
    std::uint64_t lit = 0;
    for (std::size_t i = 0; i < result.maps[0].values.size(); i += 3) {
        const float* v = &result.maps[0].values[i];
        if (v[0] == 0) continue;  // beside the charts
        ++lit;
        EXPECT_NEAR(v[0], 2, 0.06);
        EXPECT_NEAR(v[1], 1.25, 0.03);
        EXPECT_NEAR(v[2], 1, 0.01);
    }
    EXPECT_GE(lit, result.report.texels);
}

TEST_F(MapsOfLight, LightOfTheDetailedModelNeedsALight) {
    const Scene dark = room(diffuse({0.5f, 0.5f, 0.5f}), diffuse({0.5f, 0.5f, 0.5f}));
    BakeOptions options;
    options.maps = {BakeMap::light}, options.width = options.height = 32;
    options.make_coordinates = true, options.chart_margin = 2;
    EXPECT_EQ(error_of([&] { (void)bake_maps(dark, dark, options, context_); }).code(), ErrorCode::bad_file);
}

TEST_F(MapsOfLight, PicturesOfLightAreSrgbAndEndAtOne) {
    BakeResult result{.width = 2, .height = 1};
    result.maps.push_back({BakeMap::light, 3, {0.5f, 0.0f, 1.0f, 7.0f, 0.0031308f, 0.2f}});
    const Pixels codes = picture_of(result, result.maps[0], {}, Component::u8, context_);
    const int expected[] = {188, 0, 255, 255, 10, 124};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(int(codes.bytes[i]), expected[i]) << i;
    const Pixels floats = picture_of(result, result.maps[0], {}, Component::f32, context_);
    EXPECT_EQ(reinterpret_cast<const float*>(floats.bytes.data())[3], 7.0f);
}

TEST_F(MapsOfLight, ALightmapShowsTheRadianceOfAFurnace) {
    const Material walls = diffuse({0.5f, 0.2f, 0}, {1, 1, 1}), ceiling = diffuse({0.5f, 0.2f, 0}, {1, 1, 1});
    const Lightmap made = lightmap(room(walls, ceiling));
    EXPECT_EQ(report_.charts, 6u);
    EXPECT_EQ(report_.overlapping, 0u);
    EXPECT_NEAR(report_.brightest, 2, 0.03);
    for (const Mesh& mesh : made.scene.meshes) {
        EXPECT_EQ(mesh.triangle_count(), 2u);  // nothing is cut
        ASSERT_EQ(mesh.texcoords.size(), 2u);
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
            const vec3 r = shown_at(made, mesh, v);
            EXPECT_NEAR(r.x, 2, 0.05);
            EXPECT_NEAR(r.y, 1.25, 0.03);
            EXPECT_NEAR(r.z, 1, 0.02);
        }
    }
    for (const Material& m : made.scene.materials) {
        EXPECT_EQ(m.base_color.xyz(), (vec3{0, 0, 0}));
        EXPECT_EQ(m.metallic_roughness.specular, 0);
        EXPECT_EQ(m.emission_texture.texcoord_set, 1u);
    }
}

/// A square that faces up, half a meter below a lamp that shines down.
Scene square_under_lamp(const Material& material) {
    Scene scene;
    Material lamp = diffuse({0, 0, 0}, {10, 10, 10});
    scene.materials = {material, lamp};
    scene.materials[1].name = "lamp";
    add_object(scene, square_mesh(0), placed_square({0, 0, 0}, {0, 1, 0}));
    add_object(scene, square_mesh(1), placed_square({0, 0.5, 0}, {0, -1, 0}));
    return scene;
}

TEST_F(MapsOfLight, BothSidesOfATwoSidedSurfaceHaveAPlaceOfTheirOwn) {
    Material both = diffuse({1, 1, 1}), classical = both;
    both.double_sided = true;
    classical.model = MaterialModel::classical;  // formats of such materials say nothing about sides
    for (const Material& material : {both, classical}) {
        const Lightmap made = lightmap(square_under_lamp(material));
        EXPECT_FALSE(made.scene.materials[0].double_sided);
        ASSERT_EQ(made.scene.nodes[0].meshes.size(), 2u);
        EXPECT_EQ(report_.charts, 3u);
        EXPECT_EQ(report_.overlapping, 0u);
        const Mesh &front = made.scene.meshes[made.scene.nodes[0].meshes[0]],
                   &back = made.scene.meshes[made.scene.nodes[0].meshes[1]];
        EXPECT_EQ(front.normals[0], (vec3{0, 0, 1}));
        EXPECT_EQ(back.normals[0], (vec3{0, 0, -1}));
        for (std::uint32_t v = 0; v < 4; ++v) {
            EXPECT_GT(shown_at(made, front, v).x, 1);
            EXPECT_EQ(shown_at(made, back, v).x, 0);
        }
    }
}

TEST_F(MapsOfLight, TexturesAreInTheMapAndAlphaStays) {
    Scene scene = square_under_lamp(diffuse({1, 1, 1}));
    Material& m = scene.materials[0];
    const Pixels half = rgb_pixels(2, 2, [](int x, int) { return std::array{x == 0 ? 255 : 0, 255, 255}; });
    m.base_color_texture = add_texture(scene, picture(half));
    m.alpha_mode = AlphaMode::mask;
    const Lightmap made = lightmap(std::move(scene), {.width = 256, .height = 256, .samples = 4, .chart_margin = 2});
    const Material& shown = made.scene.materials[0];
    EXPECT_EQ(shown.alpha_mode, AlphaMode::mask);
    EXPECT_EQ(shown.base_color_texture.texture, 0u);
    EXPECT_EQ(shown.base_color_texture.texcoord_set, 0u);
    const Mesh& mesh = made.scene.meshes[0];
    for (std::uint32_t v = 0; v < 4;
         ++v) {  // the corners of texels repeat: red is whole on the left, gone on the right
        const vec3 r = shown_at(made, mesh, v);
        EXPECT_GT(r.y, 1);
        EXPECT_GT(r.z, 1);
        EXPECT_LT(r.x, 0.6f * r.y);
    }
}

TEST_F(MapsOfLight, UnlitMaterialsAndOtherSetsStayAsTheyAre) {
    Scene scene = square_under_lamp(diffuse({1, 1, 1}));
    Material sign;
    sign.model = MaterialModel::unlit, sign.base_color = {0.2f, 0.4f, 0.6f, 1};
    scene.materials.push_back(sign);
    add_object(scene, square_mesh(2), placed_square({5, 0, 0}, {0, 1, 0}));
    scene.meshes[0].texcoords.push_back(scene.meshes[0].texcoords[0]);  // two sets of its own
    const Block<vec2> own = scene.meshes[0].texcoords[1];
    const Lightmap made = lightmap(std::move(scene));
    EXPECT_EQ(made.scene.materials[2].model, MaterialModel::unlit);
    EXPECT_EQ(made.scene.materials[2].base_color.z, 0.6f);
    EXPECT_EQ(made.scene.materials[0].emission_texture.texcoord_set, 2u);
    EXPECT_TRUE(std::ranges::equal(made.scene.meshes[0].texcoords[1], own));
    EXPECT_EQ(made.scene.meshes[1].texcoords.size(), 3u);
    EXPECT_EQ(made.scene.meshes[2].texcoords.size(), 1u);
}

TEST_F(MapsOfLight, LightmapsAreTheSameForAnyNumberOfThreadsAndAnyInstructionSet) {
    const Scene scene = room(diffuse({0.7f, 0.6f, 0.5f}), diffuse({0.2f, 0.2f, 0.2f}, {5, 4, 3}));
    const Lightmap a = lightmap(scene);
    const EnvironmentVariable isa("RAKELIGHT_ISA", "scalar");
    Context three({.threads = 3});
    const Lightmap b = with_lightmap(scene, {.elements = 1500, .unshot = 0.001},
                                     {.width = 160, .height = 120, .chart_margin = 2}, solution_, report_, three);
    EXPECT_EQ(a.picture.bytes, b.picture.bytes);
    EXPECT_EQ(a.scene.materials, b.scene.materials);
}

TEST_F(MapsOfLight, ImpossibleSettingsAreRefused) {
    const Scene box = room(diffuse({0.5f, 0.5f, 0.5f}, {1, 1, 1}), diffuse({0.5f, 0.5f, 0.5f}));
    EXPECT_EQ(error_of([&] { (void)lightmap(box, {.width = 0}); }).code(), ErrorCode::usage);
    EXPECT_EQ(error_of([&] { (void)lightmap(box, {.height = 16385}); }).code(), ErrorCode::usage);
    EXPECT_EQ(error_of([&] { (void)lightmap(box, {.samples = 3}); }).code(), ErrorCode::usage);
    EXPECT_EQ(error_of([&] { (void)lightmap(box, {.width = 8, .height = 8}); }).code(), ErrorCode::usage);
    Scene unlit = box;
    for (Material& m : unlit.materials) m.model = MaterialModel::unlit;
    EXPECT_EQ(error_of([&] { (void)lightmap(unlit); }).code(), ErrorCode::bad_file);
}

}  // namespace
}  // namespace rakelight
