// SPDX-License-Identifier: Apache-2.0
// Compressed, sparse, shared and strip primitives with new normals.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include "unit/io/gltf/save_gltf_support.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::json;

/// A unit quad in z = 0 as Draco data.
std::vector<char> draco_quad() {
    const float corners[6][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    const int id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (std::uint32_t f = 0; f < 2; ++f)
        builder.SetAttributeValuesForFace(id, draco::FaceIndex(f), corners[3 * f], corners[3 * f + 1],
                                          corners[3 * f + 2]);
    const auto mesh = builder.Finalize();
    draco::Encoder encoder;
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    return {buffer.data(), buffer.data() + buffer.size()};
}

TEST(SaveGltf, DracoPrimitivesAreUnpackedAndTheExtensionIsNoLongerNamed) {
    GltfFile file;
    file.root["accessors"] = {{{"componentType", f32}, {"count", 4}, {"type", "VEC3"}, {"name", "where"}},
                              {{"componentType", u32}, {"count", 6}, {"type", "SCALAR"}}};
    Json& primitive = file.primitive(0);
    primitive["indices"] = 1;
    primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", file.view(draco_quad())},
                                                             {"attributes", {{"POSITION", 0}}}};
    primitive["extensions"]["ACME_kept"] = 5;
    file.root["extensionsUsed"] = {"KHR_draco_mesh_compression", "ACME_kept"};
    file.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    Context context({.threads = 1});
    Scene wanted;
    const Saved saved = save(file, context, [&](const Scene& scene) { return wanted = turned(scene); });
    EXPECT_TRUE(saved.result.changed);
    const Json& got = saved.tree["meshes"][0]["primitives"][0];
    EXPECT_EQ(got["extensions"], Json({{"ACME_kept", 5}}));
    EXPECT_EQ(saved.tree["extensionsUsed"], Json({"ACME_kept"}));
    EXPECT_FALSE(saved.tree.contains("extensionsRequired"));
    EXPECT_EQ(saved.tree["accessors"][got["attributes"]["POSITION"].get<std::size_t>()]["name"], "where");
    EXPECT_TRUE(std::equal(wanted.meshes[0].positions.begin(), wanted.meshes[0].positions.end(),
                           saved.scene.meshes[0].positions.begin()));
    EXPECT_EQ(saved.scene.meshes[0].normals[0], (vec3{0, 0, -1}));
    EXPECT_TRUE(is_said(context, Remark::changed, "Draco"));
}

TEST(SaveGltf, NormalsThatTwoPrimitivesShareChangeOnlyWhereTheyAreToChange) {
    GltfFile file;
    const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, f32, 3);
    const int normals = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, 3);
    for (int i = 0; i < 2; ++i) file.primitive(positions)["attributes"]["NORMAL"] = normals;
    Context context({.threads = 1});
    const Saved saved = save(file, context, [](Scene scene) {
        scene.meshes[1].normals = std::vector<vec3>(3, vec3{0, 0, -1});
        return scene;
    });
    const Json& list = saved.tree["meshes"][0]["primitives"];
    EXPECT_EQ(list[0]["attributes"]["NORMAL"], normals);
    EXPECT_NE(list[1]["attributes"]["NORMAL"], normals);
    EXPECT_EQ(saved.scene.meshes[0].normals[0], (vec3{0, 0, 1}));
    EXPECT_EQ(saved.scene.meshes[1].normals[0], (vec3{0, 0, -1}));
    EXPECT_FALSE(saved.result.primitives[0].changed);
    EXPECT_TRUE(saved.result.primitives[1].changed);
}

TEST(SaveGltf, EqualNormalsOfTwoPrimitivesAreStoredOnce) {
    GltfFile file;
    const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, f32, 3);
    for (int i = 0; i < 2; ++i) file.primitive(positions);
    Context context({.threads = 1});
    const Saved saved = save(file, context, turned);
    const Json& list = saved.tree["meshes"][0]["primitives"];
    EXPECT_EQ(list[0]["attributes"]["NORMAL"], list[1]["attributes"]["NORMAL"]);
    EXPECT_EQ(saved.tree["buffers"][1]["byteLength"], 36);
}

/// Vertex 2 split for the second triangle.
Scene split(Scene scene) {
    Mesh& mesh = scene.meshes[0];
    std::vector<vec3> positions(mesh.positions.begin(), mesh.positions.end());
    positions.push_back(positions[2]);
    std::vector<std::uint32_t> indices(mesh.indices.begin(), mesh.indices.end());
    for (std::size_t c = 3; c < 6; ++c)
        if (indices[c] == 2) indices[c] = std::uint32_t(positions.size() - 1);
    mesh.positions = std::move(positions);
    mesh.indices = std::move(indices);
    mesh.normals = std::vector<vec3>(mesh.positions.size(), vec3{0, 1, 0});
    return scene;
}

TEST(SaveGltf, AStripWhoseVerticesAreSplitBecomesAList) {
    GltfFile file;
    file.primitive(file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, f32, 3), {{"mode", 5}});
    Context context({.threads = 1});
    const Saved saved = save(file, context, split);
    const Json& got = saved.tree["meshes"][0]["primitives"][0];
    EXPECT_FALSE(got.contains("mode"));
    ASSERT_EQ(saved.scene.meshes[0].indices.size(), 6u);
    EXPECT_EQ(saved.scene.meshes[0].positions.size(), 5u);
    EXPECT_EQ(saved.scene.meshes[0].positions[4], (vec3{0, 1, 0}));
}

TEST(SaveGltf, SparseAttributesOfSplitVerticesAreWrittenOut) {
    GltfFile file;
    const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, f32, 3);
    const int at = file.view<std::uint16_t>({2}), with = file.view<float>({0, 9, 0});
    file.root["accessors"][std::size_t(positions)]["sparse"] = {
        {"count", 1}, {"indices", {{"bufferView", at}, {"componentType", u16}}}, {"values", {{"bufferView", with}}}};
    file.primitive(positions)["indices"] = file.accessor<std::uint16_t>({0, 1, 2, 1, 3, 2}, u16, 1);
    Context context({.threads = 1});
    const Saved saved = save(file, context, split);
    EXPECT_EQ(saved.scene.meshes[0].positions[2], (vec3{0, 9, 0}));
    EXPECT_EQ(saved.scene.meshes[0].positions[4], (vec3{0, 9, 0}));
    const Json& got = saved.tree["meshes"][0]["primitives"][0];
    EXPECT_FALSE(saved.tree["accessors"][got["attributes"]["POSITION"].get<std::size_t>()].contains("sparse"));
    EXPECT_EQ(saved.tree["accessors"][got["indices"].get<std::size_t>()]["componentType"], u16);
}

TEST(SaveGltf, TangentsThatGoTakeThoseOfMorphTargetsWithThem) {
    GltfFile file;
    const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, f32, 3);
    const int tangents = file.accessor<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, f32, 4);
    Json& primitive = file.primitive(positions);
    primitive["attributes"]["NORMAL"] = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, 3);
    primitive["attributes"]["TANGENT"] = tangents;
    primitive["targets"] = {{{"POSITION", positions}, {"NORMAL", positions}, {"TANGENT", positions}}};
    Context context({.threads = 1});
    const Saved saved = save(file, context, [](Scene scene) {
        for (Mesh& mesh : scene.meshes) mesh.tangents = {};
        return turned(scene);
    });
    const Json& got = saved.tree["meshes"][0]["primitives"][0];
    EXPECT_FALSE(got["attributes"].contains("TANGENT"));
    EXPECT_EQ(got["targets"], Json::array({{{"POSITION", positions}, {"NORMAL", positions}}}));
    EXPECT_TRUE(is_said(context, Remark::dropped, "tangents"));
    EXPECT_TRUE(is_said(context, Remark::warning, "morph targets"));
}

TEST(SaveGltf, DifferencesOfRoundingAreNoChange) {
    GltfFile file;
    Json& primitive = file.triangle();
    primitive["attributes"]["NORMAL"] = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, 3);
    Context context({.threads = 1});
    const Saved saved = save(file, context, [](Scene scene) {
        scene.meshes[0].normals = std::vector<vec3>(3, vec3{1e-7f, 0, 1});
        return scene;
    });
    EXPECT_FALSE(saved.result.changed);
    EXPECT_EQ(saved.tree, file.root);
}

}  // namespace
}  // namespace rakelight
