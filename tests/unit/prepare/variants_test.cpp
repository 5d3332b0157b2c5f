// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/base/error.h>

#include "prepare/split_vertices.h"
#include "prepare/variants.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

using test::quad_mesh;

Mesh quad_with_normals(float x) {
    Mesh mesh = quad_mesh();
    mesh.normals = std::vector<vec3>(4, {x, 0, 1});
    return mesh;
}

TEST(MeshVariants, ShareEqualResultsAndAddDifferentOnes) {
    Scene scene = test::scene_of({quad_mesh()});
    scene.nodes.resize(4, scene.nodes[0]);
    const auto instances = drawn_instances(scene);
    ASSERT_EQ(instances.size(), 4u);
    Context context;
    MeshVariants variants(scene, context);
    EXPECT_EQ(variants.place(instances[0], quad_with_normals(0)), 0u);
    EXPECT_EQ(variants.place(instances[1], quad_with_normals(1)), 1u);
    EXPECT_EQ(variants.place(instances[2], quad_with_normals(1e-7f)), 0u) << "rounding makes no copy";
    EXPECT_EQ(variants.place(instances[3], quad_with_normals(1)), 1u);
    EXPECT_EQ(variants.copies(), 1u);
    EXPECT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.nodes[3].meshes[0], 1u);
}

TEST(MeshVariants, AreChargedBeforeTheTableOfMeshesGrows) {
    Context context({.max_memory = 100 * sizeof(Mesh)});
    {
        Scene scene = test::scene_of({quad_mesh()});
        scene.nodes.resize(1000, scene.nodes[0]);
        const auto instances = drawn_instances(scene);
        MeshVariants variants(scene, context);
        std::size_t placed = 0;
        const auto place_all = [&] {
            for (; placed < instances.size(); ++placed)
                variants.place(instances[placed], quad_with_normals(float(placed)));
        };
        EXPECT_THROW(place_all(), Error);
        EXPECT_GT(placed, 20u);
        EXPECT_EQ(scene.meshes.size(), placed) << "what was refused was not made";
        EXPECT_GE(context.memory().charged(), (placed - 1) * sizeof(Mesh));
    }
    EXPECT_EQ(context.memory().charged(), 0u);
}

TEST(DrawnInstances, LeaveOutLinesAndMeshesWithoutTriangles) {
    Mesh lines = quad_mesh(), nothing = quad_mesh();
    lines.topology = Topology::lines;
    nothing.indices = {};
    const Scene scene = test::scene_of({lines, nothing, quad_mesh()});
    const auto instances = drawn_instances(scene);
    ASSERT_EQ(instances.size(), 1u);
    EXPECT_EQ(instances[0].mesh, 2u);
    EXPECT_TRUE(drawn_instances(Scene{}).empty());
}

TEST(SameSurface, SeesOtherTrianglesHandednessAndCoordinates) {
    const Mesh a = quad_with_normals(0);
    Mesh b = a;
    EXPECT_TRUE(same_surface(a, b));
    b.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 1};
    EXPECT_FALSE(same_surface(a, b));
    b = a;
    b.texcoords.emplace_back(std::vector<vec2>(4));
    EXPECT_FALSE(same_surface(a, b));
    Mesh c = a, d = a;
    c.tangents = std::vector<vec4>(4, {1, 0, 0, 1});
    d.tangents = std::vector<vec4>(4, {1, 0, 0, -1});
    EXPECT_FALSE(same_surface(c, d));
    EXPECT_FALSE(same_surface(a, c));
}

TEST(SplitVertices, ExtendEveryArrayOfTheMesh) {
    Context context;
    Mesh mesh = quad_with_normals(0);
    mesh.tangents = std::vector<vec4>(4, {1, 0, 0, 1});
    mesh.texcoords = {
        std::vector<vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}, std::vector<vec2>{{5, 0}, {6, 0}, {7, 0}, {8, 0}}};
    mesh.colors = std::vector<vec4>{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
    std::vector<JointInfluence> influences(4);
    influences[2].joints[0] = 9;
    mesh.influences = influences;
    mesh.targets = {{"", std::vector<vec3>{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}}, {}, {}}};
    split_vertices(mesh, {0, 1, 2, 5, 4, 3}, std::vector<std::uint32_t>{2, 0}, context);
    ASSERT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.positions[4], (vec3{1, 1, 0}));
    EXPECT_EQ(mesh.positions[5], (vec3{0, 0, 0}));
    EXPECT_EQ(mesh.normals.size(), 6u);
    EXPECT_EQ(mesh.tangents.size(), 6u);
    EXPECT_EQ(mesh.texcoords[0][4], (vec2{1, 1}));
    EXPECT_TRUE(mesh.texcoords[1].empty());
    EXPECT_EQ(mesh.texcoords[2][4].x, 7);
    EXPECT_EQ(mesh.colors[4].y, 1);
    EXPECT_EQ(mesh.influences[4].joints[0], 9);
    EXPECT_EQ(mesh.targets[0].positions[4].z, 2);
    EXPECT_TRUE(mesh.targets[0].normals.empty());
    EXPECT_EQ(mesh.indices[3], 5u);
}

TEST(SplitVertices, WithoutAnySharesAllBlocks) {
    Context context;
    const Mesh before = quad_with_normals(0);
    Mesh mesh = before;
    split_vertices(mesh, {}, {}, context);
    EXPECT_TRUE(mesh.positions == before.positions && mesh.indices == before.indices && mesh.normals == before.normals);
}

}  // namespace
}  // namespace rakelight
