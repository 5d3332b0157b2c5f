// SPDX-License-Identifier: Apache-2.0
// What files get wrong, and the remark that each fault leaves.
#include <gtest/gtest.h>

#include <limits>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include "prepare/prepare_scene.h"
#include "prepare/repair/repair.h"
#include "scene/placement.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

using test::all_remarks;
using test::quad_mesh;
using test::remarks;
using test::scene_of;

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();
constexpr float inf_f = std::numeric_limits<float>::infinity();

Mesh with_normals(std::vector<vec3> normals) {
    Mesh mesh = quad_mesh();
    mesh.normals = std::move(normals);
    return mesh;
}

Mesh with_positions(std::vector<vec3> positions) {
    Mesh mesh = quad_mesh();
    mesh.positions = std::move(positions);
    return mesh;
}

TEST(Repair, LeavesAWholeMeshAloneToTheBlock) {
    Context context;
    Mesh mesh = with_normals(std::vector<vec3>(4, {0, 0, 1}));
    mesh.tangents = std::vector<vec4>(4, {1, 0, 0, -1});
    mesh.texcoords.emplace_back(std::vector<vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const Scene scene = scene_of({mesh});
    const Mesh after = repair_scene(scene, NormalSource::automatic, context).meshes[0];
    EXPECT_TRUE(after.positions == mesh.positions && after.indices == mesh.indices && after.normals == mesh.normals);
    EXPECT_TRUE(after.tangents == mesh.tangents && after.texcoords[0] == mesh.texcoords[0]);
    EXPECT_EQ(all_remarks(context), "");
}

TEST(Repair, DropsTrianglesThatTouchPositionsThatAreNotFinite) {
    for (const float broken : {nan_f, inf_f, -inf_f}) {
        Context context;
        Mesh mesh = with_positions({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, broken, 0}});
        mesh.smoothing = std::vector<std::uint32_t>{7, 8};
        mesh.smoothing_hint = std::vector<vec3>(6, {0, 0, 1});
        mesh.polygons = std::vector<std::uint32_t>{4, 5};
        const Scene scene = repair_scene(scene_of({mesh}), NormalSource::automatic, context);
        EXPECT_EQ(scene.meshes[0].triangle_count(), 1u);
        EXPECT_EQ(scene.meshes[0].smoothing.size(), 1u);
        EXPECT_EQ(scene.meshes[0].smoothing[0], 7u);
        EXPECT_EQ(scene.meshes[0].smoothing_hint.size(), 3u);
        ASSERT_EQ(scene.meshes[0].polygons.size(), 1u);
        EXPECT_EQ(scene.meshes[0].polygons[0], 4u);
        EXPECT_TRUE(is_finite(scene.meshes[0].positions[3]));
        EXPECT_NO_THROW(validate(scene));
        EXPECT_EQ(remarks(context, Remark::dropped, "not finite"), 1u);
    }
}

TEST(Repair, SaysNothingToDrawWhenNoTriangleIsLeft) {
    Context context;
    for (const Scene& scene : {scene_of({with_positions(std::vector<vec3>(4, {nan_f, 0, 0}))}), scene_of({})}) {
        try {
            prepare_scene(scene, {}, context);
            FAIL();
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ErrorCode::bad_file);
            EXPECT_STREQ(e.what(), "made.test: nothing to draw");
        }
    }
}

TEST(Repair, WarnsOfPositionsBeyondFloatProducts) {
    for (const float scale : {1e30f, 1e-30f}) {
        Context context;
        const Scene scene = scene_of({with_positions({{0, 0, 0}, {scale, 0, 0}, {scale, scale, 0}, {0, scale, 0}})});
        const Scene out = prepare_scene(scene, {}, context);
        EXPECT_EQ(remarks(context, Remark::warning, "range of float"), 1u) << scale;
        for (const vec3& n : out.meshes[0].normals) EXPECT_EQ(n, (vec3{0, 0, 1}));
    }
}

TEST(Repair, WarnsWhenAllTrianglesHaveNoAreaButNotWhenOneHas) {
    for (const auto& positions :
         {std::vector<vec3>(4, {1, 2, 3}), std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 0, 0}}}) {
        Context context;
        test::expect_unit(prepare_scene(scene_of({with_positions(positions)}), {}, context).meshes[0].normals, 4);
        EXPECT_EQ(remarks(context, Remark::warning, "zero area"), 1u);
    }
    Context context;
    Mesh mesh = quad_mesh();
    mesh.indices = std::vector<std::uint32_t>{0, 0, 1, 0, 1, 2};
    prepare_scene(scene_of({mesh}), {}, context);
    EXPECT_EQ(remarks(context, Remark::warning, ""), 0u) << all_remarks(context);
    EXPECT_EQ(remarks(context, Remark::note, "1 triangles of no area"), 1u) << all_remarks(context);
}

TEST(Repair, ComputesNormalsWhereAllAreBroken) {
    for (const vec3 broken : {vec3{nan_f, nan_f, nan_f}, vec3{0, 0, 0}, vec3{inf_f, 0, 0}}) {
        Context context;
        const Scene out = prepare_scene(scene_of({with_normals(std::vector<vec3>(4, broken))}), {}, context);
        for (const vec3& n : out.meshes[0].normals) EXPECT_EQ(n, (vec3{0, 0, 1}));
        EXPECT_EQ(remarks(context, Remark::warning, "zero or not finite"), 1u);
    }
}

TEST(Repair, ReplacesSingleBrokenNormalsByThoseOfTheFacesAround) {
    Context context;
    const vec3 tilted{0.6f, 0, 0.8f};
    const Scene out = prepare_scene(scene_of({with_normals({tilted, {nan_f, 0, 0}, {0, 0, 0}, tilted})}), {}, context);
    EXPECT_EQ(out.meshes[0].normals[0], tilted);
    EXPECT_EQ(out.meshes[0].normals[1], (vec3{0, 0, 1}));
    EXPECT_EQ(out.meshes[0].normals[2], (vec3{0, 0, 1}));
    EXPECT_EQ(remarks(context, Remark::warning, "replaced by computed ones"), 1u);
}

// The vertices 1 and 4, 2 and 5 stand at one place each: what a texture seam does to a smooth surface.
TEST(Repair, BrokenNormalsAtASeamAreThoseOfBothSides) {
    Mesh mesh = test::folded_mesh(radians(40));
    std::vector<vec3> positions(mesh.positions.begin(), mesh.positions.end());
    positions.push_back(positions[1]);
    positions.push_back(positions[2]);
    mesh.positions = positions;
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 6, 4, 5, 6, 5, 7};
    std::vector<vec3> normals(8, {0, 0, 1});
    for (const std::size_t v : {1u, 6u}) normals[v] = {0, 0, 0};
    mesh.normals = normals;
    Context context;
    const Mesh after = prepare_scene(scene_of({mesh}), {}, context).meshes[0];
    EXPECT_EQ(after.positions.size(), 8u);
    EXPECT_EQ(after.normals[1], after.normals[6]);
    EXPECT_NEAR(after.normals[1].x, std::sin(radians(20)), 0.02);
    EXPECT_EQ(after.normals[2], (vec3{0, 0, 1})) << "what is right stays";
}

TEST(Repair, MakesNormalsUnitAndSaysSoOnlyWhereItShows) {
    const std::pair<float, Remark> lengths[] = {
        {5, Remark::changed}, {1e-30f, Remark::changed}, {1e30f, Remark::changed}, {1.01f, Remark::note}};
    for (const auto& [size, remark] : lengths) {
        Context context;
        const Scene out = repair_scene(scene_of({with_normals(std::vector<vec3>(4, {0, size, 0}))}),
                                       NormalSource::automatic, context);
        EXPECT_EQ(out.meshes[0].normals[0], (vec3{0, 1, 0}));
        EXPECT_EQ(remarks(context, remark, "unit length"), 1u) << size;
    }
}

TEST(Repair, DropsTangentsWithABrokenSignOrDirection) {
    for (const vec4 broken :
         {vec4{1, 0, 0, 0}, vec4{1, 0, 0, nan_f}, vec4{1, 0, 0, 0.5f}, vec4{0, 0, 0, 1}, vec4{nan_f, 0, 0, 1}}) {
        Context context;
        Mesh mesh = with_normals(std::vector<vec3>(4, {0, 0, 1}));
        mesh.tangents = std::vector<vec4>{{1, 0, 0, 1}, {1, 0, 0, 1}, broken, {1, 0, 0, 1}};
        EXPECT_TRUE(repair_scene(scene_of({mesh}), NormalSource::automatic, context).meshes[0].tangents.empty());
        EXPECT_EQ(remarks(context, Remark::warning, "computed anew"), 1u);
    }
}

TEST(Repair, ATangentAlongItsNormalIsAsBadAsOneOfNoLength) {
    for (const vec4 tangent : {vec4{0, 0, 1, 1}, vec4{0, 0, -1, -1}, vec4{5e-4f, 0, 1, 1}, vec4{2e-3f, 0, 1, 1}}) {
        Context context;
        Mesh mesh = with_normals(std::vector<vec3>(4, {0, 0, 1}));
        mesh.tangents = std::vector<vec4>{{1, 0, 0, 1}, {1, 0, 0, 1}, tangent, {1, 0, 0, 1}};
        const bool leaves_a_direction = tangent.x > 1e-3f;
        EXPECT_EQ(repair_scene(scene_of({mesh}), NormalSource::automatic, context).meshes[0].tangents.empty(),
                  !leaves_a_direction);
        EXPECT_EQ(remarks(context, Remark::warning,
                          "tangents that are parallel to their normals: all of the mesh are computed anew"),
                  leaves_a_direction ? 0u : 1u);
    }
}

TEST(Repair, RoundsSignsOfTangentsAndMakesThemUnit) {
    Context context;
    Mesh mesh = with_normals(std::vector<vec3>(4, {0, 0, 1}));
    mesh.tangents = std::vector<vec4>(4, {3, 0, 0, -0.9999f});
    EXPECT_EQ(repair_scene(scene_of({mesh}), NormalSource::automatic, context).meshes[0].tangents[1],
              (vec4{1, 0, 0, -1}));
    EXPECT_EQ(remarks(context, Remark::changed, "tangents that are not of unit length"), 1u);
}

TEST(Repair, IgnoresTangentsOfAMeshWithoutNormals) {
    Context context;
    Mesh mesh = quad_mesh();
    mesh.tangents = std::vector<vec4>(4, {1, 0, 0, 1});
    EXPECT_TRUE(repair_scene(scene_of({mesh}), NormalSource::automatic, context).meshes[0].tangents.empty());
}

TEST(Repair, SetsCoordinatesThatAreNotFiniteToZeroAndWarnsOfHugeOnes) {
    Context context;
    Mesh mesh = quad_mesh();
    mesh.texcoords.emplace_back(std::vector<vec2>{{0, 0}, {nan_f, 1}, {1, inf_f}, {1e20f, 0}});
    const Scene out = repair_scene(scene_of({mesh}), NormalSource::automatic, context);
    EXPECT_EQ(out.meshes[0].texcoords[0][1], (vec2{0, 0}));
    EXPECT_EQ(out.meshes[0].texcoords[0][2], (vec2{0, 0}));
    EXPECT_EQ(out.meshes[0].texcoords[0][3].x, 1e20f);
    EXPECT_EQ(remarks(context, Remark::changed, "set to 0"), 1u);
    EXPECT_EQ(remarks(context, Remark::warning, "beyond 1e6"), 1u);
}

TEST(Repair, WarnsOfEqualCoordinatesOnlyWhereATextureIs) {
    Mesh mesh = quad_mesh();
    mesh.texcoords.emplace_back(std::vector<vec2>(4, {0.5f, 0.5f}));
    Scene scene = scene_of({mesh});
    Context without;
    repair_scene(scene, NormalSource::automatic, without);
    EXPECT_EQ(all_remarks(without), "");
    test::give_texture(scene, &Material::base_color_texture);
    Context with;
    repair_scene(scene, NormalSource::automatic, with);
    EXPECT_EQ(remarks(with, Remark::warning, "all texture coordinates are the same"), 1u);
}

TEST(Repair, WarnsOfNodesThatFlattenAndRotationsOfNoLength) {
    const auto warnings = [](const Transform& local) {
        Context context;
        Scene scene = scene_of({quad_mesh()});
        scene.nodes[0].local = local;
        prepare_scene(scene, {}, context);
        return all_remarks(context);
    };
    Transform zero_scale, flat, sheared_flat, no_rotation, small, large, tiny, huge, mirrored;
    zero_scale.scale = {0, 0, 0};
    flat.matrix = scaling(dvec3{1, 1, 0});
    sheared_flat.matrix = dmat4{{{1, 2, 3, 0}, {2, 4, 6.0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    no_rotation.rotation = {0, 0, 0, 0};
    small.scale = {1e-17, 1e-17, 1e-17};
    large.scale = {1e17, 1e17, 1e17};
    tiny.scale = {1, 1, 1e-22};
    huge.matrix = scaling(dvec3{1, -1e19, 1});
    mirrored.scale = {-1, 1, 1};
    EXPECT_NE(warnings(zero_scale).find("warning: node 0: the matrix or scale flattens"), std::string::npos)
        << warnings(zero_scale);
    EXPECT_NE(warnings(flat).find("flattens"), std::string::npos);
    EXPECT_NE(warnings(sheared_flat).find("flattens"), std::string::npos);
    EXPECT_NE(warnings(no_rotation).find("the rotation is zero"), std::string::npos);
    EXPECT_NE(warnings(tiny).find("the matrix or scale is so small (less than 1e-18)"), std::string::npos);
    EXPECT_NE(warnings(huge).find("warning: node 0: the matrix or scale is so large (more than 1e18)"),
              std::string::npos);
    EXPECT_EQ(warnings(small), "");
    EXPECT_EQ(warnings(large), "");
    EXPECT_EQ(warnings(mirrored), "");
}

TEST(Repair, CountsTheSameFaultOfManyMeshesInOneRemarkInTheOrderOfMeshes) {
    Context context({.threads = 4});
    std::vector<Mesh> meshes(50, with_normals(std::vector<vec3>(4, {0, 0, 0})));
    repair_scene(scene_of(meshes), NormalSource::automatic, context);
    const auto entries = context.report().entries();
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].count, 50u);
    EXPECT_EQ(entries[0].place, "mesh 0 'quad'");
}

}  // namespace
}  // namespace rakelight
