// SPDX-License-Identifier: Apache-2.0
// glTF files made for the purpose: instances, splits of every kind of attribute, containers, neighbors on disk.
#include <gtest/gtest.h>

#include <cstring>

#include "math/linear.h"
#include "smooth_file_support.h"
#include "support/shared.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::ordered_json;

void put(std::string& out, std::initializer_list<float> values) {
    for (const float v : values) out.append(reinterpret_cast<const char*>(&v), 4);
}

/// A right-angled fold of two quads over six vertices: the two in the middle must split under a crease angle of 60
/// degrees. Attributes: POSITION float, COLOR_0 normalized u16, _ID u8 with a stride of 4, one morph target; indices
/// u8.
std::string fold_buffer() {
    std::string data;
    put(data, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 1, -1, 1, 1, -1});  // 0: positions
    for (int v = 0; v < 6; ++v)                                           // 72: colors
        for (const int c : {v * 1000, 65535, 7, 65535}) {
            const auto word = std::uint16_t(c);
            data.append(reinterpret_cast<const char*>(&word), 2);
        }
    for (int v = 0; v < 6; ++v) data += {char(10 + v), 0, 0, 0};  // 120: _ID
    for (int v = 0; v < 6; ++v) put(data, {0, 0, float(v)});      // 144: offsets
    data += {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4};                 // 216: indices
    return data;                                                  // 228
}

Json fold_tree() {
    return Json::parse(
        R"({"asset":{"version":"2.0","extras":{"z":1,"a":[1.5,0.1]}},"scene":0,"scenes":[{"nodes":[0,1]}],
      "extensionsUsed":["ACME_unknown"],"extensions":{"ACME_unknown":{"keep":[1,2,3]}},
      "nodes":[{"name":"left","mesh":0},{"name":"right","mesh":0,"translation":[1,0,0]}],
      "meshes":[{"name":"fold","weights":[0],"extras":{"id":7},"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1,"_ID":2},
        "targets":[{"POSITION":3}],"indices":4,"extras":"kept"}]}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3","min":[0,0,-1],"max":[1,1,0]},
        {"bufferView":1,"componentType":5123,"normalized":true,"count":6,"type":"VEC4"},
        {"bufferView":2,"componentType":5121,"count":6,"type":"SCALAR","name":"ids"},
        {"bufferView":3,"componentType":5126,"count":6,"type":"VEC3","min":[0,0,0],"max":[0,0,5]},
        {"bufferView":4,"componentType":5121,"count":12,"type":"SCALAR"}],
      "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":48},
        {"buffer":0,"byteOffset":120,"byteLength":24,"byteStride":4},{"buffer":0,"byteOffset":144,"byteLength":72},
        {"buffer":0,"byteOffset":216,"byteLength":12}],
      "buffers":[{"byteLength":228,"uri":"fold%20data.bin"}]})");
}

struct Files {
    const TemporaryFolder dir;
    const fs::path model = dir / "fold.gltf";
    explicit Files(Json tree = fold_tree()) {
        write(dir / "fold data.bin", fold_buffer());
        write(model, tree.dump(2) + "\n");
    }
};

TEST(SmoothFileGltf, SplitVerticesCopyTheElementsOfEveryAttributeAsTheyAre) {
    const Files files;
    Context context;
    const fs::path out = files.dir / "out.gltf";
    const SmoothedFile result = smooth_file(files.model.string(), out.string(), anew, context);
    ASSERT_EQ(result.meshes.size(), 1u);  // the neighbor touches at an edge of the fold's planes: the same for both
    EXPECT_EQ(result.meshes[0].vertices_split, 2u);
    const Json tree = Json::parse(bytes_of(out)), old = fold_tree();
    const Json& primitive = tree["meshes"][0]["primitives"][0];
    EXPECT_EQ(primitive["extras"], "kept");
    EXPECT_EQ(tree["asset"], old["asset"]);
    EXPECT_EQ(tree["extensions"], old["extensions"]);
    const auto data_of = [&](const Json& accessor) {
        const Json& view = tree["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        EXPECT_EQ(view["buffer"], 1);
        return bytes_of(files.dir / "out.bin")
            .substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>());
    };
    const auto accessor = [&](const Json& number) -> const Json& {
        return tree["accessors"][number.get<std::size_t>()];
    };
    const Json& ids = accessor(primitive["attributes"]["_ID"]);
    EXPECT_EQ(ids["name"], "ids");
    EXPECT_EQ(ids["componentType"], 5121);
    EXPECT_EQ(ids["count"], 8);
    const std::string id_bytes = data_of(ids);
    std::string copies = {id_bytes[24], id_bytes[28]};
    std::sort(copies.begin(), copies.end());
    EXPECT_EQ(copies, (std::string{12, 13}));
    const Json& colors = accessor(primitive["attributes"]["COLOR_0"]);
    EXPECT_EQ(colors["normalized"], true);
    EXPECT_EQ(data_of(colors).substr(0, 48), fold_buffer().substr(72, 48));
    const Json& target = accessor(primitive["targets"][0]["POSITION"]);
    EXPECT_EQ(target["max"], old["accessors"][3]["max"]);
    EXPECT_EQ(target["count"], 8);
    EXPECT_EQ(accessor(primitive["indices"])["componentType"], 5121);
    EXPECT_EQ(bytes_of(files.dir / "fold data.bin"), fold_buffer());
}

/// Turned by a right angle about the edge they share, the two placements of a quad have different normals there.
Json corner_tree() {
    Json tree = fold_tree();
    tree["accessors"][4]["count"] = 6;  // the first quad alone
    tree["nodes"][1] = {{"name", "right"}, {"mesh", 0}, {"rotation", {0, 0.70710678, 0, 0.70710678}}, {"extras", 5}};
    return tree;
}

TEST(SmoothFileGltf, AnInstanceThatNeedsOtherNormalsGetsItsOwnMesh) {
    const Files files(corner_tree());
    Context context;
    SmoothFileOptions options = anew;
    options.attributes.crease_angle_rad = pi;
    const fs::path out = files.dir / "out.glb";
    const SmoothedFile result = smooth_file(files.model.string(), out.string(), options, context);
    EXPECT_EQ(result.meshes_added, 1u);
    const Scene scene = load(out.string(), {}, context);
    ASSERT_EQ(scene.nodes.size(), 2u);
    EXPECT_NE(scene.nodes[0].meshes, scene.nodes[1].meshes);
    EXPECT_EQ(scene.meshes[0].name, "fold");
    EXPECT_EQ(scene.meshes[1].name, "fold");
    EXPECT_FALSE(std::equal(scene.meshes[0].normals.begin(), scene.meshes[0].normals.end(),
                            scene.meshes[1].normals.begin(), scene.meshes[1].normals.end()));
    const SmoothedFile again = smooth_file(out.string(), (files.dir / "again.glb").string(), options, context);
    EXPECT_FALSE(again.changed);
    EXPECT_EQ(bytes_of(out), bytes_of(files.dir / "again.glb"));
}

TEST(SmoothFileGltf, KeptInstancesShareTheMeshOfTheFirstAndItIsSaid) {
    const Files files(corner_tree());
    Context context;
    SmoothFileOptions options = anew;
    options.attributes.crease_angle_rad = pi;
    options.keep_instances = true;
    const fs::path out = files.dir / "out.gltf";
    EXPECT_EQ(smooth_file(files.model.string(), out.string(), options, context).meshes_added, 0u);
    const Scene scene = load(out.string(), {}, context);
    EXPECT_EQ(scene.nodes[0].meshes, scene.nodes[1].meshes);
    EXPECT_TRUE(is_said(context, Remark::warning, "share one mesh"));
    EXPECT_FALSE(smooth_file(out.string(), (files.dir / "again.gltf").string(), options, context).changed);
}

TEST(SmoothFileGltf, InPlaceLeavesTheFilesOwnBufferAlone) {
    Json tree = fold_tree();
    tree["buffers"][0]["uri"] = "fold.bin";
    const Files files(tree);
    write(files.dir / "fold.bin", fold_buffer());
    Context context;
    EXPECT_TRUE(smooth_file(files.model.string(), files.model.string(), anew, context).changed);
    EXPECT_EQ(bytes_of(files.dir / "fold.bin"), fold_buffer());
    EXPECT_TRUE(fs::exists(files.dir / "fold.normals.bin"));
    const std::string once = bytes_of(files.model);
    EXPECT_FALSE(smooth_file(files.model.string(), files.model.string(), anew, context).changed);
    EXPECT_EQ(bytes_of(files.model), once);
    EXPECT_EQ(once.substr(0, 4), "{\n  ");  // indented as it was
}

TEST(SmoothFileGltf, AnotherFolderGetsTheFilesThatTheModelNames) {
    const Files files;
    fs::create_directories(files.dir / "to");
    Context context;
    smooth_file(files.model.string(), (files.dir / "to" / "x.gltf").string(), anew, context);
    EXPECT_EQ(bytes_of(files.dir / "to" / "fold data.bin"), fold_buffer());
    EXPECT_EQ(load((files.dir / "to" / "x.gltf").string(), {}, context).nodes.size(), 2u);
    // A file of that name with other contents is not replaced.
    write(files.dir / "to" / "fold data.bin", "mine");
    try {
        smooth_file(files.model.string(), (files.dir / "to" / "y.gltf").string(), anew, context);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::failed);
    }
    EXPECT_EQ(bytes_of(files.dir / "to" / "fold data.bin"), "mine");
    EXPECT_FALSE(fs::exists(files.dir / "to" / "y.gltf"));
}

TEST(SmoothFileGltf, ANewBufferReplacesNoFileButThatOfTheModelItReplaces) {
    const Files files;
    write(files.dir / "x.bin", "somebody else's");
    Context context;
    const auto run = [&](const char* name) {
        smooth_file(files.model.string(), (files.dir / name).string(), anew, context);
    };
    run("x.gltf");
    EXPECT_EQ(bytes_of(files.dir / "x.bin"), "somebody else's");
    const std::string made = bytes_of(files.dir / "x.normals.bin");
    EXPECT_FALSE(made.empty());
    run("x.gltf");  // again: the buffer of the model that is replaced may be replaced
    EXPECT_EQ(bytes_of(files.dir / "x.normals.bin"), made);
    EXPECT_FALSE(fs::exists(files.dir / "x.normals2.bin"));
    run("y.gltf");
    run("y.gltf");
    EXPECT_TRUE(fs::exists(files.dir / "y.bin"));
    EXPECT_FALSE(fs::exists(files.dir / "y.normals.bin"));
}

TEST(SmoothFileGltf, PartsThatAreNotDrawnMayBeOfAnyKind) {
    Json tree = fold_tree();
    for (const char* list : {"meshes", "accessors", "bufferViews", "skins", "animations", "images"})
        tree[list].push_back(5);
    tree["meshes"].push_back({{"primitives", "none"}});
    tree["bufferViews"].push_back({{"buffer", "first"}, {"extensions", 7}});
    tree["bufferViews"].push_back({{"buffer", 99}});
    tree["meshes"][0]["primitives"][0]["attributes"]["_UNREAD"] = 4000000000u;
    const Files files(tree);
    Context context;
    SmoothFileOptions round = anew;
    round.attributes.crease_angle_rad = pi;  // splits nothing
    for (const char* name : {"x.gltf", "x.glb"}) {
        EXPECT_TRUE(smooth_file(files.model.string(), (files.dir / name).string(), round, context).changed);
        EXPECT_FALSE(smooth_file((files.dir / name).string(), (files.dir / name).string(), round, context).changed);
    }
}

TEST(SmoothFileGltf, GlbInPlaceKeepsTheRestOfTheBinaryChunkAndUnknownChunks) {
    const Files files;
    Context context;
    const fs::path glb = files.dir / "a.glb";
    SmoothFileOptions flat = anew;
    flat.attributes.scope = Scope::face;
    smooth_file(files.model.string(), glb.string(), flat, context);
    std::string file = bytes_of(glb);
    file += std::string("\4\0\0\0NOTEabcd", 12);
    const auto length = std::uint32_t(file.size());
    std::memcpy(file.data() + 8, &length, 4);
    write(glb, file);
    SmoothFileOptions round = anew;
    round.attributes.crease_angle_rad = pi;
    EXPECT_TRUE(smooth_file(glb.string(), glb.string(), round, context).changed);
    const std::string now = bytes_of(glb);
    EXPECT_EQ(now.substr(now.size() - 12), std::string("\4\0\0\0NOTEabcd", 12));
    EXPECT_NE(now.find(fold_buffer()), std::string::npos);
    std::uint32_t said = 0;
    std::memcpy(&said, now.data() + 8, 4);
    EXPECT_EQ(said, now.size());
}

TEST(SmoothFileGltf, NamesThatStandTwiceKeepTheLastAsTheReaderDoes) {
    const Files files;
    std::string text = fold_tree().dump();
    text.insert(1, "\"scene\":9,");
    write(files.model, text);
    Context context;
    smooth_file(files.model.string(), (files.dir / "o.gltf").string(), anew, context);
    const std::string out = bytes_of(files.dir / "o.gltf");
    EXPECT_EQ(out.find("\"scene\":9"), std::string::npos);
    EXPECT_NE(out.find("\"scene\":0"), std::string::npos);
}

TEST(SmoothFileGltf, BitangentsOfTheirOwnAreAnAttributeWithAnUnderscore) {
    const TemporaryFolder dir;
    const std::string glb = (dir / "sheet.glb").string(), again = (dir / "again.glb").string();
    SmoothFileOptions options = anew;
    options.bitangents = true, options.tangents = TangentChoice::always;
    Context context;
    smooth_file((source_dir() / "data/maps/sheet.obj").string(), glb, options, context);
    const Scene scene = load(glb, {}, context);
    ASSERT_FALSE(scene.meshes.empty());
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
        const auto array = std::find_if(mesh.arrays.begin(), mesh.arrays.end(),
                                        [](const VertexArray& a) { return a.name == "_BITANGENT"; });
        ASSERT_NE(array, mesh.arrays.end());
        ASSERT_EQ(array->components, 3u);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const vec3 b{array->values[3 * v], array->values[3 * v + 1], array->values[3 * v + 2]};
            EXPECT_NEAR(length(b), 1, 1e-5);
            const vec3 crossed = cross(mesh.normals[v], mesh.tangents[v].xyz()) * mesh.tangents[v].w;
            EXPECT_GT(dot(b, crossed), 0) << "w says on which side it lies";
        }
    }
    EXPECT_FALSE(smooth_file(glb, again, options, context).changed) << "they are there already";
    EXPECT_THROW(smooth_file(glb, (dir / "sheet.ply").string(), options, context), Error);
    options.tangents = TangentChoice::never;
    EXPECT_THROW(smooth_file(glb, again, options, context), Error);
}

TEST(SmoothFileGltf, ABrokenInputLeavesTheOutputAlone) {
    Json tree = fold_tree();
    tree["accessors"][0]["count"] = 600;
    const Files files(tree);
    write(files.dir / "out.gltf", "old");
    Context context;
    EXPECT_THROW(smooth_file(files.model.string(), (files.dir / "out.gltf").string(), anew, context), Error);
    EXPECT_EQ(bytes_of(files.dir / "out.gltf"), "old");
}

}  // namespace
}  // namespace rakelight
