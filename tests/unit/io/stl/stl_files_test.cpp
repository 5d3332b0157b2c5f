// SPDX-License-Identifier: Apache-2.0
// Real STL files, and broken ones, by the table of readers: no build needs the import helper for them.
#include <optional>

#include "support/hostile_cases.h"
#include "unit/io/stl/stl_support.h"

namespace rakelight::io::stl_test {
namespace {

Scene read(const std::string& name) {
    Context context;
    Scene scene = read_scene((rakelight::test::shared_dir() / "assets/stl" / name).string(), {}, context);
    EXPECT_EQ(context.report().entries().size(), name == "torus.STL" ? 1u : 0u) << name;
    return scene;
}

TEST(StlFiles, RealFilesHaveTheirTrianglesAndVertices) {
    RL_NEEDS_SHARED("assets");
    struct Row {
        const char* name;
        std::size_t meshes, triangles, vertices;
    };
    for (const Row& row : {Row{"20mm-xyz-cube.stl", 1, 260, 132}, Row{"Spider_ascii.stl", 1, 1368, 722},
                           Row{"Spider_binary.stl", 1, 1368, 722}, Row{"sphereWithHole.stl", 1, 285, 146},
                           Row{"torus.STL", 1, 8700, 4350}, Row{"triangle.stl", 1, 1, 3},
                           Row{"triangle_with_two_solids.stl", 2, 2, 6}}) {
        const Scene scene = read(row.name);
        std::size_t vertices = 0;
        for (const Mesh& mesh : scene.meshes) {
            vertices += mesh.positions.size();
            EXPECT_TRUE(mesh.normals.empty() && mesh.polygons.empty() && mesh.colors.empty()) << row.name;
        }
        EXPECT_EQ(scene.meshes.size(), row.meshes) << row.name;
        EXPECT_EQ(triangle_count(scene), row.triangles) << row.name;
        EXPECT_EQ(vertices, row.vertices) << row.name;
    }
}

TEST(StlFiles, TextAndBinaryGiveTheSameTriangles) {
    RL_NEEDS_SHARED("assets");
    const Scene ascii_scene = read("Spider_ascii.stl"), binary_scene = read("Spider_binary.stl");
    const Mesh &ascii = ascii_scene.meshes.at(0), &binary = binary_scene.meshes.at(0);
    ASSERT_EQ(ascii.indices.size(), binary.indices.size());
    for (std::size_t i = 0; i < ascii.indices.size(); ++i)
        ASSERT_LT(length(ascii.positions[ascii.indices[i]] - binary.positions[binary.indices[i]]), 1e-5f) << i;
}

TEST(StlFiles, BrokenOnesKeepTheirVerdicts) {
    RL_NEEDS_SHARED("hostile");
    std::size_t seen = 0;
    for (const auto& [name, fault, verdict, path] : rakelight::test::hostile_cases()) {
        if (!name.ends_with(".stl")) continue;
        SCOPED_TRACE(name + ": " + verdict);
        ++seen;
        Context context;
        std::optional<Error> error;
        try {
            read_scene(path.string(), {}, context);
        } catch (const Error& e) {
            error = e;
        }
        if (error) {
            EXPECT_EQ(error->code(), ErrorCode::bad_file);
            EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos);
        }
        EXPECT_TRUE(verdict != "refuse" || error) << "it was accepted";
        EXPECT_TRUE(verdict != "warn+render" || (!error && !context.report().entries().empty()));
        EXPECT_TRUE(verdict != "either" || error || !context.report().entries().empty()) << "accepted without a word";
    }
    EXPECT_GE(seen, 9u);
}

}  // namespace
}  // namespace rakelight::io::stl_test
