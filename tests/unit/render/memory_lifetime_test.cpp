// SPDX-License-Identifier: Apache-2.0
// What a scene, its prepared form and its pictures take is given back with the last that holds it.
#include <gtest/gtest.h>
#include <rakelight/base/report.h>
#include <rakelight/render/picture.h>
#include <rakelight/render/render.h>

#include "engines/raster/raster_engine.h"
#include "io/pictures/image_io.h"
#include "support/temporary_folder.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

/// A folder with textured squares as OBJ, glTF and world.
class MemoryLifetime : public testing::Test {
protected:
    void SetUp() override {
        Pixels picture{side, side, 3, Component::u8, false, std::vector<std::byte>(3 * side * side)};
        for (std::size_t i = 0; i < picture.bytes.size(); ++i) picture.bytes[i] = std::byte(i % 251);
        io::write_image(path("picture.png"), picture);
        write("square.mtl", "newmtl m\nKd 1 1 1\nmap_Kd picture.png\n");
        write("square.obj",
              "mtllib square.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
              "usemtl m\nf 1/1 2/2 3/3 4/4\n");
        write("square.gltf", gltf);
        write("square.scene.toml",
              "[[model]]\nfile = 'square.obj'\nnormals = 'model'\n[[model]]\nfile = 'square.gltf'\n"
              "position = [0, 0, -1]\n[[primitive]]\ntype = 'sphere'\nradius = 0.5\n");
    }

    std::string path(const std::string& name) const { return folder_.file(name); }
    void write(const std::string& name, const std::string& text) { folder_.write(name, text); }

    static constexpr int side = 64;
    /// What its texture takes at least: two numbers of four bytes a texel, beside smaller levels and borders.
    static constexpr std::uint64_t texture_bytes = 8 * side * side;
    // A square (-1, -1, 0) to (1, 1, 0) with texture coordinates, 16-bit indices.
    static constexpr const char* gltf = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": "picture.png"}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                      {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                        {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
        "buffers": [{"byteLength": 92, "uri": "data:application/octet-stream;base64,AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAACAPwAAgD8AAAAAAACAvwAAgD8AAAAAAAAAAAAAgD8AAIA/AACAPwAAgD8AAAAAAAAAAAAAAAAAAAEAAgAAAAIAAwA="}]})";

    TemporaryFolder folder_;
    RenderSettings small_{.width = 16, .height = 12};
};

bool says_left_out(const Report& report) {
    for (const ReportEntry& e : report.entries())
        if (e.message.find("left out") != std::string::npos) return true;
    return false;
}

}  // namespace

TEST_F(MemoryLifetime, LoadingPreparingAndDrawingGivesAllBackWithTheLastOwner) {
    for (const char* name : {"square.obj", "square.gltf", "square.scene.toml"}) {
        Context context({.threads = 2});
        Scene kept;
        {
            const Scene scene = load(path(name), {}, context);
            const std::uint64_t loaded = context.memory().charged();
            EXPECT_GT(loaded, 4 * sizeof(vec3)) << name;
            const Scene prepared = prepare_scene(scene, {.normals = NormalSource::flat, .all_tangents = true}, context);
            EXPECT_GT(context.memory().charged(), loaded) << name;
            auto engine = raster::make_engine();
            engine->prepare(prepared, context);
            EXPECT_GT(context.memory().charged(), loaded + texture_bytes) << name;
            Frame frame;
            engine->render(choose_camera(prepared, {}, 1.5, context), small_, frame, context);
            kept.meshes = {prepared.meshes[0]};
        }
        const std::uint64_t of_one_mesh = context.memory().charged();
        EXPECT_GE(of_one_mesh, kept.meshes[0].positions.size() * sizeof(vec3)) << name;
        EXPECT_LT(of_one_mesh, 4096u) << name;
        kept = {};
        EXPECT_EQ(context.memory().charged(), 0u) << name;
    }
}

TEST_F(MemoryLifetime, WhatFailsGivesAllBack) {
    write("broken.obj", "mtllib square.mtl\nv 0 0 0\nf 7 8 9\n");
    std::string text = gltf;
    text.replace(text.find("\"byteOffset\": 80"), 16, "\"byteOffset\": 90");
    write("broken.gltf", text);
    write("broken.scene.toml", "[[model]]\nfile = 'square.obj'\n[[model]]\nfile = 'broken.obj'\n");
    for (const char* name : {"broken.obj", "broken.gltf", "broken.scene.toml"}) {
        Context context;
        EXPECT_THROW(load(path(name), {}, context), Error) << name;
        EXPECT_EQ(context.memory().charged(), 0u) << name;
    }
    for (std::uint64_t limit = 100; limit < 100'000; limit += limit / 4) {  // a refusal at every step
        Context context({.max_memory = limit});
        try {
            render(load(path("square.scene.toml"), {}, context), small_, context);
        } catch (const Error&) {
        }
        EXPECT_EQ(context.memory().charged(), 0u) << limit;
    }
}

TEST_F(MemoryLifetime, AWorldPaysForEachOfItsParts) {
    std::string objects = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", models, shapes, named;
    for (int i = 0; i < 300; ++i) objects += "o object " + std::to_string(i) + "\nf 1 2 3\n";
    for (int i = 0; i < 100; ++i) models += "[[model]]\nfile = 'objects.obj'\n";
    for (int i = 0; i < 30; ++i) shapes += "[[primitive]]\ntype = 'sphere'\ntolerance = 0.001\nobjects = 1024\n";
    named =
        "[[primitive]]\ntype = 'sphere'\ntolerance = 0.001\nobjects = 1024\nname = '" + std::string(8000, 'n') + "'\n";
    write("objects.obj", objects);
    for (const std::string& world : {models, shapes, named}) {
        write("many.scene.toml", world);
        Context enough, too_small({.max_memory = 8 << 20});
        {
            const Scene scene = load(path("many.scene.toml"), {}, enough);
            EXPECT_GT(enough.memory().charged(), scene.nodes.size() * (sizeof(Node) + sizeof(Mesh)));
            EXPECT_GT(enough.memory().charged(), 8u << 20);
        }
        EXPECT_EQ(enough.memory().charged(), 0u);
        EXPECT_THROW(load(path("many.scene.toml"), {}, too_small), Error);
        EXPECT_EQ(too_small.memory().charged(), 0u);
    }
}

TEST_F(MemoryLifetime, TwoThousandPicturesOfOneContextLeaveNoTextureOut) {
    Context context({.threads = 1, .max_memory = 1 << 20});
    Scene scene = prepare_scene(load(path("square.gltf"), {}, context), {}, context);
    const Camera camera = choose_camera(scene, {}, 1.5, context);
    auto engine = raster::make_engine();
    Frame frame;
    std::uint64_t after_first = 0;
    for (int i = 0; i < 2000; ++i) {
        Material& m = scene.materials[0];
        m.base_color.x = float(i % 100) / 100.0f;
        m.normal_texture = i % 3 == 1 ? m.base_color_texture : TextureUse{};  // the picture as data too
        engine->prepare(scene, context);
        engine->render(camera, small_, frame, context);
        if (i == 0) after_first = context.memory().charged();
        if (i % 3 == 0) {
            ASSERT_EQ(context.memory().charged(), after_first) << i;
        }
        ASSERT_LT(context.memory().charged(), after_first + texture_bytes) << i;
        ASSERT_FALSE(says_left_out(context.report())) << i;
    }
    engine.reset();
    scene = {};
    EXPECT_EQ(context.memory().charged(), 0u);
}

TEST_F(MemoryLifetime, AFileIsLoadedAndDrawnAgainAndAgainWithinTheSameMemory) {
    // The square without normals is smoothed beside the sphere's 11,000 vertices; a texture that stayed would take 16 MiB in all.
    Context context({.threads = 1, .max_memory = 4 << 20});
    for (int i = 0; i < 500; ++i) {
        const char* name = i % 2 == 0 ? "square.scene.toml" : "square.gltf";
        render(load(path(name), {}, context), small_, context);
        ASSERT_EQ(context.memory().charged(), 0u) << i;
        ASSERT_FALSE(says_left_out(context.report())) << i;
    }
}
