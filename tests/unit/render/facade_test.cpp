// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/rakelight.h>

#include <limits>

#include "io/files/file.h"
#include "io/pictures/image_io.h"
#include "math/color.h"
#include "render/drawable.h"
#include "support/temporary_folder.h"
#include "unit/render/test_scene.h"

namespace rakelight {
namespace {

using test::two_squares;

RenderSettings small() { return {.width = 80, .height = 60}; }

TEST(Facade, TheExampleOfTheHeaderGivesAPictureOfTheTeapot) {
    Context context;
    Scene scene = load("builtin:teapot", {}, context);
    scene = smooth(scene, {.scope = Scope::model}, context);
    const Frame frame = render(scene, small(), context);
    ASSERT_EQ(frame.color.size(), 80u * 60u);
    EXPECT_FALSE(frame.color[30 * 80 + 40] == frame.color[0]);
    EXPECT_EQ(frame.color[0], small().background);
}

TEST(Facade, SmoothGivesEveryMeshNormalsAndLeavesTheOldSceneAlone) {
    Context context;
    const Scene before = load("builtin:teapot", {}, context);
    const Scene after = smooth(before, {}, context);
    ASSERT_EQ(before.meshes.size(), after.meshes.size());
    for (std::size_t i = 0; i < before.meshes.size(); ++i) {
        EXPECT_TRUE(before.meshes[i].normals.empty());
        EXPECT_EQ(after.meshes[i].normals.size(), after.meshes[i].positions.size());
    }
}

TEST(Facade, ACameraOfANodeSeesWhatTheSameCameraInTheWorldSees) {
    Context context;
    Scene scene = two_squares();
    scene.nodes.emplace_back();
    scene.nodes[2].local.translation = {0.3, 0.4, 5};
    Camera on_node, in_world;
    on_node.node = 2;
    in_world.to_world[3] = {0.3, 0.4, 5, 1};
    EXPECT_EQ(render(scene, on_node, small(), context).color, render(scene, in_world, small(), context).color);
}

TEST(Facade, ASavedFrameHoldsItsPixelsAndItsAlpha) {
    const test::TemporaryFolder folder;
    Context context;
    Frame frame;
    frame.begin(3, 2, {}, 0);
    for (std::size_t i = 0; i < 6; ++i) frame.color[i] = {float(i) / 5, 0, 1, 1};
    const auto decode = [&](const char* name) {
        save(frame, (folder / name).string());
        return io::decode_image(*io::read_file((folder / name).string(), context), context);
    };
    const Pixels opaque = decode("opaque.png");
    EXPECT_EQ(opaque.channels, 3);
    EXPECT_EQ(std::uint8_t(opaque.row(1)[3]), srgb8_from_linear(frame.color[4].x));
    frame.color[5].w = 0.5f;
    const Pixels with_alpha = decode("alpha.png");
    EXPECT_EQ(with_alpha.channels, 4);
    EXPECT_EQ(std::uint8_t(with_alpha.row(1)[11]), 128);
    EXPECT_THROW(save(frame, (folder / "a.txt").string()), Error);
}

TEST(Facade, UnknownEnginesAreRefusedByName) {
    EXPECT_EQ(make_engine("soft")->name(), "soft");
    try {
        make_engine("hard");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::usage);
        EXPECT_NE(std::string(error.what()).find("soft"), std::string::npos);
    }
}

TEST(Facade, WhatHasNoAreaFromAnySideIsNothingToDraw) {
    Context context;
    Scene scene = two_squares();
    EXPECT_TRUE(can_be_seen(scene));
    scene.nodes[0].local.scale = {0, 0, 0};
    EXPECT_TRUE(can_be_seen(scene));
    scene.nodes[1].local.scale = {1, 0, 1};  // a square seen edge on from everywhere: a line
    EXPECT_FALSE(can_be_seen(scene));
    EXPECT_THROW(render(scene, small(), context), Error);
    scene = two_squares();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (Mesh& mesh : scene.meshes) mesh.positions = std::vector<vec3>(4, vec3{0, 0, nan});
    EXPECT_FALSE(can_be_seen(scene));
    EXPECT_FALSE(can_be_seen(Scene{}));
    scene = two_squares();
    for (Node& node : scene.nodes) node.local.scale = {1e-100, 1e-100, 1e-100};
    EXPECT_TRUE(can_be_seen(scene));
}

TEST(Facade, BuildInfoNamesWhatIsInUse) {
    const BuildInfo info = build_info();
    EXPECT_EQ(info.version, RAKELIGHT_VERSION);
    EXPECT_EQ(info.engines.front(), "soft");
    EXPECT_EQ(info.isas.front(), "scalar");
    EXPECT_NE(std::find(info.isas.begin(), info.isas.end(), info.isa), info.isas.end());
    EXPECT_NE(info.model_formats.find("GLB"), std::string::npos);
    EXPECT_GE(info.threads, 1);
}

}  // namespace
}  // namespace rakelight
