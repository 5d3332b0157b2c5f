// SPDX-License-Identifier: Apache-2.0
// EXT_meshopt_compression: new arrays are compressed where the old ones were, and come back to the bit.
#include <meshoptimizer.h>

#include "unit/io/gltf/save_gltf_support.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::json;

constexpr const char* extension = "EXT_meshopt_compression";

/// Two triangles over four vertices whose arrays are all compressed: normals (0, 0, 1) of 8 bits, indices of 16.
struct PackedQuad {
    explicit PackedQuad(bool has_fallback) {
        file.root["buffers"] = {nullptr, {{"byteLength", 0}, {"extensions", {{extension, {{"fallback", true}}}}}}};
        if (!has_fallback) file.root["buffers"].erase(1);
        file.root["extensionsUsed"] = {extension, "KHR_mesh_quantization"};
        file.root["extensionsRequired"] = {extension, "KHR_mesh_quantization"};
        const std::vector<float> place{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
        const std::vector<std::int8_t> up{0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0};
        add(packed(place, 12), "ATTRIBUTES", 12, 4, {{"componentType", f32}, {"type", "VEC3"}});
        add(packed(up, 4), "ATTRIBUTES", 4, 4, {{"componentType", i8}, {"normalized", true}, {"type", "VEC3"}});
        const unsigned int corners[6] = {0, 1, 2, 1, 3, 2};
        std::vector<unsigned char> bytes(meshopt_encodeIndexSequenceBound(6, 4));
        bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), corners, 6));
        add(bytes, "INDICES", 2, 6, {{"componentType", u16}, {"type", "SCALAR"}});
        Json& primitive = file.primitive(0);
        primitive["attributes"]["NORMAL"] = 1;
        primitive["indices"] = 2;
    }

    template <class T>
    static std::vector<unsigned char> packed(const std::vector<T>& values, std::size_t stride) {
        const std::size_t count = values.size() * sizeof(T) / stride;
        std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(count, stride));
        bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), values.data(), count, stride));
        return bytes;
    }

    void add(const std::vector<unsigned char>& bytes, const char* mode, std::size_t stride, std::size_t count,
             Json accessor) {
        const int view = file.view(bytes);
        Json& json = file.root["bufferViews"][std::size_t(view)];
        Json packing = {{"buffer", 0},
                        {"byteOffset", json["byteOffset"]},
                        {"byteLength", bytes.size()},
                        {"byteStride", stride},
                        {"mode", mode},
                        {"count", count}};
        Json& buffers = file.root["buffers"];
        if (buffers.size() > 1) {
            json["buffer"] = 1;
            json["byteOffset"] = buffers[1]["byteLength"];
            buffers[1]["byteLength"] = buffers[1]["byteLength"].get<std::size_t>() + stride * count;
        }
        json["byteLength"] = stride * count;
        if (stride == 4) json["byteStride"] = stride;
        json["extensions"] = {{extension, packing}};
        accessor["bufferView"] = view;
        accessor["count"] = count;
        file.root["accessors"].push_back(accessor);
    }
    GltfFile file;
};

const Json& view_of(const Saved& saved, const Json& accessor) {
    return saved
        .tree["bufferViews"][saved.tree["accessors"][accessor.get<std::size_t>()]["bufferView"].get<std::size_t>()];
}

Scene with_normals(Scene scene) {
    scene.meshes[0].normals = std::vector<vec3>(scene.meshes[0].positions.size(), vec3{0.6f, 0, 0.8f});
    return scene;
}

TEST(SaveGltfMeshopt, NewNormalsAreCompressedAsTheOldOnesWere) {
    for (const char* output : {"out.gltf", "out.glb"}) {
        PackedQuad quad(true);
        Context context({.threads = 1});
        const Saved saved = save(quad.file, context, with_normals, output);
        const Json& attributes = saved.tree["meshes"][0]["primitives"][0]["attributes"];
        EXPECT_EQ(attributes["POSITION"], 0);
        const Json& view = view_of(saved, attributes["NORMAL"]);
        const Json& packing = view["extensions"][extension];
        EXPECT_EQ(packing["mode"], "ATTRIBUTES");
        EXPECT_EQ(packing["count"], 4);
        EXPECT_EQ(view["byteStride"], packing["byteStride"]);
        EXPECT_EQ(view["byteLength"], 16);
        const Json& fallback = saved.tree["buffers"][view["buffer"].get<std::size_t>()];
        EXPECT_TRUE(fallback["extensions"][extension]["fallback"].get<bool>());
        EXPECT_EQ(fallback["byteLength"], view["byteOffset"].get<std::size_t>() + 16);
        EXPECT_EQ(saved.scene.meshes[0].normals[3], (vec3{76 / 127.0f, 0, 102 / 127.0f}));
        EXPECT_FALSE(is_said(context, Remark::changed, "meshopt"));
    }
}

TEST(SaveGltfMeshopt, SplitVerticesAndTheirIndicesAreCompressedInTheirOrder) {
    PackedQuad quad(true);
    Context context({.threads = 1});
    Scene wanted;
    const Saved saved = save(quad.file, context, [&](Scene scene) {
        Mesh& mesh = scene.meshes[0];
        std::vector<vec3> positions(mesh.positions.begin(), mesh.positions.end());
        positions.push_back(positions[1]);
        mesh.positions = std::move(positions);
        mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 4, 3, 2};
        return wanted = with_normals(std::move(scene));
    });
    const Json& primitive = saved.tree["meshes"][0]["primitives"][0];
    EXPECT_EQ(view_of(saved, primitive["attributes"]["POSITION"])["extensions"][extension]["count"], 5);
    EXPECT_EQ(view_of(saved, primitive["indices"])["extensions"][extension]["mode"], "INDICES");
    EXPECT_EQ(to_vector(saved.scene.meshes[0].indices), to_vector(wanted.meshes[0].indices));
    EXPECT_TRUE(std::equal(wanted.meshes[0].positions.begin(), wanted.meshes[0].positions.end(),
                           saved.scene.meshes[0].positions.begin(), saved.scene.meshes[0].positions.end()));
}

TEST(SaveGltfMeshopt, WithoutABufferForTheUnpackedDataItIsWrittenPlainAndSaid) {
    PackedQuad quad(false);
    Context context({.threads = 1});
    const Saved saved = save(quad.file, context, with_normals);
    EXPECT_FALSE(
        view_of(saved, saved.tree["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]).contains("extensions"));
    EXPECT_EQ(saved.scene.meshes[0].normals[3], (vec3{76 / 127.0f, 0, 102 / 127.0f}));
    EXPECT_TRUE(is_said(context, Remark::changed, "without meshopt compression"));
}

}  // namespace
}  // namespace rakelight
