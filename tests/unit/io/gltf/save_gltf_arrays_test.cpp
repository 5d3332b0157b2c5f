// SPDX-License-Identifier: Apache-2.0
// Where new normals and tangents go and in which type: integers stay integers, own arrays are overwritten, others are
// not.
#include <cmath>

#include "unit/io/gltf/save_gltf_support.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::json;

constexpr vec3 slanted{0.36f, 0.48f, 0.8f};

/// Every vertex gets the normal `n`.
auto with_normal(vec3 n) {
    return [n](Scene scene) {
        for (Mesh& mesh : scene.meshes) mesh.normals = std::vector<vec3>(mesh.positions.size(), n);
        return scene;
    };
}

int positions(GltfFile& file) { return file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, f32, 3); }

/// Normals (0, 0, 1) of a triangle; 8 and 16 bits with the padding that alignment asks for.
template <class T>
int small_normals(GltfFile& file, int type, T one) {
    std::vector<T> values;
    for (int v = 0; v < 3; ++v) values.insert(values.end(), {0, 0, one, 0});
    const int view = file.view(values);
    file.root["bufferViews"][std::size_t(view)]["byteStride"] = 4 * sizeof(T);
    file.root["accessors"].push_back(
        {{"bufferView", view}, {"componentType", type}, {"normalized", true}, {"count", 3}, {"type", "VEC3"}});
    file.root["extensionsUsed"] = {"KHR_mesh_quantization"};
    file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    return int(file.root["accessors"].size()) - 1;
}

const Json& normals_of(const Saved& saved, std::size_t primitive = 0) {
    const Json& attributes = saved.tree["meshes"][0]["primitives"][primitive]["attributes"];
    return saved.tree["accessors"][attributes["NORMAL"].get<std::size_t>()];
}

void expect_codes(vec3 got, vec3 wanted, float largest) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(got[c], std::floor(wanted[c] * largest + 0.5f) / largest);
}

TEST(SaveGltfArrays, NormalsOf8And16BitsStayWhatTheyAre) {
    for (const bool is_byte : {true, false})
        for (const char* output : {"out.gltf", "out.glb"}) {
            SCOPED_TRACE(std::string(is_byte ? "8 bits " : "16 bits ") + output);
            GltfFile file;
            Json& primitive = file.primitive(positions(file));
            const int normals =
                is_byte ? small_normals<std::int8_t>(file, i8, 127) : small_normals<std::int16_t>(file, i16, 32767);
            primitive["attributes"]["NORMAL"] = normals;
            Context context({.threads = 1});
            const Saved saved = save(file, context, with_normal(slanted), output);
            EXPECT_TRUE(saved.result.changed);
            EXPECT_EQ(normals_of(saved)["componentType"], is_byte ? i8 : i16);
            EXPECT_EQ(normals_of(saved)["normalized"], true);
            EXPECT_EQ(normals_of(saved)["count"], 3);
            for (const vec3 n : saved.scene.meshes[0].normals) expect_codes(n, slanted, is_byte ? 127 : 32767);
            EXPECT_FALSE(is_said(context, Remark::changed, "float"));
        }
}

TEST(SaveGltfArrays, NegativeOnesAreNeverTheCodeBelowMinusOne) {
    GltfFile file;
    file.primitive(positions(file))["attributes"]["NORMAL"] = small_normals<std::int8_t>(file, i8, 127);
    Context context({.threads = 1});
    const Saved saved = save(file, context, with_normal({-1, 0, 0}), "out.glb");
    const Json& view = saved.tree["bufferViews"][normals_of(saved)["bufferView"].get<std::size_t>()];
    EXPECT_EQ(saved.binary[view["byteOffset"].get<std::size_t>()], char(-127));
    EXPECT_EQ(saved.scene.meshes[0].normals[0], (vec3{-1, 0, 0}));
}

TEST(SaveGltfArrays, NormalsOf8BitsBesideOthersBecomeFloat) {
    GltfFile file;
    const int place = positions(file);
    file.primitive(place)["attributes"]["NORMAL"] = small_normals<std::int8_t>(file, i8, 127);
    file.primitive(place)["attributes"]["NORMAL"] = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, 3);
    Context context({.threads = 1});
    const Saved saved = save(file, context, with_normal(slanted));
    EXPECT_EQ(normals_of(saved, 0)["componentType"], f32);
    EXPECT_EQ(saved.scene.meshes[0].normals[1], slanted);
    EXPECT_EQ(saved.scene.meshes[1].normals[1], slanted);
    EXPECT_TRUE(is_said(context, Remark::changed, "converted to float"));
}

TEST(SaveGltfArrays, NormalsOf8BitsBecomeFloatWhereObjectsAreTurnedAgainstEachOther) {
    for (const bool is_turned : {false, true}) {
        GltfFile file;
        file.primitive(positions(file))["attributes"]["NORMAL"] = small_normals<std::int8_t>(file, i8, 127);
        file.root["meshes"].push_back(file.root["meshes"][0]);
        Json node = {{"mesh", 1}, {"translation", {1, 2, 3}}, {"scale", {2, 2, 2}}};
        if (is_turned) node["rotation"] = {0, 0.6, 0, 0.8};
        file.root["nodes"].push_back(node);
        file.root["scenes"][0]["nodes"] = {0, 1};
        Context context({.threads = 1});
        const Saved saved = save(file, context, with_normal(slanted));
        EXPECT_EQ(normals_of(saved)["componentType"], is_turned ? f32 : i8);
    }
}

TEST(SaveGltfArrays, TangentsKeepTheirIntegersToo) {
    GltfFile file;
    Json& primitive = file.primitive(positions(file));
    primitive["attributes"]["NORMAL"] = small_normals<std::int16_t>(file, i16, 32767);
    primitive["attributes"]["TANGENT"] =
        file.accessor<std::int16_t>({32767, 0, 0, 32767, 32767, 0, 0, 32767, 32767, 0, 0, 32767}, i16, 4, true);
    Context context({.threads = 1});
    const Saved saved = save(file, context, [](Scene scene) {
        scene.meshes[0].tangents = std::vector<vec4>(3, vec4{0.8f, -0.6f, 0, -1});
        return with_normal(slanted)(std::move(scene));
    });
    const Json& attributes = saved.tree["meshes"][0]["primitives"][0]["attributes"];
    EXPECT_EQ(saved.tree["accessors"][attributes["TANGENT"].get<std::size_t>()]["componentType"], i16);
    const vec4 t = saved.scene.meshes[0].tangents[2];
    EXPECT_NEAR(t.x, 0.8f, 2e-5f);
    EXPECT_NEAR(t.y, -0.6f, 2e-5f);
    EXPECT_EQ(t.w, -1);
}

/// A GLB file's own arrays are overwritten: it does not grow, however often its normals change.
TEST(SaveGltfArrays, OwnArraysOfABinaryChunkAreOverwrittenWithTheirBounds) {
    GltfFile file;
    Json& primitive = file.primitive(positions(file));
    const int normals = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, 3);
    file.root["accessors"][std::size_t(normals)]["min"] = {0, 0, 1};
    file.root["accessors"][std::size_t(normals)]["max"] = {0, 0, 1};
    primitive["attributes"]["NORMAL"] = normals;
    Context context({.threads = 1});
    const Saved saved = save(file, context, with_normal(slanted), "out.glb");
    EXPECT_EQ(saved.tree["accessors"].size(), file.root["accessors"].size());
    EXPECT_EQ(saved.tree["bufferViews"].size(), file.root["bufferViews"].size());
    EXPECT_EQ(saved.binary.size(), file.data.size());
    EXPECT_EQ(saved.binary.substr(0, 36), file.data.substr(0, 36));
    EXPECT_EQ(normals_of(saved)["max"][1].get<float>(), slanted.y);
    EXPECT_EQ(saved.scene.meshes[0].normals[2], slanted);
    EXPECT_FALSE(is_said(context, Remark::note, "unused"));
}

TEST(SaveGltfArrays, InterleavedNormalsAreOverwrittenBetweenTheirNeighbors) {
    GltfFile file;
    std::vector<float> mixed;
    for (int v = 0; v < 3; ++v)
        for (const float x : {float(v == 1), float(v == 2), 0.0f, 0.0f, 0.0f, 1.0f, 0.25f, 0.5f}) mixed.push_back(x);
    const int view = file.view(mixed);
    file.root["bufferViews"][std::size_t(view)]["byteStride"] = 32;
    for (const int offset : {0, 12, 24})
        file.root["accessors"].push_back({{"bufferView", view},
                                          {"byteOffset", offset},
                                          {"componentType", f32},
                                          {"count", 3},
                                          {"type", offset == 24 ? "VEC2" : "VEC3"}});
    Json& primitive = file.primitive(0);
    primitive["attributes"]["NORMAL"] = 1;
    primitive["attributes"]["TEXCOORD_0"] = 2;
    Context context({.threads = 1});
    const Saved saved = save(file, context, with_normal(slanted), "out.glb");
    EXPECT_EQ(saved.binary.size(), file.data.size());
    for (std::size_t v = 0; v < 3; ++v) {
        EXPECT_EQ(saved.binary.substr(32 * v, 12), file.data.substr(32 * v, 12));
        EXPECT_EQ(saved.binary.substr(32 * v + 24, 8), file.data.substr(32 * v + 24, 8));
        EXPECT_EQ(saved.scene.meshes[0].normals[v], slanted);
    }
}

/// Whether the old normals are still in the file, and new ones behind them.
void expect_old_normals_kept(GltfFile& file, int normals) {
    Context context({.threads = 1});
    const Saved saved = save(file, context, with_normal(slanted), "out.glb", {.keep_unused = true});
    EXPECT_NE(saved.tree["meshes"][0]["primitives"][0]["attributes"]["NORMAL"], normals);
    EXPECT_EQ(saved.binary.substr(0, file.data.size()), file.data);
    EXPECT_EQ(saved.scene.meshes[0].normals[0], slanted);
}

TEST(SaveGltfArrays, ArraysThatOthersUseAreNotOverwritten) {
    const std::vector<float> up{0, 0, 1, 0, 0, 1, 0, 0, 1};
    {
        SCOPED_TRACE("a morph target");
        GltfFile file;
        const int place = positions(file), normals = file.accessor(up, f32, 3);
        Json& primitive = file.primitive(place);
        primitive["attributes"]["NORMAL"] = normals;
        primitive["targets"] = {{{"POSITION", normals}}};
        expect_old_normals_kept(file, normals);
    }
    {
        SCOPED_TRACE("a mesh that is not drawn");
        GltfFile file;
        const int normals = file.accessor(up, f32, 3);
        file.primitive(positions(file))["attributes"]["NORMAL"] = normals;
        file.root["meshes"].push_back(file.root["meshes"][0]);
        expect_old_normals_kept(file, normals);
    }
    {
        SCOPED_TRACE("another accessor over the same bytes");
        GltfFile file;
        const int normals = file.accessor(up, f32, 3);
        file.primitive(positions(file))["attributes"]["NORMAL"] = normals;
        file.root["accessors"].push_back(file.root["accessors"][std::size_t(normals)]);
        expect_old_normals_kept(file, normals);
    }
    {
        SCOPED_TRACE("another view over the same bytes");
        GltfFile file;
        const int normals = file.accessor(up, f32, 3);
        file.primitive(positions(file))["attributes"]["NORMAL"] = normals;
        Json view =
            file.root["bufferViews"][file.root["accessors"][std::size_t(normals)]["bufferView"].get<std::size_t>()];
        view["byteOffset"] = view["byteOffset"].get<int>() + 32;
        view["byteLength"] = 4;
        file.root["bufferViews"].push_back(view);
        expect_old_normals_kept(file, normals);
    }
    {
        SCOPED_TRACE("an extension that may name it");
        GltfFile file;
        const int normals = file.accessor(up, f32, 3);
        file.primitive(positions(file))["attributes"]["NORMAL"] = normals;
        file.root["extensionsUsed"] = {"ACME_authored_normals"};
        expect_old_normals_kept(file, normals);
    }
}

TEST(SaveGltfArrays, WhatIsNoLongerUsedIsCounted) {
    GltfFile file;
    file.primitive(positions(file))["attributes"]["NORMAL"] = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, 3);
    Context context({.threads = 1});
    save(file, context, with_normal(slanted), "out.gltf");  // the buffer beside the file is not ours to overwrite
    EXPECT_TRUE(is_said(context, Remark::note, "36 bytes of old vertex arrays stay in the file, unused"));
}

TEST(SaveGltfArrays, BrokenPartsThatAreNotDrawnDoNoHarm) {
    GltfFile file;
    const int normals = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, f32, 3);
    file.primitive(positions(file))["attributes"]["NORMAL"] = normals;
    for (
        const char* broken :
        {R"({"bufferView": 99, "componentType": 5126, "count": 3, "type": "VEC3"})",
         R"({"bufferView": 0, "byteOffset": 9007199254740991, "componentType": 5126, "count": 9007199254740991, "type": "VEC3"})",
         R"({"bufferView": -1, "componentType": "float", "count": 1e300, "type": 7, "sparse": [1]})", R"(17)"})
        file.root["accessors"].push_back(Json::parse(broken));
    file.root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", 9007199254740991}, {"byteLength", 9007199254740991}});
    file.root["meshes"].push_back(Json::parse(
        R"({"primitives": [{"attributes": {"NORMAL": 1e300, "X": "y"}, "indices": -4, "targets": [7]}, 3]})"));
    file.root["skins"] = Json::parse(R"([{"inverseBindMatrices": 88}, 5])");
    file.root["animations"] = Json::parse(R"([{"samplers": {"input": 1}}, {"samplers": [2, {"input": 4294967296}]}])");
    Context context({.threads = 1});
    const Saved saved = save(file, context, with_normal(slanted), "out.gltf");
    EXPECT_EQ(saved.scene.meshes[0].normals[0], slanted);
}

}  // namespace
}  // namespace rakelight
