// SPDX-License-Identifier: Apache-2.0
// Whose normals count, and who gets tangents.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>

#include <rakelight/error.h>

#include "prepare/prepare.h"
#include "scene/scene_tools.h"
#include "support/thrown_error.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

using test::folded_mesh;
using test::quad_mesh;
using test::remarks;
using test::scene_of;
using test::textured_quad;

Scene prepared(const Scene& scene, PrepareOptions options = {}) {
    Context context;
    Scene out = prepare_scene(scene, options, context);
    validate(out);
    for (const Node& node : out.nodes)
        for (const std::uint32_t mesh : node.meshes)
            test::expect_unit(out.meshes[mesh].normals, out.meshes[mesh].positions.size());
    return out;
}

PrepareOptions by(NormalSource source) {
    PrepareOptions options;
    options.normals = source;
    return options;
}

/// One side of a fold in a mesh of its own, so that two objects meet at x = 1.
std::vector<Mesh> two_halves(double angle_rad) {
    Mesh left = folded_mesh(angle_rad), right = left;
    left.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    right.indices = std::vector<std::uint32_t>{1, 4, 5, 1, 5, 2};
    return {left, right};
}

TEST(PrepareScene, SharesEverythingWhenNothingNeedsDoing) {
    Mesh mesh = quad_mesh();
    mesh.normals = std::vector<vec3>(4, {0, 0, 1});
    mesh.texcoords.emplace_back(std::vector<vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const Mesh after = prepared(scene_of({mesh})).meshes[0];
    EXPECT_TRUE(after.positions == mesh.positions && after.indices == mesh.indices && after.normals == mesh.normals);
    EXPECT_TRUE(after.texcoords[0] == mesh.texcoords[0]);
    EXPECT_TRUE(after.tangents.empty()) << "nothing uses them";
}

TEST(PrepareScene, AutomaticKeepsTheFilesNormalsEvenIfTheyAreOdd) {
    Mesh mesh = quad_mesh();
    mesh.normals = std::vector<vec3>(4, {1, 0, 0});
    EXPECT_EQ(prepared(scene_of({mesh})).meshes[0].normals[0], (vec3{1, 0, 0}));
}

TEST(PrepareScene, AutomaticIsFlatForFormatsThatSaySo) {
    Scene scene = scene_of({folded_mesh(radians(30))});
    scene.missing_normals_are_flat = true;
    const Mesh after = prepared(scene).meshes[0];
    EXPECT_GE(after.positions.size(), 8u) << "the two vertices of the fold are split";
    for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(after.normals[after.indices[c]], (vec3{0, 0, 1}));
    for (std::size_t c = 6; c < 12; ++c) EXPECT_NEAR(after.normals[after.indices[c]].x, std::sin(radians(30)), 1e-6);
}

TEST(PrepareScene, ANoteSaysWhyAFormatsMeshesAreFlat) {
    Scene scene = scene_of({folded_mesh(radians(30))});
    scene.missing_normals_are_flat = true;
    for (const NormalSource source : {NormalSource::automatic, NormalSource::flat, NormalSource::model}) {
        Context context;
        PrepareOptions options;
        options.normals = source;
        prepare_scene(scene, options, context);
        const auto entries = context.report().entries();
        ASSERT_EQ(entries.size(), source == NormalSource::automatic ? 1u : 0u);
        if (!entries.empty()) {
            EXPECT_EQ(entries[0].remark, Remark::note);
            EXPECT_NE(entries[0].message.find("'normals' model"), std::string::npos);
        }
    }
}

TEST(PrepareScene, AutomaticSmoothsOverTheModelUpToTheCreaseAngle) {
    const Mesh soft = prepared(scene_of({folded_mesh(radians(30))})).meshes[0];
    EXPECT_EQ(soft.positions.size(), 6u);
    EXPECT_GT(soft.normals[1].x, 0.2f);
    EXPECT_EQ(prepared(scene_of({folded_mesh(radians(80))})).meshes[0].positions.size(), 8u);
    PrepareOptions wide;
    wide.crease_angle_rad = radians(90);
    EXPECT_EQ(prepared(scene_of({folded_mesh(radians(80))}), wide).meshes[0].positions.size(), 6u);
}

TEST(PrepareScene, ModelHasNoSeamBetweenObjectsAndObjectHasOne) {
    const Scene scene = scene_of(two_halves(radians(30)));
    const Scene model = prepared(scene, by(NormalSource::model));
    EXPECT_EQ(model.meshes[0].normals[1], model.meshes[1].normals[1]);
    const Scene object = prepared(scene, by(NormalSource::object));
    EXPECT_EQ(object.meshes[0].normals[1], (vec3{0, 0, 1}));
    EXPECT_NE(object.meshes[1].normals[1], (vec3{0, 0, 1}));
}

TEST(PrepareScene, ObjectSmoothsOverTheMeshesOfOneNode) {
    Scene scene = scene_of(two_halves(radians(30)));
    scene.nodes.resize(1);
    scene.nodes[0].meshes = {0, 1};
    const Scene object = prepared(scene, by(NormalSource::object));
    EXPECT_EQ(object.meshes[0].normals[1], object.meshes[1].normals[1]);
    EXPECT_GT(object.meshes[0].normals[1].x, 0.2f);
}

TEST(PrepareScene, SmoothingGroupsRuleInsideAnObject) {
    Mesh sharp = folded_mesh(radians(30)), soft = folded_mesh(radians(80));
    sharp.smoothing_kind = soft.smoothing_kind = SmoothingKind::numbers;
    sharp.smoothing = std::vector<std::uint32_t>{1, 1, 2, 2};
    soft.smoothing = std::vector<std::uint32_t>{5, 5, 5, 5};
    EXPECT_EQ(prepared(scene_of({sharp})).meshes[0].positions.size(), 8u);
    EXPECT_EQ(prepared(scene_of({soft})).meshes[0].positions.size(), 6u) << "a group joins over any angle";
    EXPECT_EQ(prepared(scene_of({sharp}), by(NormalSource::model)).meshes[0].positions.size(), 6u)
        << "an explicit wish overrules groups";
}

TEST(PrepareScene, MasksJoinWhereTheyShareABit) {
    Mesh mesh = folded_mesh(radians(80));
    mesh.smoothing_kind = SmoothingKind::masks;
    mesh.smoothing = std::vector<std::uint32_t>{3, 3, 6, 6};
    EXPECT_EQ(prepared(scene_of({mesh})).meshes[0].positions.size(), 6u);
    mesh.smoothing = std::vector<std::uint32_t>{1, 1, 6, 6};
    EXPECT_EQ(prepared(scene_of({mesh})).meshes[0].positions.size(), 8u);
}

TEST(PrepareScene, FileAndFlatDoWhatTheySay) {
    Mesh with = quad_mesh(), without = folded_mesh(radians(30));
    with.normals = std::vector<vec3>(4, {1, 0, 0});
    const Scene scene = scene_of({with, without});
    const Scene file = prepared(scene, by(NormalSource::file));
    EXPECT_EQ(file.meshes[0].normals[0], (vec3{1, 0, 0}));
    EXPECT_GE(file.meshes[1].positions.size(), 8u) << "flat where the file has none";
    const Scene flat = prepared(scene, by(NormalSource::flat));
    EXPECT_EQ(flat.meshes[0].normals[0], (vec3{0, 0, 1}));
    EXPECT_GE(flat.meshes[1].positions.size(), 8u);
}

TEST(PrepareScene, RefusesImpossibleCreaseAngles) {
    Context context;
    for (const double angle : {-0.1, 3.2, std::numeric_limits<double>::quiet_NaN()}) {
        PrepareOptions options;
        options.crease_angle_rad = angle;
        EXPECT_THROW(prepare_scene(scene_of({quad_mesh()}), options, context), Error);
    }
}

TEST(PrepareScene, ChecksTheSceneAtItsDoor) {
    Context context;
    Mesh mesh = quad_mesh();
    mesh.indices = std::vector<std::uint32_t>{0, 1, 99};
    EXPECT_THROW(prepare_scene(scene_of({mesh}), {}, context), Error);
}

// --- tangents --------------------------------------------------------------------------------------------------------------

void expect_tangents(const Mesh& mesh, vec4 tangent) {
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    for (const vec4& t : mesh.tangents) {
        EXPECT_NEAR(t.x, tangent.x, 1e-6);
        EXPECT_NEAR(t.y, tangent.y, 1e-6);
        EXPECT_NEAR(t.z, tangent.z, 1e-6);
        EXPECT_EQ(t.w, tangent.w);
    }
}

TEST(PrepareScene, MakesTangentsForTheNormalTexturesOwnCoordinates) {
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

TEST(PrepareScene, MakesTangentsForAHeightTextureToo) {
    Scene scene = scene_of({textured_quad()});
    test::give_texture(scene, &Material::height_texture);
    expect_tangents(prepared(scene).meshes[0], {1, 0, 0, 1});
}

TEST(PrepareScene, KeepsTheFilesTangentsWithItsNormalsOnly) {
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

TEST(PrepareScene, TangentsAreTheFilesElseMikktspaceForKeptNormalsElseAveraged) {
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

TEST(PrepareScene, PublishedTangentsRunOverObjectsWithKeptNormals) {
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

TEST(PrepareScene, WarnsOfMapsThatPublishedTangentsInvert) {
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

TEST(PrepareScene, ComputesTangentsWhereTheFilesAreBroken) {
    Mesh mesh = textured_quad();
    mesh.normals = std::vector<vec3>(4, {0, 0, 1});
    mesh.tangents = std::vector<vec4>(4, {0, 1, 0, 0});
    Scene scene = scene_of({mesh});
    test::give_texture(scene, &Material::normal_texture);
    expect_tangents(prepared(scene).meshes[0], {1, 0, 0, 1});
}

TEST(PrepareScene, GivesFiniteTangentsAndAWarningWhereTheTextureHasNoArea) {
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

TEST(PrepareScene, SplitsMirroredVerticesInAllArrays) {
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

TEST(PrepareScene, GivesTheSameBitsForAnyNumberOfThreads) {
    const Scene teapot = make_teapot(12);
    Context one({.threads = 1}), four({.threads = 4});
    const Scene a = prepare_scene(teapot, {}, one), b = prepare_scene(teapot, {}, four);
    for (std::size_t m = 0; m < a.meshes.size(); ++m)
        EXPECT_TRUE(std::equal(a.meshes[m].normals.begin(), a.meshes[m].normals.end(), b.meshes[m].normals.begin()));
}

TEST(PrepareScene, MakesProjectedCoordinatesAndTheirTangents) {
    Scene scene = scene_of({test::cube_mesh()});
    test::give_texture(scene, &Material::normal_texture);
    PrepareOptions options = by(NormalSource::flat);
    options.uv = UvProjection::box;
    const Mesh after = prepared(scene, options).meshes[0];
    EXPECT_GE(after.positions.size(), 24u);
    ASSERT_EQ(after.tangents.size(), after.positions.size());
    for (const vec4& t : after.tangents) EXPECT_EQ(t.w, 1) << "no side of the box is mirrored";
}

TEST(PrepareScene, SaysHowFarTangentsWereFromPerpendicularWhenAsked) {
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

TEST(PrepareScene, TangentsOfTheFileAreMeasuredAsTheyAre) {
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

TEST(PrepareScene, OfAModelWhoseFrontsTurnClockwiseIsWhatItIsOfTheSameModelTurnedRound) {
    Mesh ball = test::ball_mesh(7, 5);
    std::vector<vec2> uv;
    for (const vec3& p : ball.positions) uv.push_back({p.x + 0.5f * p.z, p.y * p.y - p.z});
    ball.texcoords = {Block<vec2>(std::move(uv))};
    Mesh clockwise = ball;
    std::vector<std::uint32_t> corners(ball.indices.begin(), ball.indices.end());
    for (std::size_t t = 0; t < corners.size(); t += 3) std::swap(corners[t + 1], corners[t + 2]);
    clockwise.indices = std::move(corners);
    for (const bool has_normals : {false, true})
        for (const NormalSource source : {NormalSource::automatic, NormalSource::flat, NormalSource::model})
            for (const TangentMode mode : {TangentMode::averaged, TangentMode::mikktspace, TangentMode::published}) {
                if (has_normals)
                    ball.normals = clockwise.normals = std::vector<vec3>(ball.positions.begin(), ball.positions.end());
                Scene scenes[2] = {scene_of({ball}), scene_of({clockwise})};
                PrepareOptions options = by(source);
                options.tangents = mode;
                Mesh made[2];
                for (int i = 0; i < 2; ++i) {
                    test::give_texture(scenes[i], &Material::normal_texture);
                    options.clockwise_fronts = i == 1;
                    made[i] = prepared(scenes[i], options).meshes[0];
                }
                EXPECT_TRUE(std::ranges::equal(made[0].normals, made[1].normals));
                EXPECT_TRUE(std::ranges::equal(made[0].tangents, made[1].tangents));
                EXPECT_EQ(made[0].tangents.size(), made[0].positions.size());
                ASSERT_EQ(made[0].indices.size(), made[1].indices.size());
                for (std::size_t t = 0; t < made[0].indices.size(); t += 3)
                    for (std::size_t k = 0; k < 3; ++k)
                        EXPECT_EQ(made[0].indices[t + k], made[1].indices[t + (3 - k) % 3]);
            }
}

TEST(PrepareScene, SharesEverythingWhenNothingNeedsDoingWhateverTurnItsFrontsHave) {
    Mesh mesh = quad_mesh();
    mesh.normals = std::vector<vec3>(4, {0, 0, 1});
    PrepareOptions options;
    options.clockwise_fronts = true;
    const Scene after = prepared(scene_of({mesh, mesh}), options);
    for (const Mesh& m : after.meshes) EXPECT_TRUE(m.indices.identity() == mesh.indices.identity());
}

TEST(PrepareScene, EachStageIsRefusedBeforeItMakesWhatTheBudgetHasNoRoomFor) {
    Scene scene = scene_of({test::ball_mesh(32, 32)});
    scene.nodes.resize(8, scene.nodes[0]);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) scene.nodes[i].local.translation = {1.5 * double(i), 0, 0};
    PrepareOptions all;
    all.uv = UvProjection::box;
    all.subdivision.level = 1;
    all.all_tangents = all.clockwise_fronts = true;
    std::set<std::string> stages;
    for (std::uint64_t limit = 1 << 20; !stages.contains("all") && limit < 1u << 30; limit += limit / 8) {
        Context context({.max_memory = limit});
        try {
            const Scene out = prepare_scene(scene, all, context);
            EXPECT_GT(context.memory().charged(), 8 * 4000u * (12 + 12 + 16 + 8)) << "arrays of the result";
            stages.insert("all");
        } catch (const Error& error) {
            stages.insert(error.reason().substr(0, error.reason().find(" needs ")));
        }
        EXPECT_EQ(context.memory().charged(), 0u) << limit;
    }
    EXPECT_TRUE(stages.contains("all"));
    EXPECT_GE(stages.size(), 4u);
    EXPECT_FALSE(stages.contains("the prepared scene")) << "refused when it was made already";
}

/// [bytes] The limit, to a sixty-fourth, under which the scene can be prepared.
std::uint64_t least_memory(const Scene& scene, const PrepareOptions& options) {
    for (std::uint64_t limit = 1 << 20;; limit += limit / 64) {
        Context context({.max_memory = limit});
        try {
            prepare_scene(scene, options, context);
            return limit;
        } catch (const Error&) {
        }
    }
}

TEST(PrepareScene, AStageCountsWhatTheStagesBeforeHaveMade) {
    Scene scene = scene_of({test::ball_mesh(32, 32)});
    scene.nodes.resize(16, scene.nodes[0]);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) scene.nodes[i].local.translation = {1.5 * double(i), 0, 0};
    Context made;
    const Scene projected = project_texcoords(scene, UvProjection::box, made);  // paid there, not where it is prepared
    const std::uint64_t arrays = made.memory().charged();
    PrepareOptions smooth = by(NormalSource::model), both = smooth;
    both.uv = UvProjection::box;
    const std::uint64_t alone = least_memory(projected, smooth);
    EXPECT_GT(arrays, alone / 8) << "it makes a difference";
    EXPECT_GT(least_memory(scene, both), alone + arrays - alone / 16);
}

TEST(PrepareScene, FlatNormalsOfAllMeshesTogetherStayWithinTheMemoryBudget) {
    Scene scene = scene_of({test::ball_mesh(32, 32), test::ball_mesh(32, 32), test::ball_mesh(32, 32)});
    const std::size_t vertices = scene.meshes[0].positions.size(), corners = scene.meshes[0].indices.size();
    for (Mesh& mesh : scene.meshes) mesh.texcoords.assign(100, std::vector<vec2>(vertices));
    // A flat face has vertices of its own: a position, a normal and 100 texture coordinates.
    const std::uint64_t bytes = corners * (24 + 800);
    Context enough({.max_memory = 4 * bytes}), for_two({.max_memory = 2 * bytes + bytes / 2});
    EXPECT_EQ(prepare_scene(scene, by(NormalSource::flat), enough).meshes[2].positions.size(), corners);
    EXPECT_THROW(prepare_scene(scene, by(NormalSource::flat), for_two), Error);
    EXPECT_NO_THROW(prepare_scene(scene, by(NormalSource::model), for_two));  // no vertex splits
}

/// u leans on v: along constant u the surface goes up and to the right.
Mesh sheared_quad() {
    Mesh mesh = quad_mesh();
    std::vector<vec2> uv;
    for (const vec3& p : mesh.positions) uv.push_back({p.x - 0.5f * p.y, 1 - p.y});
    mesh.texcoords.emplace_back(uv);
    return mesh;
}

TEST(PrepareScene, PublishedBitangentsAreKeptWhereAskedFor) {
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

TEST(PrepareScene, MeshesThatMoveHaveNoBitangentsOfTheirOwn) {
    Mesh mesh = sheared_quad();
    mesh.targets.resize(1);
    mesh.targets[0].positions = std::vector<vec3>(mesh.positions.size(), vec3{0, 0, 0.1f});
    PrepareOptions options = by(NormalSource::model);
    options.all_tangents = options.bitangents = true;
    options.tangents = TangentMode::published;
    EXPECT_TRUE(prepared(scene_of({mesh}), options).meshes[0].bitangents.empty());
}

}  // namespace
}  // namespace rakelight
