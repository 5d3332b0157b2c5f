// SPDX-License-Identifier: Apache-2.0
// The real and the hostile OBJ files beside the repository.
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "io/model_readers.h"
#include "scene/placement.h"
#include "support/shared.h"
#include "support/temporary_folder.h"

namespace rakelight::io {
namespace {

namespace fs = std::filesystem;

struct Loaded {
    Scene scene;
    std::string error;
    std::vector<ReportEntry> remarks;
};

Loaded load(const fs::path& path) {
    Loaded result;
    Context context;
    try {
        result.scene = obj_reader.read(path.string(), {}, context);
        validate(result.scene);
    } catch (const Error& e) {
        result.error = e.what();
        EXPECT_EQ(e.code(), ErrorCode::bad_file) << path;
    }
    result.remarks = context.report().entries();
    return result;
}

std::uint64_t triangles(const Scene& scene) {
    std::uint64_t sum = 0;
    for (const Mesh& m : scene.meshes) sum += m.triangle_count();
    return sum;
}

bool is_bad_news(const ReportEntry& e) { return e.remark != Remark::note; }

/// Triangles of assets/INDEX.md; objects by our rule (its column "obj" counts primitives of another reader). spider and
/// hollowcube have one normal `0 0 0`, which stays at its corners; the two o of groups.obj end what its g would
/// begin.
struct Expected {
    const char* file;
    std::size_t objects;
    std::uint64_t triangles;
    std::size_t without_normals;  ///< triangle meshes without normals
    bool has_zero_normals = false;
};
void PrintTo(const Expected& e, std::ostream* out) { *out << e.file; }

class ObjAssets : public ::testing::TestWithParam<Expected> {};

TEST_P(ObjAssets, HaveTheirObjectsAndTriangles) {
    RL_NEEDS_SHARED("assets");
    const Expected& expected = GetParam();
    const Loaded l = load(rakelight::test::shared_dir() / "assets" / expected.file);
    ASSERT_EQ(l.error, "");
    EXPECT_EQ(l.scene.nodes.size(), expected.objects);
    EXPECT_EQ(triangles(l.scene), expected.triangles);
    const auto without = std::count_if(l.scene.meshes.begin(), l.scene.meshes.end(), [](const Mesh& m) {
        return m.topology == Topology::triangles && m.normals.empty();
    });
    EXPECT_EQ(std::size_t(without), expected.without_normals);
    std::size_t zeros = 0;
    for (const Mesh& m : l.scene.meshes) {
        EXPECT_NE(m.material, no_index);
        for (const vec3& p : m.positions) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        for (const vec3& n : m.normals) {
            const bool is_zero = n == vec3{};
            zeros += is_zero;
            EXPECT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, is_zero ? 0 : 1, 1e-6);
        }
    }
    EXPECT_EQ(zeros > 0, expected.has_zero_normals);
}

INSTANTIATE_TEST_SUITE_P(
    Index, ObjAssets,
    ::testing::Values(
        Expected{"obj/assimp/spider.obj", 19, 1368, 0, true}, Expected{"obj/assimp/regr01.obj", 55, 2710, 55},
        Expected{"obj/assimp/cube_usemtl.obj", 1, 12, 0}, Expected{"obj/assimp/box_longline.obj", 1, 944, 1},
        Expected{"obj/assimp/concave_polygon.obj", 1, 64, 0},
        Expected{"obj/assimp/cube_with_vertexcolors.obj", 1, 12, 0},
        Expected{"obj/assimp/box_mat_with_spaces.obj", 1, 12, 1}, Expected{"obj/assimp/number_formats.obj", 1, 1, 1},
        Expected{"obj/assimp/testmixed.obj", 1, 12, 1}, Expected{"obj/assimp/mtl_different_folder.obj", 1, 12, 1},
        Expected{"obj/tinyobj/cornell_box.obj", 8, 36, 8},
        Expected{"obj/tinyobj/cornell_box_multimaterial.obj", 8, 36, 9},
        Expected{"obj/tinyobj/smoothing-normal.obj", 2, 6, 2},
        Expected{"obj/tinyobj/issue-162-smoothing-group.obj", 2, 12, 0},
        Expected{"obj/tinyobj/smoothing-group-two-squares.obj", 1, 3, 1},
        Expected{"obj/tinyobj/map-bump.obj", 1, 400, 0}, Expected{"obj/tinyobj/usemtl-issue-104.obj", 1, 6, 1},
        Expected{"obj/tinyobj/issue-235-usemtl-then-o.obj", 2, 2, 0}, Expected{"obj/tinyobj/cube.obj", 6, 12, 6},
        Expected{"obj/tinyobj/texture-filename-with-whitespace.obj", 6, 12, 6},
        Expected{"obj/tinyobj/issue-140-zero-face-idx.obj", 1, 1, 1},
        Expected{"obj/tinyobj/leading-decimal-dot-issue-201.obj", 1, 1, 1},
        Expected{"obj/trimesh/groups.obj", 2, 2308, 0}, Expected{"obj/trimesh/two_objects.obj", 2, 16, 2},
        Expected{"obj/trimesh/negative_indices.obj", 1, 12, 0}, Expected{"obj/trimesh/polygonfaces.obj", 1, 3, 1},
        Expected{"obj/trimesh/quadknot.obj", 1, 2880, 0}, Expected{"obj/trimesh/fuze.obj", 1, 1000, 0},
        Expected{"obj/trimesh/singlevn.obj", 1, 2, 0}, Expected{"obj/spot.obj", 1, 5856, 1},
        Expected{"obj/teapot.obj", 1, 6320, 1}, Expected{"obj/cornell_box.obj", 7, 34, 7},
        Expected{"obj/hollowcube.obj", 3, 900, 0, true}, Expected{"obj/LeePerrySmith/head.obj", 1, 17684, 0},
        Expected{"textures/parallax_cube/parallax_plane.obj", 2, 4, 2},
        Expected{"crossformat/table_long_decorated_C/table_long_decorated_C.obj", 1, 3499, 0},
        Expected{"crossformat/keg_decorated/keg_decorated.obj", 1, 2058, 0},
        Expected{"crossformat/stairs_wood_decorated/stairs_wood_decorated.obj", 1, 2537, 0},
        Expected{"derived/spot/spot_whole.obj", 1, 5856, 1}, Expected{"derived/spot/spot_slab5.obj", 5, 5856, 5},
        Expected{"derived/spot/spot_checker6.obj", 2, 5856, 2}, Expected{"derived/spot/spot_noise7.obj", 7, 5856, 7},
        Expected{"fbx/ufbx/blender_293_instancing.obj", 8, 7744, 0},
        Expected{"fbx/ufbx/blender_340_mirrored_normals.obj", 2, 968, 0},
        Expected{"fbx/ufbx/max_geometry_transform.obj", 2, 24, 0},
        Expected{"fbx/ufbx/maya_instanced_pivots.obj", 2, 24, 0},
        Expected{"fbx/ufbx/blender_282_suzanne_and_transform.obj", 2, 1936, 0}));

TEST(ObjAssetFiles, CutCopiesHaveThePositionsOfTheWhole) {
    RL_NEEDS_SHARED("assets");
    const fs::path folder = rakelight::test::shared_dir() / "assets/derived/spot";
    const auto positions = [&](const char* name) {
        std::map<std::array<float, 3>, int> found;
        for (const Mesh& m : load(folder / name).scene.meshes)
            for (const vec3& p : m.positions) found[{p.x, p.y, p.z}] = 1;
        return found;
    };
    EXPECT_EQ(positions("spot_whole.obj"), positions("spot_slab5.obj"));
    EXPECT_EQ(positions("spot_whole.obj"), positions("spot_noise7.obj"));
}

TEST(ObjAssetFiles, TheHeadHasItsColorAndNormalMap) {
    RL_NEEDS_SHARED("assets");
    const Loaded l = load(rakelight::test::shared_dir() / "assets/obj/LeePerrySmith/head.obj");
    ASSERT_EQ(l.scene.materials.size(), 1u);
    EXPECT_TRUE(l.scene.materials[0].base_color_texture);
    EXPECT_TRUE(l.scene.materials[0].normal_texture);
    EXPECT_EQ(l.scene.textures.size(), 2u);
    EXPECT_TRUE(l.remarks.empty());
}

struct HostileCase {
    std::string file, verdict;
};
void PrintTo(const HostileCase& c, std::ostream* out) { *out << c.file; }

/// OBJ and MTL cases of hostile/cases.json: lines of the form ["FILE", "WHAT", "VERDICT"].
std::vector<HostileCase> hostile_cases() {
    std::vector<HostileCase> cases;
    std::ifstream in(rakelight::test::shared_dir() / "hostile/cases.json");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::vector<std::string> strings;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == ']' && strings.size() == 3) {
            if (strings[0].ends_with(".obj") || strings[0].ends_with(".mtl")) cases.push_back({strings[0], strings[2]});
        }
        if (text[i] == '[' || text[i] == ']') strings.clear();
        if (text[i] != '"') continue;
        std::string s;
        for (++i; i < text.size() && text[i] != '"'; ++i) {
            if (text[i] == '\\') ++i;
            s += text[i];
        }
        strings.push_back(s);
    }
    return cases;
}

class ObjHostile : public ::testing::TestWithParam<HostileCase> {};

/// A copy of an MTL case beside a quad that uses its first material.
Loaded load_through_quad(const fs::path& mtl) {
    const rakelight::test::TemporaryFolder folder;
    std::string name = "m";
    std::ifstream in(mtl, std::ios::binary);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("newmtl ") && line.size() > 8) {
            name = line.substr(7);
            break;
        }
    std::ofstream(folder / "case.mtl", std::ios::binary) << std::ifstream(mtl, std::ios::binary).rdbuf();
    std::ofstream(folder / "quad.obj", std::ios::binary)
        << "mtllib case.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl " << name << "\nf 1 2 3 4\n";
    return load(folder / "quad.obj");
}

TEST_P(ObjHostile, KeepsTheRule) {
    const HostileCase& c = GetParam();
    const fs::path path = rakelight::test::shared_dir() / "hostile" / c.file;
    const Loaded l = c.verdict == "via-obj" ? load_through_quad(path) : load(path);
    if (c.verdict == "refuse") {
        EXPECT_NE(l.error, "");
    } else if (c.verdict == "render") {
        EXPECT_EQ(l.error, "");
    } else if (c.verdict == "warn+render") {
        EXPECT_EQ(l.error, "");
        EXPECT_TRUE(std::any_of(l.remarks.begin(), l.remarks.end(), is_bad_news));
    }
    if (!l.error.empty()) {
        EXPECT_NE(l.error.find(c.verdict == "via-obj" ? "quad.obj" : path.filename().string()), std::string::npos);
        EXPECT_EQ(l.error.find('\n'), std::string::npos);
    } else {
        EXPECT_GT(l.scene.meshes.size(), 0u);
        if (c.file.starts_with("obj/") && c.verdict == "either") {
            EXPECT_TRUE(std::any_of(l.remarks.begin(), l.remarks.end(), is_bad_news));
        }
    }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ObjHostile);
INSTANTIATE_TEST_SUITE_P(Cases, ObjHostile, ::testing::ValuesIn([] {
                             std::vector<HostileCase> cases;
                             for (HostileCase& c : hostile_cases())
                                 if (c.verdict != "-") cases.push_back(std::move(c));
                             return cases;
                         }()));

}  // namespace
}  // namespace rakelight::io
