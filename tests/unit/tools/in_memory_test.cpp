// SPDX-License-Identifier: Apache-2.0
// Scenes and pictures that never were files, and files of scenes.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>

#include <rakelight/rakelight.h>

#include "io/pictures/image_io.h"
#include "support/shared.h"
#include "support/temporary_folder.h"
#include "support/thrown_error.h"
#include "unit/tools/smooth_file_support.h"

namespace rakelight {
namespace {

using namespace test;

std::vector<std::byte> file_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return {first, first + text.size()};
}

std::vector<std::byte> bytes_of_text(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

constexpr RenderSettings small = {.width = 48, .height = 36};

class InMemory : public testing::Test {
protected:
    const bool has_helper = use_import_helper();
    std::vector<vec4> drawn(const Scene& scene) { return render(scene, small, context).color; }
    void expect_as_file(const std::string& path) {
        const Scene from_file = load(path, {}, context), from_bytes = load(file_bytes(path), path, {}, context);
        EXPECT_EQ(from_bytes.source, path);
        EXPECT_EQ(from_bytes.nodes, from_file.nodes) << path;
        EXPECT_EQ(from_bytes.materials, from_file.materials) << path;
        EXPECT_EQ(drawn(from_bytes), drawn(from_file)) << path;
    }
    TemporaryFolder folder;
    Context context;
};

TEST_F(InMemory, AFileGivesTheSameSceneByItsBytes) {
    expect_as_file((source_dir() / "data/spot/spot_slab5.glb").string());
    expect_as_file((source_dir() / "data/cages/jack.obj").string());
    expect_as_file((source_dir() / "data/lighting/pbr.scene.toml").string());
}

TEST_F(InMemory, FormatsOfTheImportHelperTakeBytesAndLeaveNoFile) {
    if (!has_helper) GTEST_SKIP() << "this build has no import helper";
    expect_as_file(folder.write("t.x",
                                "xof 0303txt 0032\nMesh m {\n 3;\n 0.0;0.0;0.0;,\n 1.0;0.0;0.0;,\n 0.0;1.0;0.0;;\n "
                                "1;\n 3;0,1,2;;\n}\n"));
}

TEST_F(InMemory, WhatAModelNamesIsLookedForInItsFolder) {
    folder.write("m.mtl", "newmtl red\nKd 1 0 0\n");
    const auto obj = bytes_of_text("mtllib m.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Scene scene = load(obj, folder.file("there_is_no_such_file.obj"), {}, context);
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].base_color.x, 1);
    EXPECT_EQ(scene.materials[0].base_color.y, 0);
}

TEST_F(InMemory, BrokenBytesAreRefusedInTheNameOfTheirFile) {
    const auto refused = [&](std::string_view text, const std::string& name) {
        return error_of([&] { load(bytes_of_text(text), name, {}, context); });
    };
    EXPECT_EQ(refused("", "a.glb").what(), std::string("a.glb: the file is empty"));
    EXPECT_EQ(refused("glTF rubbish", "a.glb").code(), ErrorCode::bad_file);
    EXPECT_EQ(refused("glTF rubbish", "a.glb").file(), "a.glb");
    EXPECT_EQ(refused("# nothing", "a.obj").file(), "a.obj");
    EXPECT_EQ(refused("solid", "a.stl").file(), "a.stl");
    EXPECT_EQ(refused("[[primitive]]\ntype = 'cub'", "a.scene.toml").place(), "line 2, column 8");
    EXPECT_EQ(refused("what is this", "a").code(), ErrorCode::bad_file);
}

TEST_F(InMemory, BytesCountAgainstTheMemoryLimit) {
    Context small_context({.max_memory = 1000});
    EXPECT_EQ(error_of([&] { load(std::vector<std::byte>(5000), "a.obj", {}, small_context); }).code(),
              ErrorCode::bad_file);
}

Frame picture(vec4 background) {
    Context context;
    return render(load("builtin:sphere", {}, context), {.width = 33, .height = 21, .background = background}, context);
}

TEST_F(InMemory, EncodedFramesAreTheBytesOfSavedOnes) {
    for (const vec4 background : {vec4{0.1f, 0.2f, 0.3f, 1}, vec4{0, 0, 0, 0}}) {
        const Frame frame = picture(background);
        for (const std::string ending : {".png", ".jpg", ".webp", ".exr", ".hdr"}) {
            if (background.w == 0 && (ending == ".jpg" || ending == ".hdr")) {
                EXPECT_EQ(error_of([&] { encode(frame, ending); }).code(), ErrorCode::usage) << "it has no alpha";
                continue;
            }
            const ToneSettings tone{ToneMapping::agx, 0.5};
            save(frame, folder.file("a" + ending), tone);
            EXPECT_EQ(encode(frame, ending, tone), file_bytes(folder.file("a" + ending))) << ending;
        }
    }
    EXPECT_EQ(error_of([&] { encode(picture({}), ".gif"); }).code(), ErrorCode::usage);
    EXPECT_EQ(error_of([&] { encode(picture({}), "png"); }).code(), ErrorCode::usage);
    EXPECT_TRUE(error_of([&] { encode(picture({}), ".gif"); }).file().empty());
}

TEST_F(InMemory, DisplayValuesAreThoseOfThePng) {
    const Frame frame = picture({0, 0, 0, 0});
    const std::vector<std::uint32_t> codes = to_srgb8(frame, {ToneMapping::neutral, 1});
    const Pixels png = io::decode_image(encode(frame, ".png", {ToneMapping::neutral, 1}), context);
    ASSERT_EQ(png.channels, 4);
    ASSERT_EQ(codes.size() * 4, png.bytes.size());
    EXPECT_EQ(std::memcmp(codes.data(), png.bytes.data(), png.bytes.size()), 0);
    EXPECT_EQ(error_of([&] { to_srgb8(frame, {ToneMapping::none, 99}); }).code(), ErrorCode::usage);
}

/// A square that shows a texture.
Scene textured(ImageHandle image) {
    Context context;
    Scene scene = load("builtin:plane", {}, context);
    scene.textures.push_back({"t", std::move(image), {}});
    Material material;
    material.base_color_texture.texture = 0;
    scene.materials = {material};
    scene.meshes[0].material = 0;
    return scene;
}

Pixels checker() {
    Pixels pixels{.width = 2, .height = 2, .channels = 3};
    for (const int code : {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}) pixels.bytes.push_back(std::byte(code));
    return pixels;
}

TEST_F(InMemory, TexturesMayBePixelsOrBytes) {
    const Scene of_pixels = textured(image_from_pixels(checker(), "checker"));
    std::vector<std::byte> png;
    io::write_image({"c.png", png}, checker());
    const Scene of_bytes = textured(image_from_bytes(png, "checker"));
    std::ofstream(folder.file("c.png"), std::ios::binary)
        .write(reinterpret_cast<const char*>(png.data()), std::streamsize(png.size()));
    const Scene of_file = textured(image_from_file(folder.file("c.png")));
    EXPECT_EQ(drawn(of_pixels), drawn(of_bytes));
    EXPECT_EQ(drawn(of_pixels), drawn(of_file));
    EXPECT_NE(drawn(of_pixels), drawn(load("builtin:plane", {}, context)));
}

TEST_F(InMemory, PixelsThatAreNoPictureAreRefused) {
    const auto refused = [&](auto change) {
        Pixels pixels = checker();
        change(pixels);
        return error_of([&] { image_from_pixels(pixels, "odd"); }).code() == ErrorCode::usage;
    };
    EXPECT_TRUE(refused([](Pixels& p) { p.bytes.pop_back(); }));
    EXPECT_TRUE(refused([](Pixels& p) { p.width = 0, p.bytes.clear(); }));
    EXPECT_TRUE(refused([](Pixels& p) { p.height = -2; }));
    EXPECT_TRUE(refused([](Pixels& p) { p.channels = 5; }));
    EXPECT_TRUE(refused([](Pixels& p) { p.width = 1 << 30; }));
    EXPECT_TRUE(refused([](Pixels& p) { p.component = Component::f32; }));
    EXPECT_TRUE(refused([](Pixels& p) { p.component = Component(9), p.bytes.resize(4 * p.bytes.size()); }));
}

TEST_F(InMemory, ASavedSceneIsTheSameSceneAgain) {
    const Scene scene = textured(image_from_pixels(checker(), "checker"));
    save(scene, folder.file("a.glb"), context);
    const Scene again = load(folder.file("a.glb"), {}, context);
    ASSERT_EQ(again.textures.size(), 1u);
    EXPECT_EQ(again.textures[0].image->decode(*again.textures[0].image, context).bytes, checker().bytes);
    EXPECT_EQ(again.meshes[0].positions.size(), scene.meshes[0].positions.size());
    save(scene, folder.file("a.ply"), context);
    if (!has_helper) return;  // it reads PLY
    EXPECT_EQ(load(folder.file("a.ply"), {}, context).meshes[0].indices.size(), scene.meshes[0].indices.size());
}

TEST_F(InMemory, ASceneThatCannotBeSavedLeavesNoFile) {
    Scene scene = textured(image_from_pixels(checker(), "checker"));
    EXPECT_EQ(error_of([&] { save(scene, folder.file("a.fbx"), context); }).code(), ErrorCode::usage);
    EXPECT_EQ(error_of([&] { save(Scene(), folder.file("a.glb"), context); }).code(), ErrorCode::bad_file);
    scene.textures[0].image = std::make_shared<const EncodedImage>();
    EXPECT_NO_THROW(save(scene, folder.file("b.glb"), context)) << "a texture less";
    std::filesystem::remove(folder.file("b.glb"));
    scene.meshes[0].material = 7;
    EXPECT_EQ(error_of([&] { save(scene, folder.file("a.glb"), context); }).code(), ErrorCode::bad_file);
    EXPECT_TRUE(folder.is_empty());
}

TEST_F(InMemory, SettingsGoBeforeThoseOfAWorld) {
    const std::string world = folder.write("w.scene.toml",
                                           "[[primitive]]\ntype = 'sphere'\n[render]\nsamples = 4\nview = 'top'\n"
                                           "hdri-file = 'none.hdr'\nresolution = '64,32'\n");
    const RenderOverrides given{
        {{.key = "camera-position", .words = {"0,0,5"}}, {.key = "hdri-file", .words = {"other.hdr"}}},
        [](std::string_view key) { return key != "resolution"; }};
    const WorldRequest request = read_world_request(world, {}, given, context);
    EXPECT_EQ(request.picture.settings.samples, 4);
    EXPECT_EQ(request.picture.settings.width, RenderSettings().width) << "it is not wanted";
    EXPECT_EQ(request.picture.hdri_file, "other.hdr");
    EXPECT_TRUE(request.picture.view.side.empty()) << "the camera stands elsewhere";
    EXPECT_EQ(request.picture.load.overridden, (std::vector<std::string>{"view", "hdri-file"}));
    ASSERT_EQ(request.applied.size(), 1u);
    EXPECT_EQ(request.applied[0].key, "samples");
    const Error placed = at_world_value(Error(ErrorCode::usage, "too many").about("samples"), request);
    EXPECT_EQ(placed.what(), world + ": line 4, column 1: samples: too many");
}

TEST_F(InMemory, ASettingThatExcludesOneOfTheWorldNamesBoth) {
    const std::string world = folder.write("w.scene.toml", "[[primitive]]\ntype = 'sphere'\n[render]\nsamples = 4\n");
    const RenderOverrides given{{{.key = "visibility", .words = {"painter"}}}, {}};
    const Error error = error_of([&] { read_world_request(world, {}, given, context); });
    EXPECT_EQ(error.code(), ErrorCode::usage);
    EXPECT_NE(error.advice().find("'samples' is of "), std::string::npos) << error.what();
    EXPECT_NE(error.advice().find("'visibility' is given"), std::string::npos) << error.what();
}

TEST_F(InMemory, HalvesOfAWorldAreHeldAgainstTheOutput) {
    const std::string world =
        folder.write("w.scene.toml", "[[primitive]]\ntype = 'sphere'\n[render]\nexr-colors = 'half'\n");
    PictureRequest request = request_of_world(world, {}, context);
    request.settings.width = 8, request.settings.height = 6;
    request.output = folder.file("a.exr");
    EXPECT_NO_THROW(render_picture(request, context));
    request.output = folder.file("a.png");
    EXPECT_EQ(error_of([&] { render_picture(request, context); }).setting(), "exr-colors");
}

TEST_F(InMemory, ASceneThatIsThereIsDrawnAsItsFile) {
    PictureRequest request;
    request.input = "builtin:cone";
    request.materials.color = vec3{1, 0, 0};
    request.settings.width = 40, request.settings.height = 30;
    request.output = folder.file("file.png");
    render_picture(request, context);
    request.output = folder.file("scene.png");
    const PictureResult result = render_picture(load("builtin:cone", {}, context), request, context);
    EXPECT_EQ(file_bytes(folder.file("scene.png")), file_bytes(folder.file("file.png")));
    EXPECT_EQ(result.engine, "soft");
    Scene broken = load("builtin:cone", {}, context);
    broken.meshes[0].material = 9;
    EXPECT_EQ(error_of([&] { render_picture(broken, request, context); }).code(), ErrorCode::bad_file);
}

TEST_F(InMemory, ShadingThatIsGivenForAllTakesTheWorldsAway) {
    const std::string world = folder.write(
        "w.scene.toml", "[[primitive]]\ntype = 'sphere'\nshading = 'flat'\n[render]\nshading = 'gouraud'\n");
    const auto own = [&](std::vector<std::string> words) {
        const RenderOverrides given{{{.key = "shading", .words = std::move(words)}}, {}};
        return read_world_request(world, {}, given, context).picture.settings.material_shading;
    };
    EXPECT_FALSE(own({"phong"}));
    EXPECT_TRUE(own({"object:sphere=phong"}));
    EXPECT_TRUE(request_of_world(world, {}, context).settings.material_shading);
}

}  // namespace
}  // namespace rakelight
