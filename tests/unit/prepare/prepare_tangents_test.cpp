// SPDX-License-Identifier: Apache-2.0
// Which meshes get tangents and bitangents.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>

#include "prepare/prepare_scene.h"
#include "support/thrown_error.h"
#include "unit/prepare/meshes.h"
#include "unit/prepare/prepared.h"

namespace rakelight {
namespace {

using test::by;
using test::folded_mesh;
using test::prepared;
using test::quad_mesh;
using test::remarks;
using test::scene_of;
using test::textured_quad;

void expect_tangents(const Mesh& mesh, vec4 tangent) {
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    for (const vec4& t : mesh.tangents) {
        EXPECT_NEAR(t.x, tangent.x, 1e-6);
        EXPECT_NEAR(t.y, tangent.y, 1e-6);
        EXPECT_NEAR(t.z, tangent.z, 1e-6);
        EXPECT_EQ(t.w, tangent.w);
    }
}

TEST(PrepareTangents, MakesTangentsForTheNormalTexturesOwnCoordinates) {
    for (const bool file_normals : {true, false}) {
        Mesh mesh = textured_quad();
        if (file_normals) mesh.normals = std::vector<vec3>(4, {0, 0, 1});
        Scene scene = scene_of({mesh});
        TextureUse& use = test::give_texture(scene, &Material::normal_texture);
        expect_tangents(prepared(scene).meshes[0], {1, 0, 0, 1});
        use.texcoord_set = 1;
        expect_tangents(prepared(scene).meshes[0], {0, -1, 0, 1});
        if (file_normals) {
            EXPECT_TRUE(prepared(scene).meshes[0].normals == mesh.normals) << "normals stay shared";
        }
    }
}

TEST(PrepareTangents, MakesTangentsForAHeightTextureToo) {
    Scene scene = scene_of({textured_quad()});
    test::give_texture(scene, &Material::height_texture);
    expect_tangents(prepared(scene).meshes[0], {1, 0, 0, 1});
}

TEST(PrepareTangents, KeepsTheFilesTangentsWithItsNormalsOnly) {
    Mesh mesh = textured_quad();
    mesh.normals = std::vector<vec3>(4, {0, 0, 1});
    mesh.tangents = std::vector<vec4>(4, {0, 1, 0, -1});
    Scene scene = scene_of({mesh});
    test::give_texture(scene, &Material::normal_texture);
    EXPECT_TRUE(prepared(scene).meshes[0].tangents == mesh.tangents);
    expect_tangents(prepared(scene, by(NormalSource::model)).meshes[0], {1, 0, 0, 1});
}

/// A strip of two quads, bent, whose charts meet at 30 degrees: averaged over position they differ from MikkTSpace's.
Mesh turned_charts(bool with_normals) {
    Mesh mesh;
    mesh.positions =
        std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    const float c = 0.8660254f, s = 0.5f;
    mesh.texcoords = {std::vector<vec2>{{0, 1}, {1, 1}, {1, 0}, {0, 0}, {-s, c}, {c - s, s + c}, {c, s}, {0, 0}}};
    if (with_normals) mesh.normals = std::vector<vec3>(8, {0, 0, 1});
    return mesh;
}

TEST(PrepareTangents, TangentsAreTheFilesElseMikktspaceForKeptNormalsElseAveraged) {
    Scene scene = scene_of({turned_charts(true)});
    test::give_texture(scene, &Material::normal_texture);
    const auto turn = [](const Mesh& m) { return std::fabs(m.tangents[1].y - m.tangents[4].y); };
    EXPECT_GT(turn(prepared(scene).meshes[0]), 0.4) << "MikkTSpace keeps charts apart";
    EXPECT_LT(turn(prepared(scene, by(NormalSource::model)).meshes[0]), 1e-6) << "averaged over the place";
    PrepareOptions options;
    options.tangents = TangentMode::averaged;
    scene.meshes[0].normals = std::vector<vec3>(8, {0, 0, 1});
    EXPECT_LT(turn(prepared(scene, options).meshes[0]), 1e-6);
    options = by(NormalSource::model);
    options.tangents = TangentMode::mikktspace;
    EXPECT_GT(turn(prepared(scene, options).meshes[0]), 0.4);
    options.tangents = TangentMode::published;
    EXPECT_LT(turn(prepared(scene, options).meshes[0]), 1e-6);
    options.normals = NormalSource::flat;
    EXPECT_GT(turn(prepared(scene, options).meshes[0]), 0.4) << "of their own faces, as the normals are";
    scene.meshes[0].tangents = std::vector<vec4>(8, {0, 1, 0, -1});
    EXPECT_EQ(prepared(scene).meshes[0].tangents[0], (vec4{0, 1, 0, -1})) << "the file's";
    options = {};
    options.tangents = TangentMode::mikktspace;
    EXPECT_NEAR(prepared(scene, options).meshes[0].tangents[0].x, 1, 1e-6)
        << "said explicitly, the file's do not count";
}

TEST(PrepareTangents, PublishedTangentsRunOverObjectsWithKeptNormals) {
    Mesh left = turned_charts(true), right = left;
    left.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    right.indices = std::vector<std::uint32_t>{4, 5, 6, 4, 6, 7};
    Scene scene = scene_of({left, right});
    test::give_texture(scene, &Material::normal_texture);
    PrepareOptions options;
    options.tangents = TangentMode::published;
    const Scene out = prepared(scene, options);
    EXPECT_EQ(out.meshes[0].tangents[1], out.meshes[1].tangents[4]);
    EXPECT_NE(out.meshes[0].tangents[1], out.meshes[0].tangents[0]);
}

TEST(PrepareTangents, WarnsOfMapsThatPublishedTangentsInvert) {
    Mesh left = textured_quad(), right = left;
    std::vector<vec2> mirrored(right.texcoords[0].begin(), right.texcoords[0].end());
    for (vec2& q : mirrored) q.x = 1 - q.x;
    right.texcoords = {mirrored};
    right.name = "right";
    Scene scene = scene_of({left, right});
    scene.nodes[1].local.translation = {9, 0, 0};
    test::give_texture(scene, &Material::normal_texture);
    for (const NormalSource source : {NormalSource::model, NormalSource::object, NormalSource::flat})
        for (const bool handedness : {true, false}) {
            PrepareOptions options = by(source);
            options.tangents = handedness ? TangentMode::published : TangentMode::published_no_handedness;
            Context context;
            const Scene out = prepare_scene(scene, options, context);
            std::size_t warnings = 0;
            for (const ReportEntry& entry : context.report().entries())
                warnings += entry.remark == Remark::warning && entry.place == "mesh 1 'right'" &&
                            entry.message.find(
                                "on 2 of 4 triangles, where bumps look like dents; "
                                "'tangents' published-no-handedness") != std::string::npos;
            EXPECT_EQ(warnings, handedness ? 1u : 0u);
            EXPECT_EQ(out.meshes[1].tangents[0], handedness ? (vec4{1, 0, 0, 1}) : (vec4{-1, 0, 0, -1}));
        }
}

TEST(PrepareTangents, ComputesTangentsWhereTheFilesAreBroken) {
    Mesh mesh = textured_quad();
    mesh.normals = std::vector<vec3>(4, {0, 0, 1});
    mesh.tangents = std::vector<vec4>(4, {0, 1, 0, 0});
    Scene scene = scene_of({mesh});
    test::give_texture(scene, &Material::normal_texture);
    expect_tangents(prepared(scene).meshes[0], {1, 0, 0, 1});
}

TEST(PrepareTangents, GivesFiniteTangentsAndAWarningWhereTheTextureHasNoArea) {
    Mesh mesh = quad_mesh();
    mesh.texcoords.emplace_back(std::vector<vec2>{{0, 0}, {1, 0}, {2, 0}, {3, 0}});
    Scene scene = scene_of({mesh});
    test::give_texture(scene, &Material::normal_texture);
    Context context;
    const Scene out = prepare_scene(scene, {}, context);
    EXPECT_EQ(remarks(context, Remark::warning, "no triangle has an area"), 1u);
    for (const vec4& t : out.meshes[0].tangents) {
        EXPECT_NEAR(length(t.xyz()), 1, 1e-6);
        EXPECT_EQ(std::fabs(t.w), 1);
    }
}

TEST(PrepareTangents, SplitsMirroredVerticesInAllArrays) {
    // Two squares whose texture is mirrored at the common edge: the edge's vertices need both signs.
    Mesh mesh = folded_mesh(0);
    mesh.normals = std::vector<vec3>(6, {0, 0, 1});
    mesh.texcoords.emplace_back(std::vector<vec2>{{0, 1}, {1, 1}, {1, 0}, {0, 0}, {0, 1}, {0, 0}});
    mesh.colors = std::vector<vec4>{{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}, {3, 0, 0, 1}, {4, 0, 0, 1}, {5, 0, 0, 1}};
    Scene scene = scene_of({mesh});
    test::give_texture(scene, &Material::normal_texture);
    const Mesh after = prepared(scene).meshes[0];
    EXPECT_EQ(after.positions.size(), 8u);
    EXPECT_EQ(after.colors.size(), 8u);
    EXPECT_EQ(after.texcoords[0].size(), 8u);
    EXPECT_EQ(after.tangents.size(), 8u);
    for (std::size_t c = 0; c < 6; ++c) EXPECT_GT(after.tangents[after.indices[c]].w, 0);
    for (std::size_t c = 6; c < 12; ++c) EXPECT_LT(after.tangents[after.indices[c]].w, 0);
    for (std::size_t c = 0; c < 12; ++c) EXPECT_EQ(after.colors[after.indices[c]], mesh.colors[mesh.indices[c]]);
}

TEST(PrepareTangents, MakesProjectedCoordinatesAndTheirTangents) {
    Scene scene = scene_of({test::cube_mesh()});
    test::give_texture(scene, &Material::normal_texture);
    PrepareOptions options = by(NormalSource::flat);
    options.uv = UvProjection::box;
    const Mesh after = prepared(scene, options).meshes[0];
    EXPECT_GE(after.positions.size(), 24u);
    ASSERT_EQ(after.tangents.size(), after.positions.size());
    for (const vec4& t : after.tangents) EXPECT_EQ(t.w, 1) << "no side of the box is mirrored";
}

TEST(PrepareTangents, SaysHowFarTangentsWereFromPerpendicularWhenAsked) {
    Mesh sheet = test::ball_mesh(7, 5);
    std::vector<vec2> uv;
    for (const vec3& p : sheet.positions) uv.push_back({p.x + 0.5f * p.z, p.y * p.y - p.z});
    sheet.texcoords = {Block<vec2>(std::move(uv))};
    Scene scene = scene_of({sheet});
    test::give_texture(scene, &Material::normal_texture);
    PrepareOptions options = by(NormalSource::model);
    options.measure_orthogonality = true;
    Context asked, quiet;
    const Mesh made = prepare_scene(scene, options, asked).meshes[0];
    EXPECT_EQ(remarks(asked, Remark::note, "from perpendicular to the normals"), 1u) << test::all_remarks(asked);
    EXPECT_EQ(remarks(asked, Remark::note, "at most 0.00 degrees"), 0u) << "told as it was before";
    for (std::size_t v = 0; v < made.positions.size(); ++v)
        EXPECT_NEAR(dot(made.normals[v], made.tangents[v].xyz()), 0, 1e-6);
    options.orthogonalize = Orthogonalize::off;
    float skew = 0;
    const Mesh raw = prepare_scene(scene, options, asked).meshes[0];
    for (std::size_t v = 0; v < raw.positions.size(); ++v)
        skew = std::max(skew, std::fabs(dot(raw.normals[v], raw.tangents[v].xyz())));
    EXPECT_GT(skew, 0.01f);
    options.measure_orthogonality = false;
    prepare_scene(scene, options, quiet);
    EXPECT_EQ(remarks(quiet, Remark::note, "from perpendicular"), 0u);
}

TEST(PrepareTangents, TangentsOfTheFileAreMeasuredAsTheyAre) {
    Mesh mesh = quad_mesh();
    mesh.normals = std::vector<vec3>(4, {0, 0, 1});
    mesh.tangents = std::vector<vec4>{{1, 0, 0, 1}, {1, 0, 0, 1}, {0.8f, 0, 0.6f, 1}, {1, 0, 0, 1}};
    mesh.texcoords = {Block<vec2>(std::vector<vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}})};
    Scene scene = scene_of({mesh});
    test::give_texture(scene, &Material::normal_texture);
    PrepareOptions options;
    options.measure_orthogonality = true;
    Context context;
    prepare_scene(scene, options, context);
    EXPECT_EQ(remarks(context, Remark::note, "at most 36.87 degrees (mean 9.22)"), 1u) << test::all_remarks(context);
}

/// u leans on v: along constant u the surface goes up and to the right.
Mesh sheared_quad() {
    Mesh mesh = quad_mesh();
    std::vector<vec2> uv;
    for (const vec3& p : mesh.positions) uv.push_back({p.x - 0.5f * p.y, 1 - p.y});
    mesh.texcoords.emplace_back(uv);
    return mesh;
}

TEST(PrepareTangents, PublishedBitangentsAreKeptWhereAskedFor) {
    PrepareOptions options = by(NormalSource::model);
    options.all_tangents = true;
    options.tangents = TangentMode::published;
    EXPECT_TRUE(prepared(scene_of({sheared_quad()}), options).meshes[0].bitangents.empty());
    options.bitangents = true;
    const Mesh mesh = prepared(scene_of({sheared_quad()}), options).meshes[0];
    ASSERT_EQ(mesh.bitangents.size(), mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        EXPECT_NEAR(mesh.tangents[v].x, 1, 1e-6);
        EXPECT_NEAR(mesh.bitangents[v].x, 0.5 / std::sqrt(1.25), 1e-6) << "not perpendicular to the tangent";
        EXPECT_NEAR(mesh.bitangents[v].y, 1 / std::sqrt(1.25), 1e-6) << "towards decreasing v";
        EXPECT_EQ(mesh.tangents[v].w, 1);
    }
    options.tangents = TangentMode::averaged;
    Context context;
    EXPECT_EQ(test::error_of([&] { prepare_scene(scene_of({sheared_quad()}), options, context); }).code(),
              ErrorCode::usage);
}

TEST(PrepareTangents, MeshesThatMoveHaveNoBitangentsOfTheirOwn) {
    Mesh mesh = sheared_quad();
    mesh.targets = {{"", std::vector<vec3>(mesh.positions.size(), vec3{0, 0, 0.1f}), {}, {}}};
    PrepareOptions options = by(NormalSource::model);
    options.all_tangents = options.bitangents = true;
    options.tangents = TangentMode::published;
    EXPECT_TRUE(prepared(scene_of({mesh}), options).meshes[0].bitangents.empty());
}

}  // namespace
}  // namespace rakelight
