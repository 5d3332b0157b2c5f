// SPDX-License-Identifier: Apache-2.0
// Nodes, materials, textures, cameras, lights, skins, animations, and the containers of glTF.
#include <cmath>
#include <limits>

#include "gltf_support.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::json;

TEST(GltfNodes, ParentsComeBeforeTheirChildren) {
    GltfFile file;
    file.triangle();
    file.root["scenes"] = {{{"nodes", {3, 1}}}};
    file.root["nodes"] = {{{"mesh", 0}}, {{"name", "second root"}}, {{"children", {0}}}, {{"children", {2, 4}}}, Json::object()};
    const Scene scene = file.load();
    ASSERT_EQ(scene.nodes.size(), 5u);
    std::vector<std::uint32_t> order;
    for (std::uint32_t n = 0; n < 5; ++n) {
        order.push_back(scene.nodes[n].source_node);
        EXPECT_TRUE(scene.nodes[n].parent == none || scene.nodes[n].parent < n);
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
    EXPECT_NE(file.refusal().find("node 9 does not exist"), std::string::npos);
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
    const int translation = file.accessor<float>({1, 0, 0, 2, 0, 0}, f32, 3), rotation = file.accessor<std::int8_t>({0, 0, 0, 127, 127, 0, 0, 0}, i8, 4, true);
    file.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", translation}, {"ROTATION", rotation}};
    const Scene scene = file.load();
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_TRUE(scene.nodes[0].meshes.empty());
    EXPECT_EQ(scene.nodes[2].parent, 0u);
    EXPECT_EQ(scene.nodes[2].meshes, scene.nodes[1].meshes);
    EXPECT_EQ(scene.nodes[2].local.translation.x, 2);
    EXPECT_EQ(scene.nodes[2].local.rotation, (dquat{1, 0, 0, 0}));
}

TEST(GltfMaterials, DefaultsAreThoseOfTheSpecification) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = {Json::object()};
    const Scene scene = file.load();
    ASSERT_EQ(scene.materials.size(), 1u);
    const Material& m = scene.materials[0];
    EXPECT_EQ(m.name, "material 0");
    EXPECT_EQ(m.model, MaterialModel::metallic_roughness);
    EXPECT_EQ(m.base_color, (vec4{1, 1, 1, 1}));
    EXPECT_EQ(m.metallic_roughness.metallic, 1);
    EXPECT_EQ(m.metallic_roughness.roughness, 1);
    EXPECT_EQ(m.alpha_cutoff, 0.5f);
    EXPECT_FALSE(m.double_sided);
}

TEST(GltfMaterials, ExtensionsAreRead) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = Json::parse(R"([{"emissiveFactor": [0.5, 0.25, 0], "alphaMode": "MASK", "alphaCutoff": 0.75, "doubleSided": true,
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}, "KHR_materials_ior": {"ior": 1.25},
        "KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [1, 2, 3]}, "KHR_materials_anisotropy": {"anisotropyStrength": 0.5, "anisotropyRotation": 1},
        "KHR_materials_unlit": {}}}])");
    const Material m = file.load().materials[0];
    EXPECT_EQ(m.emission, (vec3{4, 2, 0}));
    EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
    EXPECT_EQ(m.alpha_cutoff, 0.75f);
    EXPECT_TRUE(m.double_sided);
    EXPECT_EQ(m.model, MaterialModel::unlit);
    EXPECT_EQ(m.metallic_roughness.ior, 1.25f);
    EXPECT_EQ(m.metallic_roughness.specular, 0.5f);
    EXPECT_EQ(m.metallic_roughness.specular_color, (vec3{1, 2, 3}));
    EXPECT_EQ(m.metallic_roughness.anisotropy, 0.5f);
    EXPECT_EQ(m.metallic_roughness.anisotropy_rotation_rad, 1);
}

TEST(GltfMaterials, SpecularGlossinessKeepsItsReflectance) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = Json::parse(R"([{"extensions": {"KHR_materials_pbrSpecularGlossiness":
        {"diffuseFactor": [0.5, 0.5, 0.5, 1], "specularFactor": [0.2, 0.1, 0.04], "glossinessFactor": 0.75}}}])");
    Context context({.threads = 1});
    const Material m = file.load(context).materials[0];
    EXPECT_EQ(m.base_color, (vec4{0.5f, 0.5f, 0.5f, 1}));
    EXPECT_EQ(m.metallic_roughness.metallic, 0);
    EXPECT_EQ(m.metallic_roughness.roughness, 0.25f);
    EXPECT_NEAR(m.metallic_roughness.specular_color.x * 0.04, 0.2, 1e-6);
    EXPECT_TRUE(is_said(context, Remark::changed, "specular-glossiness"));
}

TEST(GltfMaterials, ValuesOutOfRangeAreMovedAndSaid) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = Json::parse(R"([{"pbrMetallicRoughness": {"metallicFactor": 7, "baseColorFactor": [1.00000012, -3, 1, 1]}}])");
    Context context({.threads = 1});
    const Material m = file.load(context).materials[0];
    EXPECT_EQ(m.metallic_roughness.metallic, 1);
    EXPECT_EQ(m.base_color, (vec4{1, 0, 1, 1}));
    EXPECT_TRUE(is_said(context, Remark::changed, "metallicFactor"));
}

GltfFile textured(const char* textures, const char* images, const char* info = R"({"index": 0})") {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = {{{"normalTexture", Json::parse(info)}}};
    file.root["textures"] = Json::parse(textures);
    file.root["images"] = Json::parse(images);
    return file;
}

constexpr const char* embedded_image = R"([{"uri": "data:image/png;base64,AAAA"}])";

TEST(GltfTextures, TransformsAndTheirCoordinateSetAreRead) {
    GltfFile file = textured(R"([{"source": 0}])", embedded_image,
                             R"({"index": 0, "texCoord": 1, "scale": 0.5, "extensions": {"KHR_texture_transform": {"offset": [1, 2], "rotation": 0.5, "scale": [3, 4], "texCoord": 2}}})");
    const Scene scene = file.load();
    const TextureUse& use = scene.materials[0].normal_texture;
    ASSERT_TRUE(use);
    EXPECT_EQ(use.texcoord_set, 2u);
    EXPECT_EQ(use.transform.offset, (vec2{1, 2}));
    EXPECT_EQ(use.transform.scale, (vec2{3, 4}));
    EXPECT_EQ(use.transform.rotation_rad, 0.5f);
    EXPECT_EQ(scene.materials[0].normal_scale, 0.5f);
    ASSERT_TRUE(scene.textures[0].image->bytes);
    EXPECT_EQ(scene.textures[0].image->bytes->size(), 3u);
}

TEST(GltfTextures, SamplersHaveTheDefaultsAndTheWordsOfTheSpecification) {
    GltfFile file = textured(R"([{"source": 0}])", embedded_image);
    EXPECT_EQ(file.load().textures[0].sampler, Sampler{});
    file.root["textures"][0]["sampler"] = 0;
    file.root["samplers"] = Json::parse(R"([{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728, "minFilter": 9985}])");
    const Sampler expected{Wrap::clamp_to_edge, Wrap::mirrored_repeat, Filter::nearest, Filter::linear, MipFilter::nearest};
    EXPECT_EQ(file.load().textures[0].sampler, expected);
}

TEST(GltfTextures, WebpIsPreferredAndBasisIsNotSupported) {
    GltfFile webp = textured(R"([{"source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}}])",
                             R"([{"uri": "data:,a"}, {"uri": "data:image/webp,bcd", "name": "webp"}])");
    EXPECT_EQ(webp.load().textures[0].image->name, "webp");
    GltfFile basis = textured(R"([{"extensions": {"KHR_texture_basisu": {"source": 0}}}])", embedded_image);
    Context context({.threads = 1});
    const Scene scene = basis.load(context);
    EXPECT_FALSE(scene.materials[0].normal_texture);
    EXPECT_TRUE(is_said(context, Remark::dropped, "KHR_texture_basisu"));
}

TEST(GltfTextures, ReferencesThatCannotBeUsedAreLeftOut) {
    for (const char* uri : {"../secret.png", "/etc/passwd", "http://example.org/x.png", "file:///etc/passwd", "missing.png", ".", "", "data:image/png;base64,@@@@"}) {
        GltfFile file = textured(R"([{"source": 0}])", "[{}]");
        file.root["images"][0]["uri"] = uri;
        Context context({.threads = 1});
        const Scene scene = file.load(context);
        EXPECT_FALSE(scene.materials[0].normal_texture) << uri;
        EXPECT_TRUE(scene.textures.empty()) << uri;
        EXPECT_TRUE(is_said(context, Remark::dropped, "normalTexture is left out")) << uri;
    }
}

TEST(GltfTextures, PercentEncodedNamesAreFound) {
    const TestFolder folder;
    folder.write("two words.png", "x");
    GltfFile file = textured(R"([{"source": 0}])", R"([{"uri": "two%20words.png"}])");
    folder.write("data.bin", file.data);
    Context context({.threads = 1});
    const Scene scene = io::read_gltf(folder.write("model.gltf", file.text()), {}, context);
    ASSERT_TRUE(scene.materials[0].normal_texture);
    EXPECT_TRUE(scene.textures[0].image->path.ends_with("two words.png"));
}

TEST(GltfCameras, AMissingFarPlaneIsInfinite) {
    GltfFile file;
    file.triangle();
    file.root["cameras"] = Json::parse(R"([{"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 1, "znear": 0, "zfar": 5}},
        {"type": "perspective", "perspective": {"yfov": 1, "znear": 0.5, "aspectRatio": 1.5}}])");
    file.root["nodes"] = {{{"mesh", 0}, {"camera", 1}, {"children", {1}}}, {{"camera", 0}}};
    const Scene scene = file.load();
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].projection, Projection::orthographic);
    EXPECT_EQ(scene.cameras[0].node, 1u);
    EXPECT_EQ(*scene.cameras[0].aspect, 2);
    EXPECT_EQ(scene.cameras[1].far, std::numeric_limits<double>::infinity());
    EXPECT_EQ(*scene.cameras[1].aspect, 1.5);
}

TEST(GltfCameras, BrokenOnesAreLeftOut) {
    for (const char* camera : {R"({})", R"({"type": "perspective", "perspective": {"yfov": 4, "znear": 1}})", R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 0}})",
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

TEST(GltfLights, PunctualLightsStandAtTheirNodes) {
    GltfFile file;
    file.triangle();
    file.root["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(
        R"([{"type": "spot", "intensity": 5, "color": [1, 0.5, 0], "range": 9, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}}, {"type": "lamp"}])");
    file.root["nodes"] = Json::parse(R"([{"mesh": 0, "children": [1, 2]}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}, {"extensions": {"KHR_lights_punctual": {"light": 1}}}])");
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
    attributes["JOINTS_0"] = file.accessor<std::uint8_t>({j, 99, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, u8, 4);  // 99 has no weight
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

TEST(GltfSkins, AJointBeyondTheSkinIsRefused) { EXPECT_NE(skinned(2).refusal().find("joint 2"), std::string::npos); }

TEST(GltfSkins, ASkinWithJointsOutsideTheSceneIsLeftOut) {
    GltfFile file = skinned(1);
    file.root["nodes"][1].erase("children");
    Context context({.threads = 1});
    const Scene scene = file.load(context);
    EXPECT_TRUE(scene.skins.empty());
    EXPECT_EQ(scene.nodes[0].skin, none);
    EXPECT_TRUE(is_said(context, Remark::dropped, "skin 0 is left out"));
}

GltfFile animated(const char* path, const char* interpolation, int width, int numbers) {
    GltfFile file;
    file.triangle();
    const int times = file.accessor<float>({0, 1}, f32, 1), values = file.accessor(std::vector<float>(std::size_t(numbers), 0.5f), f32, std::size_t(width));
    file.root["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
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

TEST(GltfAnimations, BrokenChannelsAreLeftOut) {
    std::vector<GltfFile> files = {animated("rotation", "LINEAR", 4, 4), animated("weights", "LINEAR", 1, 2), animated("pointer", "LINEAR", 1, 2),
                                   animated("scale", "BEZIER", 3, 6), animated("translation", "CUBICSPLINE", 3, 6)};
    files.push_back(animated("scale", "LINEAR", 3, 6));
    const float backwards[] = {1, 0};  // the two key times stand after the triangle
    std::memcpy(files.back().data.data() + 36, backwards, 8);
    for (GltfFile& file : files) {
        Context context({.threads = 1});
        EXPECT_TRUE(file.load(context).animations.empty());
        EXPECT_TRUE(is_said(context, Remark::dropped, "an animation channel is left out"));
    }
}

std::string read_error(const std::string& bytes, const char* name = "model.glb") {
    const TestFolder folder;
    Context context({.threads = 1});
    try {
        io::read_gltf(folder.write(name, bytes), {}, context);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string chunk(const char* type, std::string body) {
    const auto size = std::uint32_t(body.size());
    return std::string(reinterpret_cast<const char*>(&size), 4) + std::string(type, 4) + body;
}

std::string glb(const std::string& chunks, int extra = 0) {
    const std::uint32_t version = 2, length = std::uint32_t(12 + int(chunks.size()) + extra);
    return "glTF" + std::string(reinterpret_cast<const char*>(&version), 4) + std::string(reinterpret_cast<const char*>(&length), 4) + chunks;
}

TEST(GltfContainer, ABinaryChunkIsTheFirstBuffer) {
    GltfFile file;
    file.triangle();
    file.root["buffers"] = {{{"byteLength", 36}}};
    const std::string whole = glb(chunk("JSON", file.root.dump()) + chunk("more", "?") + chunk(std::string("BIN\0", 4).c_str(), file.data));
    EXPECT_EQ(read_error(whole), "");
    for (std::size_t size = 0; size < whole.size(); size += 7) EXPECT_NE(read_error(whole.substr(0, size)), "") << size;
    file.root["buffers"][0]["byteLength"] = 37;
    EXPECT_NE(read_error(glb(chunk("JSON", file.root.dump()) + chunk(std::string("BIN\0", 4).c_str(), file.data))).find("byteLength says 37"), std::string::npos);
}

TEST(GltfContainer, LengthsAreHeldAgainstTheFile) {
    EXPECT_NE(read_error(glb(chunk("JSON", "{}"), 1)).find("cut short"), std::string::npos);
    EXPECT_NE(read_error(glb(chunk("JSON", "{}      "), -4)).find("GLB chunk 0: needs"), std::string::npos);
    EXPECT_NE(read_error(glb("")).find("too few"), std::string::npos);
    EXPECT_NE(read_error(""), "");
}

TEST(GltfJson, DeepNestingIsRefusedAtOnce) {
    for (const char* open : {"[", "{\"a\":"}) {
        std::string text = "{\"asset\":{\"version\":\"2.0\"},\"extras\":";
        for (int i = 0; i < 200000; ++i) text += open;
        EXPECT_NE(read_error(text, "deep.gltf").find("nested more than"), std::string::npos);
    }
}

TEST(GltfJson, WhatIsNoJsonIsRefused) {
    for (const char* text : {"{", "{}{}", "{\"a\":NaN}", "{\"a\":1e400}", "{\"a\":01}", "{\"a\":\"\xFF\"}", "{\"a\":1,}", "[]", "null", " "})
        EXPECT_NE(read_error(text, "bad.gltf"), "") << text;
}

TEST(GltfJson, ANameThatStandsTwiceIsSaidAndTheLastCounts) {
    GltfFile file;
    file.triangle();
    const TestFolder folder;
    std::string text = file.text();
    text.insert(1, "\"scene\": 5, ");
    folder.write("data.bin", file.data);
    Context context({.threads = 1});
    EXPECT_EQ(io::read_gltf(folder.write("model.gltf", text), {}, context).nodes.size(), 1u);
    EXPECT_TRUE(is_said(context, Remark::warning, "stands twice"));
}

TEST(GltfJson, RequiredExtensionsThatAreUnknownAreNamed) {
    GltfFile file;
    file.triangle();
    file.root["extensionsRequired"] = {"VENDOR_new"};
    EXPECT_NE(file.refusal().find("VENDOR_new"), std::string::npos);
    file.root.erase("extensionsRequired");
    file.root["extensionsUsed"] = {"VENDOR_new"};
    Context context({.threads = 1});
    file.load(context);
    EXPECT_TRUE(is_said(context, Remark::dropped, "VENDOR_new"));
}

TEST(GltfBuffers, BrokenReferencesAreRefused) {
    for (const char* uri : {"../data.bin", "/etc/passwd", "http://example.org/a.bin", "", "data:;base64,@", "data:;base64"}) {
        GltfFile file;
        file.triangle();
        file.root["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        const TestFolder folder;
        const std::string path = folder.write("model.gltf", file.root.dump());
        Context context({.threads = 1});
        EXPECT_THROW(io::read_gltf(path, {}, context), Error) << uri;
    }
}

}  // namespace
}  // namespace rakelight
