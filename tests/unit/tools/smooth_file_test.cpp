// SPDX-License-Identifier: Apache-2.0
// Smoothed files of the model set: the attributes that were computed, nothing else changed, and a second run changes
// nothing.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include <rakelight/rakelight.h>

#include "support/shared.h"
#include "tools/smooth_file_scene.h"

namespace rakelight {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// An empty folder of the running test.
fs::path folder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    fs::path path = fs::path(testing::TempDir()) / (std::string("rl_smooth_") + test->name());
    fs::remove_all(path);
    fs::create_directories(path);
    return path;
}

struct Parts {
    Json tree;
    std::string binary;
};

Parts parts_of(const fs::path& path) {
    const std::string file = bytes_of(path);
    if (file.substr(0, 4) != "glTF") return {Json::parse(file), {}};
    std::uint32_t json = 0, binary = 0;
    std::memcpy(&json, file.data() + 12, 4);
    const std::size_t next = 20 + json;
    if (next + 8 <= file.size()) std::memcpy(&binary, file.data() + next, 4);
    return {Json::parse(file.substr(20, json)), binary ? file.substr(next + 8, binary) : std::string()};
}

Json without(Json json, std::initializer_list<const char*> names) {
    for (const char* name : names) json.erase(name);
    return json;
}

/// The entries of the old list stand in front of the new one, unchanged.
void expect_prefix(const Json& before, const Json& after, const char* name) {
    const Json old = before.value(name, Json::array()), now = after.value(name, Json::array());
    ASSERT_GE(now.size(), old.size()) << name;
    for (std::size_t i = 0; i < old.size(); ++i) EXPECT_EQ(now[i], old[i]) << name << " " << i;
}

/// A primitive may differ in NORMAL, TANGENT and the numbers of its other accessors, which must say the same but for
/// where their data is and a larger count.
void expect_same_primitive(const Json& old, const Json& now, const Json& before, const Json& after) {
    const auto rest = [](Json p) {
        p["attributes"].erase("NORMAL"), p["attributes"].erase("TANGENT"), p.erase("indices"), p.erase("mode");
        if (p.contains("extensions")) {
            p["extensions"].erase("KHR_draco_mesh_compression");
            if (p["extensions"].empty()) p.erase("extensions");
        }
        if (p.contains("targets"))
            for (Json& target : p["targets"]) target.erase("TANGENT");
        return p;
    };
    const Json a = rest(old), b = rest(now);
    EXPECT_EQ(without(a, {"attributes", "targets"}), without(b, {"attributes", "targets"}));
    const auto expect_same_arrays = [&](const Json& x, const Json& y) {
        ASSERT_EQ(x.size(), y.size());
        for (const auto& [name, accessor] : x.items()) {
            ASSERT_TRUE(y.contains(name)) << name;
            const Json &from = before["accessors"][accessor.get<std::size_t>()],
                       &to = after["accessors"][y[name].get<std::size_t>()];
            EXPECT_EQ(without(from, {"bufferView", "byteOffset", "sparse", "count"}),
                      without(to, {"bufferView", "byteOffset", "sparse", "count"}));
            EXPECT_GE(to["count"], from["count"]);
        }
    };
    expect_same_arrays(a["attributes"], b["attributes"]);
    const Json none_given = Json::array(), x = a.value("targets", none_given), y = b.value("targets", none_given);
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t t = 0; t < x.size(); ++t) expect_same_arrays(x[t], y[t]);
}

void expect_same_meshes(const Json& before, const Json& after) {
    ASSERT_GE(after["meshes"].size(), before["meshes"].size());
    for (std::size_t m = 0; m < before["meshes"].size(); ++m) {
        const Json &old = before["meshes"][m], &now = after["meshes"][m];
        EXPECT_EQ(without(old, {"primitives"}), without(now, {"primitives"}));
        ASSERT_EQ(old["primitives"].size(), now["primitives"].size());
        for (std::size_t p = 0; p < old["primitives"].size(); ++p)
            expect_same_primitive(old["primitives"][p], now["primitives"][p], before, after);
    }
}

void expect_same_nodes(const Json& before, const Json& after) {
    ASSERT_EQ(before["nodes"].size(), after["nodes"].size());
    for (std::size_t n = 0; n < before["nodes"].size(); ++n) {
        const Json &old = before["nodes"][n], &now = after["nodes"][n];
        EXPECT_EQ(without(old, {"mesh"}), without(now, {"mesh"}));
        ASSERT_EQ(old.contains("mesh"), now.contains("mesh"));
        if (!old.contains("mesh") || old["mesh"] == now["mesh"]) continue;
        EXPECT_GE(now["mesh"], before["meshes"].size());  // a copy of its own
        EXPECT_EQ(after["meshes"][now["mesh"].get<std::size_t>()].value("name", ""),
                  before["meshes"][old["mesh"].get<std::size_t>()].value("name", ""));
    }
}

void expect_only_attributes_changed(const fs::path& input, const fs::path& output) {
    const Parts before = parts_of(input), after = parts_of(output);
    const auto changing = {"accessors", "bufferViews",    "buffers",           "meshes",
                           "nodes",     "extensionsUsed", "extensionsRequired"};
    EXPECT_EQ(without(before.tree, changing), without(after.tree, changing));
    expect_prefix(before.tree, after.tree, "accessors");
    expect_prefix(before.tree, after.tree, "bufferViews");
    for (const char* name : {"extensionsUsed", "extensionsRequired"})
        for (const Json& extension : before.tree.value(name, Json::array())) {
            const Json now = after.tree.value(name, Json::array());
            EXPECT_TRUE(extension == "KHR_draco_mesh_compression" ||
                        std::find(now.begin(), now.end(), extension) != now.end())
                << extension;
        }
    expect_same_meshes(before.tree, after.tree);
    expect_same_nodes(before.tree, after.tree);
    const Json old = before.tree.value("buffers", Json::array()), now = after.tree.value("buffers", Json::array());
    ASSERT_GE(now.size(), old.size());
    for (std::size_t b = 0; b < old.size(); ++b)
        EXPECT_EQ(without(old[b], {"byteLength"}), without(now[b], {"byteLength"}));
    if (!before.binary.empty() && after.binary != before.binary) {
        const auto length = old[0]["byteLength"].get<std::size_t>();
        EXPECT_EQ(after.binary.substr(0, length), before.binary.substr(0, length));
    }
}

/// Equal numbers (zeros of both signs are).
template <class T>
void expect_same(const Block<T>& a, const Block<T>& b, const char* what) {
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end())) << what;
}

void expect_attributes(const Scene& wanted, const Scene& got) {
    ASSERT_EQ(wanted.nodes.size(), got.nodes.size());
    for (std::size_t n = 0; n < wanted.nodes.size(); ++n) {
        ASSERT_EQ(wanted.nodes[n].meshes.size(), got.nodes[n].meshes.size());
        for (std::size_t slot = 0; slot < wanted.nodes[n].meshes.size(); ++slot) {
            const Mesh &a = wanted.meshes[wanted.nodes[n].meshes[slot]], &b = got.meshes[got.nodes[n].meshes[slot]];
            expect_same(a.positions, b.positions, "positions");
            expect_same(a.indices, b.indices, "indices");
            expect_same(a.normals, b.normals, "normals");
            expect_same(a.tangents, b.tangents, "tangents");
            ASSERT_EQ(a.influences.size(), b.influences.size());
            ASSERT_EQ(a.targets.size(), b.targets.size());
            for (std::size_t t = 0; t < a.targets.size(); ++t)
                expect_same(a.targets[t].positions, b.targets[t].positions, "morph target");
            for (std::size_t set = 0; set < std::min(a.texcoords.size(), b.texcoords.size()); ++set)
                expect_same(a.texcoords[set], b.texcoords[set], "texture coordinates");
        }
    }
}

std::vector<fs::path> models(std::initializer_list<const char*> folders, std::initializer_list<const char*> endings) {
    std::vector<fs::path> found;
    for (const char* name : folders)
        if (test::has_shared(std::string("assets/") + name))
            for (const auto& entry : fs::recursive_directory_iterator(test::shared_dir() / "assets" / name))
                for (const char* ending : endings)
                    if (entry.path().extension() == ending) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

void smooth_all_gltf(const SmoothFileOptions& options) {
    const fs::path out = folder();
    const std::vector<fs::path> files = models({"gltf", "generator", "derived", "crossformat"}, {".glb", ".gltf"});
    ASSERT_GE(files.size(), 50u);
    for (std::size_t i = 0; i < files.size(); ++i) {
        SCOPED_TRACE(files[i].string());
        const fs::path one = out / std::to_string(i) / ("one" + files[i].extension().string());
        const fs::path two = one.parent_path() / ("two" + files[i].extension().string());
        fs::create_directories(one.parent_path());
        Context context;
        const SmoothedFile result = smooth_file(files[i].string(), one.string(), options, context);
        const Scene got = load(one.string(), {}, context);
        if (result.changed)
            expect_attributes(smooth_for_file(load(files[i].string(), {}, context), options, context), got);
        expect_only_attributes_changed(files[i], one);
        const SmoothedFile again = smooth_file(one.string(), two.string(), options, context);
        EXPECT_FALSE(again.changed);
        EXPECT_TRUE(bytes_of(one) == bytes_of(two));
        fs::remove_all(one.parent_path());
    }
}

TEST(SmoothFile, GltfKeepsEverythingButNormalsAndTangents) {
    RL_NEEDS_SHARED("assets");
    smooth_all_gltf({});
}

TEST(SmoothFile, GltfKeepsEverythingWhereAllVerticesAreSplitAndAllHaveTangents) {
    RL_NEEDS_SHARED("assets");
    SmoothFileOptions options;
    options.attributes.crease_angle_rad = 0;
    options.tangents = TangentChoice::always;
    smooth_all_gltf(options);
}

/// Lines of an OBJ file without its normals: neither `vn` lines nor the last reference of face corners.
std::vector<std::string> other_lines(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        std::string line = text.substr(at, end - at);
        at = end;
        const std::size_t word = line.find_first_not_of(" \t");
        if (word != std::string::npos && line.compare(word, 3, "vn ") == 0) continue;
        if (word != std::string::npos && line.compare(word, 2, "f ") == 0) {
            std::string kept;
            std::size_t slashes = 0;
            for (const char c : line) {
                if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\\') slashes = 0;
                slashes += c == '/';
                if (slashes < 2) kept += c;
            }
            for (std::size_t i; (i = kept.find("/ ")) != std::string::npos;) kept.erase(i, 1);
            for (std::size_t i; (i = kept.find("/\n")) != std::string::npos;) kept.erase(i, 1);
            for (std::size_t i; (i = kept.find("/\r")) != std::string::npos;) kept.erase(i, 1);
            line = kept;
        }
        lines.push_back(line);
    }
    return lines;
}

TEST(SmoothFile, ObjKeepsEveryOtherLine) {
    RL_NEEDS_SHARED("assets");
    const fs::path out = folder();
    const std::vector<fs::path> files = models({"obj", "derived", "crossformat", "fbx"}, {".obj"});
    ASSERT_GE(files.size(), 30u);
    for (const fs::path& file : files) {
        SCOPED_TRACE(file.string());
        Context context;
        const fs::path one = out / "one.obj", two = out / "two.obj";
        const SmoothedFile result = smooth_file(file.string(), one.string(), {}, context);
        EXPECT_EQ(other_lines(bytes_of(file)), other_lines(bytes_of(one)));
        EXPECT_FALSE(smooth_file(one.string(), two.string(), {}, context).changed);
        EXPECT_TRUE(bytes_of(one) == bytes_of(two));
        EXPECT_TRUE(result.changed || bytes_of(one) == bytes_of(file));
    }
}

constexpr const char* two_quads =
    "# two quads that meet at a right angle\r\n"
    "mtllib none.mtl\r\n"
    "v 0 0 0 # a comment\r\n"
    "v 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nvn 0 1 0\r\n"
    "o first\r\nusemtl a\r\n"
    "f 1/ 2// \\\r\n  3//1   4   # the first\r\n"
    "v 0 0 -1\r\nv 0 1 -1\r\no second\r\ng part\r\n"
    "f -6 -3 -1 -2\r\nf 1 2 99//1\r\nl 1 2\r\n";

TEST(SmoothFile, ObjLinesWithContinuationRelativeIndicesAndFaultyFacesAreRewrittenInPlace) {
    const fs::path file = folder() / "quads.obj";
    write(file, two_quads);
    Context context;
    SmoothFileOptions options;
    options.attributes.crease_angle_rad = pi;
    const SmoothedFile result = smooth_file(file.string(), file.string(), options, context);
    EXPECT_TRUE(result.changed);
    const std::string text = bytes_of(file);
    EXPECT_NE(text.find("f 1//"), std::string::npos) << text;
    EXPECT_NE(text.find("\\\r\n  3//"), std::string::npos) << text;
    EXPECT_NE(text.find("   # the first\r\n"), std::string::npos) << text;
    EXPECT_NE(text.find("f -6//-"), std::string::npos) << text;  // relative stays relative
    EXPECT_NE(text.find("f 1 2 99\r\nl 1 2\r\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("vn 0 1 0"), std::string::npos) << text;
    EXPECT_LT(text.find("vn "), text.find("o first")) << text;  // where data stands, before the faces
    const std::size_t second = text.find("vn ", text.find("v 0 1 -1"));
    EXPECT_LT(second, text.find("o second")) << text;
    // the border is continuous
    const Scene scene = load(file.string(), {}, context);
    const Mesh &a = scene.meshes[0], &b = scene.meshes[1];
    int shared = 0;
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        for (std::size_t k = 0; k < b.positions.size(); ++k)
            if (a.positions[i] == b.positions[k]) {
                EXPECT_EQ(a.normals[i], b.normals[k]);
                ++shared;
            }
    EXPECT_EQ(shared, 2);
    EXPECT_FALSE(smooth_file(file.string(), file.string(), options, context).changed);
    EXPECT_EQ(bytes_of(file), text);
}

TEST(SmoothFile, PlyAndGlbOfAnObjHaveTheSameNormals) {
    const fs::path out = folder(), file = out / "quads.obj";
    write(file, two_quads);
    Context context;
    SmoothFileOptions options;
    options.attributes.crease_angle_rad = pi;
    smooth_file(file.string(), (out / "a.glb").string(), options, context);
    const Scene wanted = smooth_for_file(load(file.string(), {}, context), options, context);
    const Scene got = load((out / "a.glb").string(), {}, context);
    expect_attributes(wanted, got);
    EXPECT_FALSE(smooth_file((out / "a.glb").string(), (out / "b.glb").string(), options, context).changed);
    smooth_file(file.string(), (out / "a.ply").string(), options, context);
    const std::string ply = bytes_of(out / "a.ply");
    EXPECT_NE(ply.find("element vertex 8\n"), std::string::npos);
    EXPECT_NE(ply.find("element face 4\n"), std::string::npos);
    const std::size_t data = ply.find("end_header\n") + 11;
    ASSERT_EQ(ply.size(), data + 8 * 24 + 4 * 13);
    vec3 first_normal;
    std::memcpy(&first_normal, ply.data() + data + 12, 12);
    EXPECT_EQ(first_normal, wanted.meshes[0].normals[0]);
}

TEST(SmoothFile, FormatsWithoutAWayBetweenThemAreAUsageError) {
    const fs::path out = folder();
    write(out / "a.obj", two_quads);
    Context context;
    for (const char* name : {"b.gltf", "b.stl", "b"}) try {
            smooth_file((out / "a.obj").string(), (out / name).string(), {}, context);
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::usage);
        }
}

TEST(SmoothFile, JsonSaysWhatHappenedToEachMesh) {
    SmoothedFileRow row{.file = "in.glb"};
    row.result = SmoothedFile{.file = "in.glb", .output = "out.glb", .changed = true, .meshes_added = 1};
    row.result->meshes.push_back({.name = "body",
                                  .mesh = 2,
                                  .primitive = 0,
                                  .vertices = 8,
                                  .vertices_split = 3,
                                  .normals = SmoothedMesh::Change::replaced,
                                  .tangents = SmoothedMesh::Change::removed});
    const Json json = Json::parse(to_json(std::span(&row, 1)));
    EXPECT_EQ(json["schema"], "rakelight.smooth/1");
    const Json& got = json["rows"][0];
    EXPECT_EQ(got["vertices_split"], 3);
    EXPECT_EQ(got["meshes_added"], 1);
    EXPECT_EQ(got["meshes"][0]["normals"], "replaced");
    EXPECT_EQ(got["meshes"][0]["tangents"], "removed");
    EXPECT_EQ(got["meshes"][0]["mesh"], 2);
}

}  // namespace
}  // namespace rakelight
