// SPDX-License-Identifier: Apache-2.0
// Every model of the set in every format that can be written from it: the same triangles, the attributes that were
// computed, nothing else changed, and a second run changes nothing.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <functional>
#include <map>
#include <set>

#include "math/linear.h"
#include "prepare/normals/bind_pose.h"
#include "smooth_file_support.h"
#include "support/shared.h"
#include "tools/smooth/smooth_file_scene.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::json;

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

/// Accessors that are the normals or tangents of primitives and nothing else: their numbers may be overwritten.
std::set<std::size_t> directions(const Json& tree) {
    std::set<std::size_t> found, others;
    for (const Json& mesh : tree.value("meshes", Json::array()))
        for (const Json& primitive : mesh["primitives"]) {
            if (primitive.contains("indices")) others.insert(primitive["indices"].get<std::size_t>());
            for (const auto& [name, accessor] : primitive["attributes"].items())
                (name == "NORMAL" || name == "TANGENT" ? found : others).insert(accessor.get<std::size_t>());
            for (const Json& target : primitive.value("targets", Json::array()))
                for (const Json& accessor : target) others.insert(accessor.get<std::size_t>());
        }
    for (const Json& animation : tree.value("animations", Json::array()))
        for (const Json& sampler : animation["samplers"])
            others.insert({sampler["input"].get<std::size_t>(), sampler["output"].get<std::size_t>()});
    for (const std::size_t a : others) found.erase(a);
    return found;
}

/// The entries of the old list stand in front of the new one, unchanged, but for the bounds of the accessors in `free`.
void expect_prefix(const Json& before, const Json& after, const char* name, const std::set<std::size_t>& free) {
    const Json old = before.value(name, Json::array()), now = after.value(name, Json::array());
    ASSERT_GE(now.size(), old.size()) << name;
    for (std::size_t i = 0; i < old.size(); ++i)
        if (free.contains(i)) {
            EXPECT_EQ(without(now[i], {"min", "max"}), without(old[i], {"min", "max"})) << name << " " << i;
            EXPECT_EQ(now[i].contains("min"), old[i].contains("min"));
        } else {
            EXPECT_EQ(now[i], old[i]) << name << " " << i;
        }
}

/// `data` with zeros where the elements of an accessor lie.
void blank(std::string& data, const Json& tree, std::size_t accessor) {
    static const std::map<int, std::size_t> sizes{{5120, 1}, {5122, 2}, {5126, 4}};
    const Json& a = tree["accessors"][accessor];
    if (!a.contains("bufferView")) return;
    const Json& view = tree["bufferViews"][a["bufferView"].get<std::size_t>()];
    const std::size_t size = (a["type"] == "VEC4" ? 4 : 3) * sizes.at(a["componentType"].get<int>());
    const std::size_t begin = view.value("byteOffset", std::size_t(0)) + a.value("byteOffset", std::size_t(0));
    for (std::size_t i = 0; i < a["count"].get<std::size_t>(); ++i)
        std::fill_n(data.begin() + std::ptrdiff_t(begin + i * view.value("byteStride", size)), size, '\0');
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
    const std::set<std::size_t> free =
        before.binary.empty() ? std::set<std::size_t>{} : directions(before.tree);  // files beside are left alone
    expect_prefix(before.tree, after.tree, "accessors", free);
    expect_prefix(before.tree, after.tree, "bufferViews", {});
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
        std::string was = before.binary.substr(0, length), is = after.binary.substr(0, length);
        for (const std::size_t a : free) blank(was, before.tree, a), blank(is, before.tree, a);
        EXPECT_TRUE(was == is) << "bytes that are neither normals nor tangents changed";
    }
}

using Triangle = std::array<dvec3, 3>;

bool is_less(const dvec3& a, const dvec3& b) { return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z}; }

/// The drawn triangles in the world, skinned ones in bind pose, corners of each in a fixed order (a mirrored placement may turn them round), the
/// triangles in the order of the scene.
/// @param is_turned  from Z up to Y up
std::vector<Triangle> triangles_of(const Scene& scene, bool is_turned = false) {
    std::vector<Triangle> found;
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        for (const std::uint32_t m : scene.nodes[n].meshes) {
            const Mesh& mesh = scene.meshes[m];
            if (mesh.topology != Topology::triangles) continue;
            for (std::size_t c = 0; c + 2 < mesh.indices.size(); c += 3) {
                Triangle t;
                for (std::size_t k = 0; k < 3; ++k) {
                    t[k] = transform_point(world[n], cast<double>(mesh.positions[mesh.indices[c + k]]) + mesh.origin);
                    if (is_turned) t[k] = {t[k].x, t[k].z, -t[k].y};
                }
                std::sort(t.begin(), t.end(), is_less);
                found.push_back(t);
            }
        }
    return found;
}

/// Equal to the rounding of a world position to float, or to its double sum over another chain of nodes.
void expect_same_triangles(const std::vector<Triangle>& wanted, const std::vector<Triangle>& got) {
    ASSERT_EQ(wanted.size(), got.size());
    double extent = 0;
    for (const Triangle& t : wanted)
        for (const dvec3& p : t) extent = std::max({extent, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    std::size_t wrong = 0;
    // Rounding may turn the order of two corners that are one number apart: each corner needs some partner.
    const auto near = [&](const dvec3& a, const dvec3& b) { return length(a - b) <= 2e-7 * extent; };
    for (std::size_t i = 0; i < wanted.size(); ++i)
        for (const dvec3& p : wanted[i])
            wrong += std::none_of(got[i].begin(), got[i].end(), [&](const dvec3& q) { return near(p, q); });
    EXPECT_EQ(wrong, 0u) << "corners are elsewhere";
}

std::string lower_ending(const fs::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return ending;
}

bool is_gltf(const fs::path& path) { return path.extension() == ".glb" || path.extension() == ".gltf"; }

/// All models of the set that the program reads.
std::vector<fs::path> models(const std::set<std::string>& endings) {
    const fs::path root = shared_dir() / "assets";
    const Json refused = Json::parse(bytes_of(source_dir() / "tests/acceptance/refused_models.json"));
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(root))
        if (endings.contains(lower_ending(entry.path())) &&
            !refused.contains(fs::relative(entry.path(), root).generic_string()))
            found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

const std::set<std::string> helper_formats{".fbx", ".stl", ".ply", ".dae", ".3ds", ".ase", ".blend", ".off", ".x"};

/// Whether what has no place in GLB and PLY ruled the normals: smoothing groups.
bool has_smoothing_groups(const Scene& scene) {
    return std::any_of(scene.meshes.begin(), scene.meshes.end(),
                       [](const Mesh& m) { return !m.smoothing.empty() || !m.smoothing_hint.empty(); });
}

/// A model written to `output`, read back and smoothed again.
void expect_same_model_and_no_second_change(const fs::path& input, const fs::path& output,
                                            const SmoothFileOptions& options) {
    Context context;
    const Scene before = load(input.string(), {}, context);
    const SmoothedFile result = smooth_file(input.string(), output.string(), options, context);
    const Scene got = load(output.string(), {}, context);
    const bool is_turned = lower_ending(input) == ".stl" && output.extension() != ".ply";
    std::vector<Triangle> wanted = triangles_of(before, is_turned), now = triangles_of(got);
    if (output.extension() == ".obj") {  // faces with and without normals are two meshes, until all have them
        const auto less = [](const Triangle& a, const Triangle& b) {
            return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), is_less);
        };
        std::sort(wanted.begin(), wanted.end(), less);
        std::sort(now.begin(), now.end(), less);
    }
    expect_same_triangles(wanted, now);
    const bool in_place = lower_ending(input) == lower_ending(output) || (is_gltf(input) && is_gltf(output));
    if (output.extension() != ".obj" && output.extension() != ".ply" && (result.changed || !in_place) && in_place)
        expect_attributes(smooth_for_file(before, options, context).scene, got);
    const fs::path again = output.parent_path() / ("again" + output.extension().string());
    SmoothedFile second = smooth_file(output.string(), again.string(), options, context);
    if (!in_place && has_smoothing_groups(before)) {  // gone with the format: from then on nothing changes
        fs::copy_file(again, output, fs::copy_options::overwrite_existing);
        second = smooth_file(output.string(), again.string(), options, context);
    }
    EXPECT_FALSE(second.changed);
    EXPECT_TRUE(bytes_of(output) == bytes_of(again));
}

/// Runs `check` for each model in an empty folder of its own.
void for_each(const std::vector<fs::path>& files, const std::function<void(const fs::path&, const fs::path&)>& check) {
    const TemporaryFolder out;
    for (std::size_t i = 0; i < files.size(); ++i) {
        SCOPED_TRACE(files[i].string());
        const fs::path dir = out / std::to_string(i);
        fs::create_directories(dir);
        check(files[i], dir);
        fs::remove_all(dir);
    }
}

void smooth_all_gltf(const SmoothFileOptions& options) {
    const std::vector<fs::path> files = models({".glb", ".gltf"});
    ASSERT_GE(files.size(), 80u);
    for_each(files, [&](const fs::path& file, const fs::path& dir) {
        const fs::path out = dir / ("one" + file.extension().string());
        expect_same_model_and_no_second_change(file, out, options);
        expect_only_attributes_changed(file, out);
    });
}

TEST(SmoothAssets, GltfKeepsEverythingButNormalsAndTangents) {
    RL_NEEDS_SHARED("assets");
    smooth_all_gltf({.keep_unused = true});
}

TEST(SmoothAssets, GltfKeepsEverythingWhereAllVerticesAreSplitAndAllHaveTangents) {
    RL_NEEDS_SHARED("assets");
    SmoothFileOptions options = anew;
    options.attributes.crease_angle_rad = 0;
    options.tangents = TangentChoice::always;
    options.keep_unused = true;
    smooth_all_gltf(options);
}

TEST(SmoothAssets, GltfKeepsEverythingWhereAllNormalsAreMadeAnew) {
    RL_NEEDS_SHARED("assets");
    SmoothFileOptions options = anew;
    options.keep_unused = true;
    smooth_all_gltf(options);
}

template <class T>
bool are_same(const Block<T>& a, const Block<T>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

void expect_same_content(const Scene& a, const Scene& b) {
    EXPECT_EQ(a.cameras.size(), b.cameras.size());
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t n = 0; n < a.nodes.size(); ++n) {
        Node node = a.nodes[n];
        EXPECT_TRUE(are_same(node.morph_weights, b.nodes[n].morph_weights)) << n;
        node.morph_weights = b.nodes[n].morph_weights;
        EXPECT_EQ(node, b.nodes[n]) << n;
    }
    ASSERT_EQ(a.skins.size(), b.skins.size());
    for (std::size_t k = 0; k < a.skins.size(); ++k)
        EXPECT_TRUE(a.skins[k].name == b.skins[k].name && a.skins[k].joints == b.skins[k].joints &&
                    are_same(a.skins[k].inverse_bind, b.skins[k].inverse_bind))
            << k;
    ASSERT_EQ(a.meshes.size(), b.meshes.size());
    for (std::size_t m = 0; m < a.meshes.size(); ++m) {
        const Mesh &x = a.meshes[m], &y = b.meshes[m];
        EXPECT_TRUE(are_same(x.positions, y.positions) && are_same(x.indices, y.indices)) << m;
        EXPECT_TRUE(are_same(x.normals, y.normals) && are_same(x.tangents, y.tangents)) << m;
        EXPECT_TRUE(are_same(x.colors, y.colors) && are_same(x.influences, y.influences)) << m;
        ASSERT_EQ(x.texcoords.size(), y.texcoords.size());
        for (std::size_t set = 0; set < x.texcoords.size(); ++set)
            EXPECT_TRUE(are_same(x.texcoords[set], y.texcoords[set])) << m;
        ASSERT_EQ(x.targets.size(), y.targets.size());
        for (std::size_t t = 0; t < x.targets.size(); ++t)
            EXPECT_TRUE(are_same(x.targets[t].positions, y.targets[t].positions)) << m;
    }
    ASSERT_EQ(a.animations.size(), b.animations.size());
    for (std::size_t n = 0; n < a.animations.size(); ++n)
        for (std::size_t c = 0; c < a.animations[n].channels.size(); ++c) {
            const AnimationChannel &x = a.animations[n].channels[c], &y = b.animations[n].channels[c];
            EXPECT_TRUE(are_same(x.times, y.times) && are_same(x.values, y.values)) << n;
        }
    ASSERT_EQ(a.textures.size(), b.textures.size());
    for (std::size_t t = 0; t < a.textures.size(); ++t) {
        const auto &x = a.textures[t].image->bytes, &y = b.textures[t].image->bytes;
        EXPECT_TRUE(bool(x) == bool(y) && (!x || *x == *y)) << t;
    }
}

TEST(SmoothAssets, GlbFilesWithoutDeadBytesHoldTheSame) {
    RL_NEEDS_SHARED("assets");
    std::size_t smaller = 0;
    for_each(models({".glb", ".gltf"}), [&](const fs::path& file, const fs::path& dir) {
        Context context;
        SmoothFileOptions options = anew;
        options.attributes.crease_angle_rad = 0;
        smooth_file(file.string(), (dir / "lean.glb").string(), options, context);
        options.keep_unused = true;
        smooth_file(file.string(), (dir / "kept.glb").string(), options, context);
        expect_same_content(load((dir / "kept.glb").string(), {}, context),
                            load((dir / "lean.glb").string(), {}, context));
        smaller += fs::file_size(dir / "lean.glb") < fs::file_size(dir / "kept.glb");
    });
    EXPECT_GT(smaller, 40u);
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

TEST(SmoothAssets, ObjKeepsEveryOtherLine) {
    RL_NEEDS_SHARED("assets");
    const std::vector<fs::path> files = models({".obj"});
    ASSERT_GE(files.size(), 40u);
    for_each(files, [](const fs::path& file, const fs::path& dir) {
        expect_same_model_and_no_second_change(file, dir / "one.obj", {});
        EXPECT_EQ(other_lines(bytes_of(file)), other_lines(bytes_of(dir / "one.obj")));
    });
}

void write_all_as(const char* ending, std::set<std::string> from, std::size_t at_least) {
    if (!use_import_helper()) GTEST_SKIP() << "built without the import helper";
    from.insert(helper_formats.begin(), helper_formats.end());
    const std::vector<fs::path> files = models(from);
    ASSERT_GE(files.size(), at_least);
    for_each(files, [&](const fs::path& file, const fs::path& dir) {
        expect_same_model_and_no_second_change(file, dir / (std::string("one") + ending), {});
    });
}

TEST(SmoothAssets, EveryFormatIsWrittenAsGlb) {
    RL_NEEDS_SHARED("assets");
    write_all_as(".glb", {".obj", ".gltf"}, 90);
}

TEST(SmoothAssets, EveryFormatIsWrittenAsPly) {
    RL_NEEDS_SHARED("assets");
    write_all_as(".ply", {".obj", ".gltf", ".glb"}, 120);
}

}  // namespace
}  // namespace rakelight
