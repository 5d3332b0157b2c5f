// SPDX-License-Identifier: Apache-2.0
#include "tools/thumbnail_textures.h"

#include <gtest/gtest.h>
#include <rakelight/io/image_sources.h>
#include <rakelight_internal/tools/thumbnail.h>

#include <limits>

#include "image/decode.h"
#include "io/pictures/image_io.h"
#include "support/thrown_error.h"

namespace rakelight {
namespace {

constexpr int side = 64, reduced_side = 16;
/// Of a picture of the size side * size: its pixels, and those of the reduced one.
constexpr std::uint64_t work_of(int size) {
    return std::uint64_t(size * size * side * side + reduced_side * reduced_side);
}
constexpr std::uint64_t work = work_of(1);
constexpr std::uint64_t any_work = ~std::uint64_t(0);

/// @param ending  "png" or "jpg"
Texture texture(const std::string& ending, int size = side) {
    const std::size_t count = std::size_t(size) * std::size_t(size) * 3;
    const Pixels plain{size, size, 3, Component::u8, false, std::vector<std::byte>(count, std::byte(128))};
    std::vector<std::byte> bytes;
    io::write_image({"a." + ending, bytes}, plain);
    return {.name = ending, .image = image_from_bytes(std::move(bytes), "a." + ending)};
}

/// A material with color, normal map, metalness and emission, each of a picture of its own.
Scene scene_of(const std::string& ending) {
    Scene scene;
    for (int i = 0; i < 4; ++i) scene.textures.push_back(texture(ending));
    Material& m = scene.materials.emplace_back();
    m.base_color_texture.texture = 0, m.normal_texture.texture = 1, m.emission_texture.texture = 2;
    m.metallic_roughness.texture.texture = 3;
    m.emission = {1, 1, 1};
    return scene;
}

TEST(ThumbnailTextures, AreReduced) {
    Context context;
    const Scene scene = with_thumbnail_textures(scene_of("png"), reduced_side, any_work, context);
    for (const Texture& t : scene.textures) EXPECT_EQ(decode(*t.image, context).width, 16);
    EXPECT_EQ(scene.materials, scene_of("png").materials);
    EXPECT_TRUE(context.report().entries().empty());
}

TEST(ThumbnailTextures, ThatShareAPictureStillDo) {
    Context context;
    Scene scene = scene_of("png");
    scene.textures[1] = scene.textures[0];
    const Scene reduced = with_thumbnail_textures(scene, reduced_side, 3 * work, context);
    EXPECT_EQ(reduced.textures[0].image, reduced.textures[1].image);
    EXPECT_NE(reduced.textures[0].image, reduced.textures[2].image);
    EXPECT_TRUE(context.report().entries().empty()) << "a picture is decoded once";
}

TEST(ThumbnailTextures, NormalMapsAreLeftOutFirst) {
    Context context;
    const Material m = with_thumbnail_textures(scene_of("png"), reduced_side, 4 * work - 1, context).materials[0];
    EXPECT_TRUE(m.base_color_texture && m.emission_texture && m.metallic_roughness.texture);
    EXPECT_FALSE(m.normal_texture);
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_NE(context.report().entries()[0].message.find("1 of 1 normal, height and occlusion"), std::string::npos);
}

TEST(ThumbnailTextures, ThenAllThatDoNotColorWithTheFactorsThatTheyMultiply) {
    Context context;
    const Material m = with_thumbnail_textures(scene_of("png"), reduced_side, 2 * work, context).materials[0];
    EXPECT_TRUE(m.base_color_texture && m.emission_texture);
    EXPECT_FALSE(m.metallic_roughness.texture || m.normal_texture);
    EXPECT_EQ(m.emission, (vec3{1, 1, 1}));
    EXPECT_EQ(m.metallic_roughness.metallic, 0);
}

TEST(ThumbnailTextures, ThenEmissionWhichWouldShineEverywhere) {
    Context context;
    const Material m = with_thumbnail_textures(scene_of("png"), reduced_side, work, context).materials[0];
    EXPECT_TRUE(m.base_color_texture);
    EXPECT_FALSE(m.emission_texture);
    EXPECT_EQ(m.emission, (vec3{0, 0, 0}));
}

TEST(ThumbnailTextures, ThenAll) {
    Context context;
    const Material m = with_thumbnail_textures(scene_of("png"), reduced_side, work - 1, context).materials[0];
    EXPECT_FALSE(m.base_color_texture);
    EXPECT_EQ(m.base_color, Material().base_color);
    EXPECT_EQ(context.report().entries().size(), 4u);
}

/// A material for each side of a square picture, which is its color and a normal map of the same size.
Scene scene_of_sides(const std::vector<int>& sides) {
    Scene scene;
    for (const int side : sides) {
        Material& m = scene.materials.emplace_back();
        for (TextureUse* const use : {&m.base_color_texture, &m.normal_texture}) {
            use->texture = std::uint32_t(scene.textures.size());
            scene.textures.push_back(texture("png", side));
        }
    }
    return scene;
}

/// Which materials of a scene still have their color.
std::vector<bool> with_color(const Scene& scene) {
    std::vector<bool> have;
    for (const Material& m : scene.materials) have.push_back(bool(m.base_color_texture));
    return have;
}

TEST(ThumbnailTextures, AreLeftOutOneByOneTheLastFirst) {
    Context context;
    const Scene scene = with_thumbnail_textures(scene_of_sides({side, side, side}), reduced_side, 2 * work, context);
    EXPECT_EQ(with_color(scene), (std::vector{true, true, false}));
    ASSERT_EQ(context.report().entries().size(), 2u);
    EXPECT_NE(context.report().entries()[0].message.find("3 of 3 normal"), std::string::npos);
    EXPECT_NE(context.report().entries()[1].message.find("1 of 3 maps of color and opacity"), std::string::npos);
}

TEST(ThumbnailTextures, OfOneKindTheLargestIsLeftOutFirst) {
    Context context;
    const Scene scene =
        with_thumbnail_textures(scene_of_sides({side, 2 * side, side}), reduced_side, work_of(2) + work, context);
    EXPECT_EQ(with_color(scene), (std::vector{true, false, true}));
}

TEST(ThumbnailTextures, ANormalMapGoesBeforeAnyColor) {
    Context context;
    const Scene scene =
        with_thumbnail_textures(scene_of_sides({2 * side, side}), reduced_side, work_of(2) + 2 * work, context);
    EXPECT_EQ(with_color(scene), (std::vector{true, true}));
    EXPECT_FALSE(scene.materials[0].normal_texture);
    EXPECT_TRUE(scene.materials[1].normal_texture) << "the larger one was enough";
}

TEST(ThumbnailTextures, ThatAreAColorTooStayInAllTheirRoles) {
    Context context;
    Scene scene = scene_of("png");
    scene.materials[0].occlusion_texture.texture = 0;
    const Material m = with_thumbnail_textures(scene, reduced_side, work, context).materials[0];
    EXPECT_TRUE(m.base_color_texture && m.occlusion_texture) << "leaving out one of them would save nothing";
    EXPECT_FALSE(m.normal_texture);
}

TEST(ThumbnailTextures, AnEnvironmentCountsIsReducedAndGoesBeforeColors) {
    Context context;
    Scene scene = scene_of("png");
    scene.environment = Environment{.image = texture("png").image};
    const Scene all = with_thumbnail_textures(scene, reduced_side, any_work, context);
    EXPECT_EQ(decode(*all.environment->image, context).width, 32);
    EXPECT_TRUE(context.report().entries().empty());
    constexpr std::uint64_t light = 7'000'000;  // what it takes beside decoding
    constexpr std::uint64_t with_it = light + side * side + 32 * 32 + work;
    const Scene just = with_thumbnail_textures(scene, reduced_side, with_it, context);
    EXPECT_TRUE(just.environment->image && just.materials[0].base_color_texture);
    EXPECT_FALSE(just.materials[0].emission_texture);
    const Scene few = with_thumbnail_textures(scene, reduced_side, with_it - 1, context);
    ASSERT_TRUE(few.environment);
    EXPECT_FALSE(few.environment->image) << "the studio replaces it";
    EXPECT_TRUE(few.materials[0].base_color_texture);
}

TEST(ThumbnailTextures, APictureThatAloneTakesTooLongCostsNoOther) {
    Context context;
    Scene scene = scene_of_sides({3 * side, side});
    scene.environment = Environment{.image = texture("png").image};
    const Scene reduced = with_thumbnail_textures(scene, reduced_side, 4 * work, context);
    EXPECT_EQ(with_color(reduced), (std::vector{false, true}));
    EXPECT_FALSE(reduced.materials[0].normal_texture || reduced.environment->image);
    EXPECT_TRUE(reduced.materials[1].normal_texture);
}

TEST(ThumbnailTextures, OfManyBytesAPixelCountAsMore) {
    Context context;
    Scene scene = scene_of("png");
    const Pixels deep{side, side, 3, Component::u16, false, std::vector<std::byte>(side * side * 6)};
    std::vector<std::byte> bytes;
    io::write_image({"a.png", bytes}, deep);
    scene.textures[0].image = image_from_bytes(std::move(bytes), "a.png");
    scene.materials[0].normal_texture = scene.materials[0].emission_texture =
        scene.materials[0].metallic_roughness.texture = {};
    EXPECT_EQ(with_color(with_thumbnail_textures(scene, reduced_side, 2 * work, context)), std::vector{false});
    EXPECT_EQ(with_color(with_thumbnail_textures(scene, reduced_side, 3 * work, context)), std::vector{true});
}

TEST(ThumbnailTextures, ThatAreNotThereAreNotReported) {
    Context context;
    Scene scene = scene_of("png");
    scene.materials[0].normal_texture = scene.materials[0].emission_texture =
        scene.materials[0].metallic_roughness.texture = {};
    const Material m = with_thumbnail_textures(scene, reduced_side, work - 1, context).materials[0];
    EXPECT_FALSE(m.base_color_texture);
    EXPECT_EQ(m.metallic_roughness.metallic, Material().metallic_roughness.metallic);
    EXPECT_EQ(context.report().entries().size(), 1u);
}

TEST(ThumbnailTextures, AJpegCountsAsAQuarter) {
    Context context;
    constexpr std::uint64_t all = 4 * (side * side / 4 + reduced_side * reduced_side);
    const auto has_normal_map = [&](std::uint64_t most_work) {
        return bool(
            with_thumbnail_textures(scene_of("jpg"), reduced_side, most_work, context).materials[0].normal_texture);
    };
    EXPECT_TRUE(has_normal_map(all));
    EXPECT_FALSE(has_normal_map(all - 1));
}

TEST(ThumbnailTextures, APictureThatIsBrokenCountsAsNothing) {
    Context context;
    Scene scene = scene_of("png");
    scene.textures[1].image = image_from_bytes(std::vector<std::byte>(5), "broken.png");
    EXPECT_EQ(with_thumbnail_textures(scene, reduced_side, 3 * work, context).materials, scene.materials);
}

TEST(Thumbnail, NeedsATime) {
    Context context;
    PictureRequest request;
    request.input = "builtin:teapot", request.output = "a.png";
    request.settings.width = request.settings.height = 32;
    for (const double seconds : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(test::error_of([&] { thumbnail(request, seconds, context); }).code(), ErrorCode::usage);
    EXPECT_GT(thumbnail(request, 1, context).size(), 100u);
}

}  // namespace
}  // namespace rakelight
