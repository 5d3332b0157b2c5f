// SPDX-License-Identifier: Apache-2.0
// The real models of ../shared/assets: all load, with the number of triangles that INDEX.md gives.
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "image/maps/green_direction.h"
#include "io/model_readers.h"
#include "math/linear.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"
#include "support/shared.h"

namespace rakelight {
namespace {

bool is_gltf(const std::filesystem::path& path) { return path.extension() == ".gltf" || path.extension() == ".glb"; }

std::vector<std::filesystem::path> gltf_assets() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::shared_dir() / "assets"))
        if (entry.is_regular_file() && is_gltf(entry.path())) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::string cell(const std::string& row, std::size_t column) {
    std::size_t at = 0;
    for (std::size_t c = 0; c <= column; ++c) at = row.find('|', at) + 1;
    const std::string text = row.substr(at, row.find('|', at) - at);
    const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// Triangles by file, from the tables of INDEX.md: a section is a folder, the first column a path in it, the fourth the
/// count.
std::map<std::string, std::uint64_t> expected_triangles() {
    std::map<std::string, std::uint64_t> result;
    std::ifstream in(test::shared_dir() / "assets" / "INDEX.md");
    std::string line, section;
    while (std::getline(in, line)) {
        if (line.starts_with("## ")) section = line.substr(3);
        if (!line.starts_with("| ") || !is_gltf(cell(line, 0))) continue;
        const std::string count = cell(line, 3);
        if (!count.empty() && count.find_first_not_of("0123456789") == std::string::npos)
            result[section + "/" + cell(line, 0)] = std::stoull(count);
    }
    // The table was made by a program that does not know EXT_mesh_gpu_instancing: 125 boxes, not one.
    result["gltf/SimpleInstancing/SimpleInstancing.glb"] = 125 * 12;
    return result;
}

TEST(GltfAssets, AllLoadAndAreValidScenes) {
    RL_NEEDS_SHARED("assets");
    const auto paths = gltf_assets();
    EXPECT_GE(paths.size(), 80u);
    for (const auto& path : paths) {
        SCOPED_TRACE(path.string());
        Context context({.threads = 1});
        try {
            const Scene scene = io::gltf_reader.read(path.string(), {}, context);
            EXPECT_NO_THROW(validate(scene));
            EXPECT_FALSE(world_bounds(scene).empty());
            EXPECT_TRUE(scene.missing_normals_are_flat);
        } catch (const Error& error) {
            ADD_FAILURE() << error.what();
        }
    }
}

TEST(GltfAssets, HaveTheTriangleCountsOfTheIndex) {
    RL_NEEDS_SHARED("assets");
    const auto expected = expected_triangles();
    EXPECT_GE(expected.size(), 70u);
    for (const auto& [name, triangles] : expected) {
        Context context({.threads = 1});
        const Scene scene = io::gltf_reader.read((test::shared_dir() / "assets" / name).string(), {}, context);
        EXPECT_EQ(triangle_count(scene), triangles) << name;
    }
}

TEST(GltfAssets, TexturesAreFoundWhereTheFilesHaveThem) {
    RL_NEEDS_SHARED("assets");
    for (const auto& path : gltf_assets()) {
        Context context({.threads = 1});
        io::gltf_reader.read(path.string(), {}, context);
        for (const ReportEntry& entry : context.report().entries())
            EXPECT_EQ(entry.message.find("Texture is left out"), std::string::npos)
                << path << ": " << entry.place << ": " << entry.message;
    }
}

/// What the normal maps of the materials say of their green, each picture once.
std::vector<GreenDirection> greens_of(const Scene& scene, std::set<std::string>& seen, Context& context) {
    std::vector<GreenDirection> greens;
    for (const Material& m : scene.materials) {
        if (!m.normal_texture) continue;
        const EncodedImage& image = *scene.textures[m.normal_texture.texture].image;
        if (!seen.insert(image.path.empty() ? image.file + image.name : image.path).second) continue;
        const Pixels pixels = image.decode(image, context);
        if (pixels.component != Component::u8 || pixels.channels < 3) continue;
        std::vector<std::uint32_t> texels;
        for (std::size_t i = 0; i < pixels.bytes.size(); i += std::size_t(pixels.channels))
            texels.push_back(std::uint32_t(pixels.bytes[i]) | std::uint32_t(pixels.bytes[i + 1]) << 8 |
                             std::uint32_t(pixels.bytes[i + 2]) << 16);
        greens.push_back(find_green_direction(texels, pixels.width, pixels.height, pixels.width));
    }
    return greens;
}

/// glTF says that green points up, so none may be called green-down. That of the scanned head does point down.
TEST(GltfAssets, NormalMapsAreNotCalledGreenDown) {
    RL_NEEDS_SHARED("assets");
    Context context({.threads = 1});
    std::set<std::string> seen;
    int maps = 0, up = 0;
    for (const auto& path : gltf_assets())
        for (const GreenDirection& green : greens_of(io::gltf_reader.read(path.string(), {}, context), seen, context)) {
            EXPECT_FALSE(green.is_down()) << path;
            ++maps;
            up += green.is_up();
        }
    EXPECT_GE(maps, 13);
    EXPECT_GE(up, 5);
    const std::string head = (test::shared_dir() / "assets/obj/LeePerrySmith/head.obj").string();
    const std::vector<GreenDirection> of_head = greens_of(io::obj_reader.read(head, {}, context), seen, context);
    ASSERT_EQ(of_head.size(), 1u);
    EXPECT_TRUE(of_head[0].is_down());
}

TEST(GltfAssets, CutCopiesHoldTheSamePositionsAsTheWhole) {
    RL_NEEDS_SHARED("assets");
    const auto positions = [](const std::string& name) {
        Context context({.threads = 1});
        const Scene scene =
            io::gltf_reader.read((test::shared_dir() / "assets/derived/spot" / name).string(), {}, context);
        std::set<std::array<float, 3>> set;
        for (const Mesh& mesh : scene.meshes) {
            EXPECT_EQ(mesh.origin, (dvec3{0, 0, 0}));
            for (const std::uint32_t i : mesh.indices)
                set.insert({mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z});
        }
        return set;
    };
    const auto whole = positions("spot_whole.glb");
    for (const char* part : {"spot_slab5.glb", "spot_checker6.glb", "spot_noise7.glb"})
        EXPECT_EQ(positions(part), whole) << part;
}

Scene load(const char* name) {
    Context context({.threads = 1});
    return io::gltf_reader.read((test::shared_dir() / "assets/gltf" / name).string(), {}, context);
}

TEST(GltfAssets, CamerasAreReadAtTheirNodes) {
    RL_NEEDS_SHARED("assets");
    const Scene scene = load("Cameras/Cameras.gltf");
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].projection, Projection::perspective);
    EXPECT_NEAR(scene.cameras[0].vertical_fov_rad, 0.7, 1e-12);
    EXPECT_EQ(scene.cameras[1].projection, Projection::orthographic);
    EXPECT_EQ(scene.cameras[1].half_height, 1);
    EXPECT_NE(scene.cameras[0].node, no_index);
}

TEST(GltfAssets, ModesBecomeTrianglesLinesAndPoints) {
    RL_NEEDS_SHARED("assets");
    const Scene scene = load("MeshPrimitiveModes/MeshPrimitiveModes.gltf");
    std::map<Topology, int> count;
    for (const Mesh& mesh : scene.meshes) ++count[mesh.topology];
    EXPECT_EQ(count[Topology::points], 1);
    EXPECT_EQ(count[Topology::lines], 3);
    EXPECT_EQ(count[Topology::triangles], 3);
}

TEST(GltfAssets, SkinsAnimationsAndInfluencesAreKept) {
    RL_NEEDS_SHARED("assets");
    const Scene scene = load("RiggedFigure/RiggedFigure.glb");
    ASSERT_EQ(scene.skins.size(), 1u);
    EXPECT_EQ(scene.skins[0].joints.size(), scene.skins[0].inverse_bind.size());
    ASSERT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.meshes[0].influences.size(), scene.meshes[0].positions.size());
    for (const JointInfluence& influence : scene.meshes[0].influences)
        EXPECT_NEAR(influence.weights[0] + influence.weights[1] + influence.weights[2] + influence.weights[3], 1, 1e-5);
    ASSERT_EQ(scene.animations.size(), 1u);
    EXPECT_FALSE(scene.animations[0].channels.empty());
}

TEST(GltfAssets, InstancesAreNodesThatShareTheirMeshes) {
    RL_NEEDS_SHARED("assets");
    const Scene scene = load("SimpleInstancing/SimpleInstancing.glb");
    EXPECT_EQ(scene.meshes.size(), 1u);
    std::set<std::array<double, 3>> places;
    for (const Node& node : scene.nodes)
        if (!node.meshes.empty())
            places.insert({node.local.translation.x, node.local.translation.y, node.local.translation.z});
    EXPECT_EQ(places.size(), 125u);
}

}  // namespace
}  // namespace rakelight
