// SPDX-License-Identifier: Apache-2.0
// Nodes, cameras, lights, skins and animations of glTF.
#include <limits>

#include "unit/io/gltf/gltf_support.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::json;

TEST(GltfNodes, ParentsComeBeforeTheirChildren) {
    GltfFile file;
    file.triangle();
    file.root["scenes"] = {{{"nodes", {3, 1}}}};
    file.root["nodes"] = {
        {{"mesh", 0}}, {{"name", "second root"}}, {{"children", {0}}}, {{"children", {2, 4}}}, Json::object()};
    const Scene scene = file.load();
    ASSERT_EQ(scene.nodes.size(), 5u);
    std::vector<std::uint32_t> order;
    for (std::uint32_t n = 0; n < 5; ++n) {
        order.push_back(scene.nodes[n].source_node);
        EXPECT_TRUE(scene.nodes[n].parent == no_index || scene.nodes[n].parent < n);
    }
    EXPECT_EQ(order, (std::vector<std::uint32_t>{3, 2, 0, 4, 1}));
    EXPECT_EQ(scene.nodes[4].name, "second root");
    EXPECT_EQ(scene.nodes[0].name, "node 3");
}

TEST(GltfNodes, OnlyTheDefaultSceneIsRead) {
    GltfFile file;
    file.triangle();
    file.root["scene"] = 1;
    file.root["scenes"] = {{{"nodes", {1}}}, {{"nodes", {0}}}};
    file.root["nodes"] = {{{"mesh", 0}}, {{"mesh", 77}}};  // the other scene is broken, which does not matter
    EXPECT_EQ(file.load().nodes.size(), 1u);
}

TEST(GltfNodes, WhatOtherScenesShowIsSaid) {
    GltfFile file;
    file.triangle();
    file.root["scenes"] = {{{"nodes", {0}}}, {{"nodes", {0, 1}}}, {{"nodes", {3}}}};
    file.root["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"mesh", 0}}, {{"mesh", 0}}, {{"mesh", 0}}};
    Context some({.threads = 1}), none({.threads = 1});
    EXPECT_EQ(file.load(some).nodes.size(), 1u);
    EXPECT_TRUE(is_said(some, Remark::dropped, "only the default scene is read: 2 nodes with a mesh are in other"));
    file.root["scenes"] = {{{"nodes", {0, 1}}}, {{"nodes", {0}}}};
    EXPECT_EQ(file.load(none).nodes.size(), 3u);
    EXPECT_FALSE(is_said(none, Remark::dropped, "only the default scene"));
}

TEST(GltfNodes, WithoutScenesAllRootsAreShown) {
    GltfFile file;
    file.triangle();
    file.root.erase("scene");
    file.root.erase("scenes");
    file.root["nodes"] = {{{"mesh", 0}}, {{"children", {0}}}, {{"mesh", 0}}};
    EXPECT_EQ(file.load().nodes.size(), 3u);
}

TEST(GltfNodes, CyclesAndSecondParentsAreRefused) {
    GltfFile file;
    file.triangle();
    file.root["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"children", {0}}}};
    EXPECT_NE(file.refusal().find("cycle"), std::string::npos);
    file.root["nodes"] = {{{"children", {1, 2}}}, {{"children", {3}}}, {{"children", {3}}}, {{"mesh", 0}}};
    EXPECT_NE(file.refusal().find("two parents"), std::string::npos);
    file.root["nodes"] = {{{"mesh", 0}, {"children", {9}}}};
    try {
        file.load();
        ADD_FAILURE() << "was not refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.place(), "node 0");
        EXPECT_NE(error.reason().find("node 9 does not exist"), std::string::npos);
    }
    file.root["nodes"] = {{{"mesh", 0}, {"children", std::vector<int>(100000, 1)}}, {{"name", "twice"}}};
    EXPECT_NE(file.refusal().find("two parents"), std::string::npos);
}

TEST(GltfNodes, MatricesAreDouble) {
    GltfFile file;
    file.triangle();
    const double far = 1234567890.123456;
    file.root["nodes"][0]["translation"] = {far, 0, 0};
    EXPECT_EQ(file.load().nodes[0].local.translation.x, far);
    file.root["nodes"][0].erase("translation");
    file.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0, far, 5, 6, 1};
    const Scene scene = file.load();
    ASSERT_TRUE(scene.nodes[0].local.matrix);
    EXPECT_EQ((*scene.nodes[0].local.matrix)[3].x, far);
    EXPECT_EQ((*scene.nodes[0].local.matrix)[1].y, 2);
}

TEST(GltfNodes, InstancesBecomeChildrenThatShareTheMesh) {
    GltfFile file;
    file.triangle();
    const int translation = file.accessor<float>({1, 0, 0, 2, 0, 0}, f32, 3),
              rotation = file.accessor<std::int8_t>({0, 0, 0, 127, 127, 0, 0, 0}, i8, 4, true);
    file.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", translation},
                                                                                    {"ROTATION", rotation}};
    const Scene scene = file.load();
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_TRUE(scene.nodes[0].meshes.empty());
    EXPECT_EQ(scene.nodes[2].parent, 0u);
    EXPECT_EQ(scene.nodes[2].meshes, scene.nodes[1].meshes);
    EXPECT_EQ(scene.nodes[2].local.translation.x, 2);
    EXPECT_EQ(scene.nodes[2].local.rotation, (dquat{1, 0, 0, 0}));
}

TEST(GltfNodes, ALongNameCountsForEachInstance) {
    GltfFile file;
    file.triangle();
    file.root["accessors"].push_back({{"componentType", f32}, {"count", 100000}, {"type", "VEC3"}});
    file.root["nodes"][0]["name"] = std::string(100000, 'n');
    file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", 1}};
    EXPECT_NE(file.refusal().find("more than the limit"), std::string::npos);
}

TEST(GltfNodes, InstancesThatAreNotFiniteAreRefused) {
    for (const char* name : {"TRANSLATION", "SCALE"}) {
        GltfFile file;
        file.triangle();
        const int numbers = file.accessor<float>({1, 0, std::numeric_limits<float>::infinity()}, f32, 3);
        file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"][name] = numbers;
        EXPECT_NE(file.refusal().find("not finite"), std::string::npos) << name;
    }
}

TEST(GltfCameras, AMissingFarPlaneIsInfinite) {
    GltfFile file;
    file.triangle();
    file.root["cameras"] =
        Json::parse(R"([{"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 1, "znear": 0, "zfar": 5}},
        {"type": "perspective", "perspective": {"yfov": 1, "znear": 0.5, "aspectRatio": 1.5}}])");
    file.root["nodes"] = {{{"mesh", 0}, {"camera", 1}, {"children", {1}}}, {{"camera", 0}}};
    const Scene scene = file.load();
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].projection, Projection::orthographic);
    EXPECT_EQ(scene.cameras[0].node, 1u);
    EXPECT_EQ(*scene.cameras[0].aspect, 2);
    EXPECT_EQ(scene.cameras[1].z_far, std::numeric_limits<double>::infinity());
    EXPECT_EQ(*scene.cameras[1].aspect, 1.5);
}

TEST(GltfCameras, BrokenOnesAreLeftOut) {
    for (const char* camera :
         {R"({})", R"({"type": "perspective", "perspective": {"yfov": 4, "znear": 1}})",
          R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 0}})",
          R"({"type": "orthographic", "orthographic": {"xmag": 0, "ymag": 1, "znear": 0, "zfar": 5}})",
          R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 2, "zfar": 1}})"}) {
        GltfFile file;
        file.triangle();
        file.root["cameras"] = {Json::parse(camera)};
        file.root["nodes"][0]["camera"] = 0;
        Context context({.threads = 1});
        EXPECT_TRUE(file.load(context).cameras.empty()) << camera;
        EXPECT_TRUE(is_said(context, Remark::dropped, "a camera is left out")) << camera;
    }
}

TEST(GltfCameras, SizesOutOfRangeAreNamedByTheirEnd) {
    for (const auto& [xmag, message] : {std::pair("0", "must not be zero"), {"1e300", "must be at most 1e30"}}) {
        GltfFile file;
        file.triangle();
        file.root["cameras"] = {
            Json::parse(R"({"type": "orthographic", "orthographic": {"ymag": 1, "znear": 0, "zfar": 5, "xmag": )" +
                        std::string(xmag) + "}}")};
        file.root["nodes"][0]["camera"] = 0;
        Context context({.threads = 1});
        file.load(context);
        EXPECT_TRUE(is_said(context, Remark::dropped, std::string("xmag and ymag ") + message)) << xmag;
    }
}

TEST(GltfLights, PunctualLightsStandAtTheirNodes) {
    GltfFile file;
    file.triangle();
    file.root["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(
        R"([{"type": "spot", "intensity": 5, "color": [1, 0.5, 0], "range": 9, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}}, {"type": "lamp"}])");
    file.root["nodes"] = Json::parse(
        R"([{"mesh": 0, "children": [1, 2]}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}, {"extensions": {"KHR_lights_punctual": {"light": 1}}}])");
    Context context({.threads = 1});
    const Scene scene = file.load(context);
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].units, LightUnits::photometric);
    EXPECT_EQ(scene.lights[0].type, LightType::spot);
    EXPECT_EQ(scene.lights[0].node, 1u);
    EXPECT_EQ(scene.lights[0].color, (vec3{1, 0.5f, 0}));
    EXPECT_EQ(scene.lights[0].range, 9);
    EXPECT_EQ(scene.lights[0].outer_cone_rad, 0.2f);
    EXPECT_TRUE(is_said(context, Remark::dropped, "a light is left out"));
}

GltfFile skinned(int joint) {
    GltfFile file;
    auto& attributes = file.triangle()["attributes"];
    const auto j = std::uint8_t(joint);
    attributes["JOINTS_0"] =
        file.accessor<std::uint8_t>({j, 99, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, u8, 4);  // 99 has no weight
    attributes["WEIGHTS_0"] = file.accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, f32, 4);
    file.root["nodes"] = Json::parse(R"([{"mesh": 0, "skin": 0, "children": [1]}, {"children": [2]}, {}])");
    file.root["skins"] = {{{"joints", {1, 2}}}};
    return file;
}

TEST(GltfSkins, JointsAreNodesOfTheScene) {
    GltfFile file = skinned(1);
    std::vector<float> matrices(32, 0.0f);
    for (const int k : {0, 5, 10, 15, 16, 21, 26, 31}) matrices[std::size_t(k)] = 1;
    matrices[28] = 7;  // translation x of the second
    file.root["skins"][0]["inverseBindMatrices"] = file.accessor(matrices, f32, 16);
    const Scene scene = file.load();
    ASSERT_EQ(scene.skins.size(), 1u);
    EXPECT_EQ(scene.nodes[0].skin, 0u);
    EXPECT_EQ(scene.skins[0].joints, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(scene.skins[0].inverse_bind[1][3].x, 7);
    EXPECT_EQ(scene.meshes[0].influences[0].joints[1], 0);
}

TEST(GltfSkins, BindMatricesOfOneAccessorAreReadOnce) {
    GltfFile file = skinned(1);
    std::vector<float> matrices(32, 0.0f);
    for (const int k : {0, 5, 10, 15, 16, 21, 26, 31}) matrices[std::size_t(k)] = 1;
    const int bind = file.accessor(matrices, f32, 16);
    file.root["nodes"] = Json::parse(R"([{"mesh": 0, "skin": 0, "children": [1]}, {"children": [2]}, {},
                                         {"mesh": 0, "skin": 1}, {"mesh": 0, "skin": 2}, {"mesh": 0, "skin": 3}])");
    file.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", bind}},
                          {{"joints", {2, 1}}, {"inverseBindMatrices", bind}},
                          {{"joints", {1, 2}}},
                          {{"joints", {2, 1}}}};
    file.root["scenes"] = {{{"nodes", {0, 3, 4, 5}}}};
    const Scene scene = file.load();
    ASSERT_EQ(scene.skins.size(), 4u);
    EXPECT_EQ(scene.skins[0].inverse_bind, scene.skins[1].inverse_bind);
    EXPECT_EQ(scene.skins[2].inverse_bind, scene.skins[3].inverse_bind);
    EXPECT_EQ(scene.skins[3].inverse_bind[1], dmat4{});
}

TEST(GltfSkins, AJointBeyondTheSkinIsRefused) { EXPECT_NE(skinned(2).refusal().find("joint 2"), std::string::npos); }

TEST(GltfSkins, ASkinWithJointsOutsideTheSceneIsLeftOut) {
    GltfFile file = skinned(1);
    file.root["nodes"][1].erase("children");
    Context context({.threads = 1});
    const Scene scene = file.load(context);
    EXPECT_TRUE(scene.skins.empty());
    EXPECT_EQ(scene.nodes[0].skin, no_index);
    EXPECT_TRUE(is_said(context, Remark::dropped, "skin 0 is left out"));
}

GltfFile animated(const char* path, const char* interpolation, int width, int numbers) {
    GltfFile file;
    file.triangle();
    const int times = file.accessor<float>({0, 1}, f32, 1),
              values = file.accessor(std::vector<float>(std::size_t(numbers), 0.5f), f32, std::size_t(width));
    file.root["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
         {"samplers", {{{"input", times}, {"output", values}, {"interpolation", interpolation}}}}}};
    return file;
}

TEST(GltfAnimations, ChannelsHaveTheirKeys) {
    const Scene scene = animated("rotation", "CUBICSPLINE", 4, 24).load();
    ASSERT_EQ(scene.animations.size(), 1u);
    const AnimationChannel& channel = scene.animations[0].channels[0];
    EXPECT_EQ(channel.path, AnimationPath::rotation);
    EXPECT_EQ(channel.interpolation, Interpolation::cubic_spline);
    EXPECT_EQ(channel.times.size(), 2u);
    EXPECT_EQ(channel.values.size(), 24u);
    EXPECT_EQ(animated("scale", "STEP", 3, 6).load().animations.size(), 1u);
}

// Checked once, these are a blink; checked for each channel they would take minutes.
TEST(GltfAnimations, ManyChannelsOverOneLargeSamplerAreReadInTheTimeOfOne) {
    GltfFile file = animated("weights", "LINEAR", 1, 2);
    file.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    file.root["accessors"].push_back({{"componentType", f32}, {"count", 4000000}, {"type", "SCALAR"}});
    const auto zeros = file.root["accessors"].size() - 1;
    auto& animation = file.root["animations"][0];
    animation["samplers"] = {{{"input", zeros}, {"output", zeros}}};
    animation["channels"] = std::vector<GltfFile::Json>(20000, animation["channels"][0]);
    const Scene scene = file.load();
    ASSERT_EQ(scene.animations.size(), 1u);
    EXPECT_EQ(scene.animations[0].channels.size(), 20000u);
    EXPECT_EQ(scene.animations[0].channels[19999].times.data(), scene.animations[0].channels[0].times.data());
}

TEST(GltfAnimations, BrokenChannelsAreLeftOut) {
    std::vector<GltfFile> files = {animated("rotation", "LINEAR", 4, 4), animated("weights", "LINEAR", 1, 2),
                                   animated("pointer", "LINEAR", 1, 2), animated("scale", "BEZIER", 3, 6),
                                   animated("translation", "CUBICSPLINE", 3, 6)};
    files.push_back(animated("scale", "LINEAR", 3, 6));
    const float backwards[] = {1, 0};  // the two key times stand after the triangle
    std::memcpy(files.back().data.data() + 36, backwards, 8);
    for (GltfFile& file : files) {
        Context context({.threads = 1});
        EXPECT_TRUE(file.load(context).animations.at(0).channels.empty());
        EXPECT_TRUE(is_said(context, Remark::dropped, "an animation channel is left out"));
    }
}

}  // namespace
}  // namespace rakelight
