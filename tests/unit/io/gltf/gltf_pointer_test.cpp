// SPDX-License-Identifier: Apache-2.0
// KHR_animation_pointer: what materials, lights and cameras are in the middle of a clip.
#include <rakelight/scene/motion.h>

#include <algorithm>
#include <cmath>

#include "io/gltf/write/glb_writer.h"
#include "support/scene_builder.h"
#include "unit/io/gltf/gltf_support.h"

namespace rakelight::test {
namespace {

using Json = GltfFile::Json;

/// A triangle with a material, a camera, and one light that two nodes have.
GltfFile model() {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 1}}}},
                               {"emissiveFactor", {0.5, 0.25, 1}},
                               {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}}};
    file.root["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"zfar", 10}}}},
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 4}, {"ymag", 2}, {"znear", 0}, {"zfar", 10}}}}};
    file.root["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}}, {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}}};
    const Json shines = {{"KHR_lights_punctual", {{"light", 1}}}};
    file.root["nodes"] = {
        {{"mesh", 0}}, {{"camera", 0}}, {{"camera", 1}}, {{"extensions", shines}}, {{"extensions", shines}}};
    file.root["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
    return file;
}

/// A channel with keys at 0 s and 2 s.
void add(GltfFile& file, const std::string& pointer, const std::vector<float>& values, std::size_t width,
         const char* interpolation = "LINEAR") {
    const int input = file.accessor<float>({0, 2}, f32, 1), output = file.accessor(values, f32, width);
    Json& clip = file.root["animations"][0];
    Json target = {{"path", "pointer"}};
    target["extensions"]["KHR_animation_pointer"]["pointer"] = pointer;
    clip["channels"].push_back({{"sampler", clip["samplers"].size()}, {"target", target}});
    clip["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
}

Scene at(GltfFile& file, double time_s) {
    Context context({.threads = 1});
    const Scene scene = file.load(context);
    for (const ReportEntry& entry : context.report().entries()) ADD_FAILURE() << entry.message;
    const ClipTime clip{0, time_s};
    return scene_at(scene, std::span(&clip, 1));
}

const std::string material = "/materials/0/", spot = "/extensions/KHR_lights_punctual/lights/1/",
                  transform = "pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/";

TEST(GltfPointer, NumbersOfMaterialsAreHalfWay) {
    GltfFile file = model();
    add(file, material + "pbrMetallicRoughness/baseColorFactor", {1, 0, 0, 1, 0, 0.5f, 0, 0.5f}, 4);
    add(file, material + "pbrMetallicRoughness/roughnessFactor", {0, 1}, 1);
    add(file, material + "alphaCutoff", {0.25f, 0.75f}, 1, "STEP");
    add(file, material + "extensions/KHR_materials_clearcoat/clearcoatFactor", {0, 1}, 1);
    add(file, material + "extensions/KHR_materials_sheen/sheenColorFactor", {0, 0, 0, 1, 0.5f, 0}, 3);
    add(file, material + transform + "offset", {0, 1, 3, 2}, 2);
    add(file, material + transform + "rotation", {0, 1}, 1);
    // Tangents of 0: a Hermite spline is 5 / 32 of the way after a quarter of the time.
    add(file, material + "normalTexture/scale", {0, 1, 0, 0, 2, 0}, 1, "CUBICSPLINE");
    const Material m = at(file, 1).materials[0];
    EXPECT_EQ(m.base_color, (vec4{0.5f, 0.25f, 0, 0.75f}));
    EXPECT_EQ(m.metallic_roughness.roughness, 0.5f);
    EXPECT_EQ(m.alpha_cutoff, 0.25f);
    EXPECT_EQ(m.metallic_roughness.clearcoat, 0.5f);
    EXPECT_EQ(m.metallic_roughness.sheen_color, (vec3{0.5f, 0.25f, 0}));
    EXPECT_EQ(m.base_color_texture.transform.offset, (vec2{1.5f, 1.5f}));
    EXPECT_EQ(m.base_color_texture.transform.rotation_rad, 0.5f);
    EXPECT_EQ(at(file, 0.5).materials[0].normal_scale, 1 + 5.0f / 32);
    EXPECT_EQ(at(file, 2).materials[0].alpha_cutoff, 0.75f);
}

TEST(GltfPointer, EmissionIsColorTimesStrengthWhicheverMoves) {
    GltfFile color = model();
    add(color, material + "emissiveFactor", {0, 0, 0, 1, 0.5f, 0.25f}, 3);
    EXPECT_EQ(at(color, 1).materials[0].emission, (vec3{2, 1, 0.5f}));
    GltfFile strength = model();
    add(strength, material + "extensions/KHR_materials_emissive_strength/emissiveStrength", {0, 8}, 1);
    EXPECT_EQ(at(strength, 1).materials[0].emission, (vec3{2, 1, 4}));
}

TEST(GltfPointer, ALightThatTwoNodesHaveMovesAtBoth) {
    GltfFile file = model();
    add(file, spot + "intensity", {10, 30}, 1);
    add(file, spot + "color", {1, 1, 1, 0, 1, 0.5f}, 3);
    add(file, spot + "range", {1, 3}, 1);
    add(file, spot + "spot/innerConeAngle", {0.5f, 0.75f}, 1);  // beyond the outer one as it stands
    add(file, spot + "spot/outerConeAngle", {1, 1.25f}, 1);
    add(file, "/extensions/KHR_lights_punctual/lights/0/intensity", {10, 30}, 1);  // which no node has
    const Scene scene = at(file, 1);
    ASSERT_EQ(scene.lights.size(), 2u);
    for (const Light& light : scene.lights) {
        EXPECT_EQ(light.intensity, 20);
        EXPECT_EQ(light.color, (vec3{0.5f, 1, 0.75f}));
        EXPECT_EQ(light.range, 2);
        EXPECT_EQ(light.inner_cone_rad, 0.625f);
        EXPECT_EQ(light.outer_cone_rad, 1.125f);
    }
}

TEST(GltfPointer, CamerasOpenAndTheirPlanesMoveTogether) {
    GltfFile file = model();
    add(file, "/cameras/0/perspective/yfov", {0.5f, 1}, 1);
    add(file, "/cameras/0/perspective/znear", {20, 40}, 1);  // beyond the far plane as it stands
    add(file, "/cameras/0/perspective/zfar", {100, 200}, 1);
    add(file, "/cameras/1/orthographic/xmag", {4, 12}, 1);
    add(file, "/cameras/1/orthographic/ymag", {2, 6}, 1);
    const Scene scene = at(file, 1);
    EXPECT_EQ(scene.cameras[0].vertical_fov_rad, 0.75);
    EXPECT_EQ(scene.cameras[0].z_near, 30);
    EXPECT_EQ(scene.cameras[0].z_far, 150);
    EXPECT_EQ(scene.cameras[1].half_height, 4);
    EXPECT_EQ(*scene.cameras[1].aspect, 2);
    EXPECT_FALSE(scene.cameras[1].half_width);
}

TEST(GltfPointer, NodesAndWeightsOfMeshesAreMoved) {
    GltfFile file = model();
    file.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    file.root["nodes"].push_back({{"mesh", 0}, {"weights", {0.125}}});
    file.root["scenes"][0]["nodes"].push_back(5);
    add(file, "/nodes/0/translation", {0, 0, 0, 2, 4, 6}, 3);
    add(file, "/meshes/0/weights", {0, 1}, 1);
    const Scene scene = at(file, 1);
    ASSERT_TRUE(scene.pose);
    EXPECT_EQ(scene.pose->local[0].translation, (dvec3{1, 2, 3}));
    EXPECT_EQ(test::values_of(scene.pose->morph_weights[0]), std::vector<float>{0.5f});
    EXPECT_EQ(test::values_of(scene.pose->morph_weights[5]), std::vector<float>{0.125f})
        << "a node's own weights go before the mesh's";
}

TEST(GltfPointer, IsNoUnknownExtensionAndWhatItCannotMoveIsSaidOnce) {
    GltfFile file = model();
    file.root["extensionsUsed"] = {"KHR_animation_pointer"};
    file.root["extensionsRequired"] = {"KHR_animation_pointer"};
    for (int node = 0; node < 3; ++node)
        add(file, "/nodes/" + std::to_string(node) + "/extensions/KHR_node_visibility/visible", {0, 1}, 1);
    add(file, "/cameras/1/perspective/yfov", {1, 1}, 1);
    add(file, material + "alphaCutoff", {0, 1}, 1);
    Context context({.threads = 1});
    const Scene scene = file.load(context);
    ASSERT_EQ(scene.animations.size(), 1u);
    EXPECT_EQ(scene.animations[0].channels.size(), 1u);
    const auto entries = context.report().entries();
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_EQ(entries[0].count, 3u);
    EXPECT_NE(entries[0].message.find("'/nodes/N/extensions/KHR_node_visibility/visible'"), std::string::npos);
    EXPECT_NE(entries[1].message.find("camera 1 has no perspective/yfov"), std::string::npos);
}

/// All channels, by what they move: their order is not that of the file.
std::vector<AnimationChannel> sorted_channels(const Scene& scene) {
    std::vector<AnimationChannel> all = scene.animations.at(0).channels;
    std::ranges::sort(all, {}, [](const AnimationChannel& c) { return std::tuple(c.path, c.element, c.property); });
    return all;
}

TEST(GltfPointer, WhatMovesComesBackFromAWrittenModel) {
    GltfFile file = model();
    add(file, material + "pbrMetallicRoughness/baseColorFactor", {1, 0, 0, 1, 0, 0.5f, 0, 0.5f}, 4);
    add(file, material + "emissiveFactor", {0, 0, 0, 2, 0.5f, 0.25f}, 3);  // 8 times what a factor may be
    add(file, material + "extensions/KHR_materials_clearcoat/clearcoatFactor", {0, 1}, 1);
    add(file, spot + "intensity", {10, 30}, 1, "STEP");
    add(file, spot + "spot/outerConeAngle", {0, 0.5f, 0, 0, 0.75f, 0}, 1, "CUBICSPLINE");
    add(file, "/cameras/0/perspective/yfov", {0.5f, 1}, 1);
    add(file, "/cameras/1/orthographic/ymag", {1, 2}, 1);
    const Scene scene = file.load();
    const TemporaryFolder folder;
    Context context({.threads = 1});
    io::write_glb(scene, folder.file("a.glb"), context);
    EXPECT_TRUE(context.report().entries().empty());
    const Scene back = io::read_scene(folder.file("a.glb"), {}, context);
    const auto wanted = sorted_channels(scene), got = sorted_channels(back);
    ASSERT_EQ(wanted.size(), 9u);
    ASSERT_EQ(got.size(), wanted.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        EXPECT_EQ(got[i].property, wanted[i].property);
        EXPECT_EQ(got[i].element, wanted[i].element);
        EXPECT_EQ(got[i].interpolation, wanted[i].interpolation);
        EXPECT_TRUE(std::ranges::equal(got[i].times, wanted[i].times));
        EXPECT_TRUE(std::ranges::equal(got[i].values, wanted[i].values)) << got[i].property;
    }
    EXPECT_EQ(back.materials[0].emission, scene.materials[0].emission);
}

TEST(GltfPointer, WhatGltfHasNoPlaceForIsSaidWhenItIsWritten) {
    GltfFile file = model();
    add(file, "/cameras/0/perspective/yfov", {0.5f, 1}, 1);
    Scene scene = file.load();
    AnimationChannel target = scene.animations[0].channels[0];
    target.property = "target", target.values = std::vector<float>{0, 0, 0, 1, 1, 1};
    scene.animations[0].channels.push_back(target);
    const TemporaryFolder folder;
    Context context({.threads = 1});
    io::write_glb(scene, folder.file("a.glb"), context);
    EXPECT_TRUE(is_said(context, Remark::dropped, "1 animation channel was left out"));
    EXPECT_EQ(io::read_scene(folder.file("a.glb"), {}, context).animations.at(0).channels.size(), 1u);
}

}  // namespace
}  // namespace rakelight::test
