// SPDX-License-Identifier: Apache-2.0
// Whose normals count.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>

#include "prepare/prepare_scene.h"
#include "prepare/shapes/teapot.h"
#include "unit/prepare/meshes.h"
#include "unit/prepare/prepared.h"

namespace rakelight {
namespace {

using test::by;
using test::folded_mesh;
using test::prepared;
using test::quad_mesh;
using test::scene_of;

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

TEST(PrepareScene, GivesTheSameBitsForAnyNumberOfThreads) {
    const Scene teapot = make_teapot(12);
    Context one({.threads = 1}), four({.threads = 4});
    const Scene a = prepare_scene(teapot, {}, one), b = prepare_scene(teapot, {}, four);
    for (std::size_t m = 0; m < a.meshes.size(); ++m)
        EXPECT_TRUE(std::equal(a.meshes[m].normals.begin(), a.meshes[m].normals.end(), b.meshes[m].normals.begin()));
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

}  // namespace
}  // namespace rakelight
