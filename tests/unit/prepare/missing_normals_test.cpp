// SPDX-License-Identifier: Apache-2.0
// Parts without normals beside parts with: what is made is, at borders, what the author's normals are. On a ball and a tube,
// whose normals are known.
#include "prepare/normals/missing_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include <rakelight/prepare/prepare.h>

#include "prepare/normals/smooth_scene.h"
#include "support/scene_builder.h"
#include "unit/prepare/prepared.h"

namespace rakelight {
namespace {

using namespace test;

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

vec3 unit(vec3 v) { return cast<float>(normalize_or(cast<double>(v), dvec3{})); }

/// The triangles of a mesh on one side of a plane, with the vertices that they use.
template <class Side>
Mesh part_of(const Mesh& whole, const Side& takes) {
    Mesh part;
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::size_t t = 0; t < whole.triangle_count(); ++t) {
        dvec3 middle;
        for (std::size_t k = 0; k < 3; ++k) middle += cast<double>(whole.positions[whole.indices[3 * t + k]]);
        if (!takes(middle)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = whole.indices[3 * t + k];
            const auto [at, is_new] = number.try_emplace(v, std::uint32_t(positions.size()));
            if (is_new) positions.push_back(whole.positions[v]);
            indices.push_back(at->second);
        }
    }
    part.positions = std::move(positions), part.indices = std::move(indices);
    return part;
}

using Place = std::tuple<float, float, float>;
Place place(vec3 p) { return {p.x, p.y, p.z}; }

/// Normals by place; every place of a mesh has one normal.
std::map<Place, vec3> normals_of(const Mesh& mesh) {
    std::map<Place, vec3> normals;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) normals[place(mesh.positions[v])] = mesh.normals[v];
    return normals;
}

double largest_difference(const std::map<Place, vec3>& a, const std::map<Place, vec3>& b) {
    double most = 0;
    for (const auto& [at, n] : a)
        if (const auto found = b.find(at); found != b.end())
            most = std::max(most, length(cast<double>(n) - cast<double>(found->second)));
    return most;
}

struct Cut {
    Mesh whole, with, without;  ///< `with`: exact normals
};

template <class Exact, class Side>
Cut cut(Mesh whole, const Exact& exact, const Side& side) {
    Cut c{whole, part_of(whole, side), part_of(whole, [&](dvec3 p) { return !side(p); })};
    std::vector<vec3> normals;
    for (const vec3 p : c.with.positions) normals.push_back(exact(p));
    c.with.normals = std::move(normals);
    return c;
}

/// A ball cut askew, so that the border runs along edges of all directions.
Cut ball() {
    return cut(ball_mesh(14, 9), unit, [](dvec3 p) { return p.x + 0.3 * p.y > 0.1 * p.z; });
}

/// An open tube about Z of radius 1, cut lengthwise and across.
Cut tube() {
    Mesh mesh;
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    constexpr int around = 15, rows = 6;
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c < around; ++c) {
            const double turn = 2 * pi * c / around;
            positions.push_back({float(std::cos(turn)), float(std::sin(turn)), float(r) * 0.3f});
        }
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < around; ++c) {
            const auto at = [&](int row, int column) { return std::uint32_t(row * around + column % around); };
            for (const std::uint32_t i :
                 {at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r, c), at(r + 1, c + 1), at(r + 1, c)})
                indices.push_back(i);
        }
    mesh.positions = std::move(positions), mesh.indices = std::move(indices);
    return cut(
        std::move(mesh),
        [](vec3 p) {
            return unit({p.x, p.y, 0});
        },
        [](dvec3 p) { return p.x > 0.2 || p.z > 3 * 1.2; });
}

/// As `part` under `place` has it: what the object's matrix makes of it is in the world.
Mesh moved_back(Mesh mesh, const dmat4& place) {
    dmat4 back;
    EXPECT_TRUE(inverse_affine(place, back));
    std::vector<vec3> positions, normals;
    for (const vec3 p : mesh.positions) positions.push_back(cast<float>(transform_point(back, cast<double>(p))));
    const dmat3 turn = cofactor(upper_left(back));
    for (const vec3 n : mesh.normals)
        normals.push_back(
            cast<float>(normalize_or(turn * cast<double>(n) * (determinant(upper_left(back)) < 0 ? -1.0 : 1.0), {})));
    mesh.positions = std::move(positions), mesh.normals = std::move(normals);
    return mesh;
}

/// A sum over faces: what a place gets does not depend on the normals of its neighbors.
PrepareOptions by_angle(NormalSource source) {
    PrepareOptions options = by(source);
    options.weight = CornerWeight::angle;
    return options;
}

class BesideAuthored : public testing::TestWithParam<bool> {
protected:
    Cut c = GetParam() ? ball() : tube();
    /// All normals of the uncut surface, computed.
    std::map<Place, vec3> computed() const {
        return normals_of(prepared(scene_of({c.whole}), by_angle(NormalSource::model)).meshes[0]);
    }
    void expect_right(const Mesh& with, const Mesh& without) const {
        EXPECT_TRUE(with.normals == c.with.normals) << "authored normals are the same block";
        const auto authored = normals_of(with), made = normals_of(without), all = computed();
        std::set<Place> border;
        for (const auto& [at, n] : authored)
            if (made.contains(at)) border.insert(at);
        EXPECT_GT(border.size(), 5u);
        EXPECT_LE(largest_difference(made, authored), 1e-7);
        auto interior = made;
        for (const Place& at : border) interior.erase(at);
        EXPECT_GT(interior.size(), 10u);
        EXPECT_LE(largest_difference(interior, all), 1e-6);
    }
};

TEST_P(BesideAuthored, BorderNormalsAreTheAuthorsOthersThoseOfTheModel) {
    for (const bool with_first : {true, false}) {
        const std::vector<Mesh> meshes = with_first ? std::vector{c.with, c.without} : std::vector{c.without, c.with};
        for (const NormalSource source : {NormalSource::automatic, NormalSource::seams}) {
            const Scene out = prepared(scene_of(meshes), by_angle(source));
            expect_right(out.meshes[with_first ? 0 : 1], out.meshes[with_first ? 1 : 0]);
        }
        Context context;
        SmoothSceneOptions options;
        options.only_missing = true;
        options.attributes.tangents = false;
        const Scene out = smooth_scene(scene_of(meshes), options, context);
        expect_right(out.meshes[with_first ? 0 : 1], out.meshes[with_first ? 1 : 0]);
    }
}

TEST_P(BesideAuthored, PlacementsDoNotMatter) {
    const dmat4 place =
        translation(dvec3{0.25, -0.5, 1}) * dmat4{{{0, 2, 0, 0}, {2, 0, 0, 0}, {0, 0, 2, 0}, {0, 0, 0, 1}}};
    Cut other = c;  // mirrored and twice as large in its own space
    other.with = moved_back(c.with, place);
    std::vector<std::uint32_t> indices(other.with.indices.begin(), other.with.indices.end());
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
    other.with.indices = std::move(indices);
    Scene scene = scene_of({other.with, c.without});
    scene.nodes[0].local.matrix = place;
    const Scene out = prepared(scene, by_angle(NormalSource::automatic));
    EXPECT_TRUE(out.meshes[0].normals == other.with.normals);
    EXPECT_LE(largest_difference(normals_of(out.meshes[1]), normals_of(c.with)), 1e-6);
}

/// Zeros and numbers that are not finite are no normals: what is there instead is as if there were none.
TEST_P(BesideAuthored, NormalsThatAreNoneAreMade) {
    const Mesh without = prepared(scene_of({c.with, c.without}), by_angle(NormalSource::automatic)).meshes[1];
    for (const vec3 none : {vec3{0, 0, 0}, vec3{nan_f, 0, 1}, vec3{-0.0f, 0, 0}, vec3{0, INFINITY, 0}}) {
        Mesh zeros = c.without;
        zeros.normals = std::vector<vec3>(zeros.positions.size(), none);
        EXPECT_TRUE(lacks_normals(zeros));
        EXPECT_TRUE(normal_gaps(zeros).is_all);
        Context context;
        const Scene out = prepare_scene(scene_of({c.with, zeros}), by_angle(NormalSource::automatic), context);
        expect_right(out.meshes[0], out.meshes[1]);
        EXPECT_TRUE(std::equal(without.normals.begin(), without.normals.end(), out.meshes[1].normals.begin()));
        EXPECT_EQ(remarks(context, Remark::warning, "all zero or not finite"), 1u);
    }
}

/// Single ones: the mesh keeps all others to the bit, its tangents, and the offsets of its targets.
TEST_P(BesideAuthored, GapsAreMadeAsTheModelsNormalsAre) {
    Mesh mesh = c.whole;
    std::vector<vec3> normals;
    const auto exact = normals_of(c.with);
    const auto all = computed();
    for (const vec3 p : mesh.positions) normals.push_back(all.at(place(p)));
    const std::vector<vec3> right = normals;
    std::set<std::size_t> gaps;
    for (std::size_t v = 3; v < normals.size(); v += 4)
        normals[v] = v % 8 == 3 ? vec3{} : vec3{nan_f, 0, 0}, gaps.insert(v);
    mesh.normals = normals;
    for (const bool missing_are_flat : {false, true}) {
        Scene scene = scene_of({mesh});
        scene.missing_normals_are_flat = missing_are_flat;
        const Mesh out = prepared(scene, by_angle(NormalSource::automatic)).meshes[0];
        ASSERT_EQ(out.normals.size(), right.size()) << "nothing is split on a smooth surface";
        for (std::size_t v = 0; v < right.size(); ++v) {
            if (gaps.contains(v))
                EXPECT_LE(length(cast<double>(out.normals[v]) - cast<double>(right[v])), 1e-6);
            else
                EXPECT_EQ(out.normals[v], right[v]);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, BesideAuthored, testing::Values(true, false),
                         [](const testing::TestParamInfo<bool>& of) { return of.param ? "ball" : "tube"; });

TEST(MissingNormals, UsedVerticesOfDrawnMeshesAreCountedOnce) {
    Scene scene;
    Mesh mesh = test::square_mesh();
    mesh.normals = {};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2};
    test::add_object(scene, mesh);
    EXPECT_EQ(count_missing_normals(scene), 3u);
    scene.nodes.push_back(scene.nodes[0]);
    EXPECT_EQ(count_missing_normals(scene), 3u) << "one mesh, twice";
    scene.meshes[0].normals = std::vector<vec3>{{0, 0, 1}, {}, {nan_f, 0, 1}, {}};
    EXPECT_EQ(count_missing_normals(scene), 2u) << "the fourth is not used";
}

/// Where the author's surface ends in a hard edge, nothing of it is taken.
TEST(MissingNormals, AcrossACreaseNothingIsTaken) {
    Mesh floor = quad_mesh(), wall = quad_mesh();
    floor.normals = std::vector<vec3>(4, {0, 0, 1});
    wall.positions = std::vector<vec3>{{1, 0, 0}, {1, 0, -1}, {1, 1, -1}, {1, 1, 0}};
    const Scene out = prepared(scene_of({floor, wall}));
    for (const vec3 n : out.meshes[1].normals) EXPECT_EQ(n, (vec3{1, 0, 0}));
}

/// An author's normals that point inwards are not taken for a surface that faces outwards.
TEST(MissingNormals, TheOtherSideIsNotTaken) {
    Mesh a = quad_mesh(), b = quad_mesh();
    a.normals = std::vector<vec3>(4, {0, 0, -1});
    b.positions = std::vector<vec3>{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
    const Scene out = prepared(scene_of({a, b}));
    for (const vec3 n : out.meshes[1].normals) EXPECT_EQ(n, (vec3{0, 0, 1}));
}

TEST(MissingNormals, ZerosOfVerticesWithoutTrianglesAreNoGaps) {
    Mesh mesh = quad_mesh();
    std::vector<vec3> positions(mesh.positions.begin(), mesh.positions.end());
    positions.push_back({5, 5, 5});
    mesh.positions = std::move(positions);
    mesh.normals = std::vector<vec3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 0}};
    EXPECT_FALSE(lacks_normals(mesh));
    mesh.normals = std::vector<vec3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 0}, {0, 0, 1}, {0, 0, 0}};
    EXPECT_EQ(normal_gaps(mesh).count, 1u);
    EXPECT_FALSE(normal_gaps(mesh).is_all);
}

/// Gaps at a hard edge: the vertex is split, and what belongs to it goes along.
TEST(MissingNormals, GapsKeepTangentsAndTargets) {
    Mesh mesh = folded_mesh(pi / 2);
    std::vector<vec3> normals{{0, 0, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}};
    mesh.normals = normals;
    mesh.tangents = std::vector<vec4>(6, {0, 1, 0, 1});
    mesh.targets = {{"t", std::vector<vec3>(6, {0, 0, 0}), std::vector<vec3>(6, {0.5f, 0, 0}), {}}};
    mesh.texcoords.emplace_back(std::vector<vec2>(6, {0.5f, 0.25f}));
    Context context;
    SmoothSceneOptions options;
    options.only_missing = true;
    options.attributes.tangents = false;
    const Scene out = smooth_scene(scene_of({mesh}), options, context);
    const Mesh& m = out.meshes[0];
    ASSERT_EQ(m.positions.size(), 8u) << "both vertices of the edge are split";
    for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(m.tangents[v], (vec4{0, 1, 0, 1}));
    for (std::size_t t = 0; t < 4; ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_LE(length(m.normals[m.indices[3 * t + k]] - (t < 2 ? vec3{0, 0, 1} : vec3{1, 0, 0})), 1e-6f);
    ASSERT_EQ(m.targets[0].normals.size(), 8u);
    for (const std::size_t v : {0u, 3u, 4u, 5u}) EXPECT_EQ(m.targets[0].normals[v], (vec3{0.5f, 0, 0}));
}

/// Both parts rise by a morph target; the made normals follow the author's at the border, in every pose.
TEST(MissingNormals, FollowTheAuthorsInEveryPose) {
    Mesh a = quad_mesh(), b = quad_mesh();
    b.positions = std::vector<vec3>{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
    a.normals = std::vector<vec3>(4, {0, 0, 1});
    const vec3 slope = unit({-1, 0, 2});
    a.targets = {{"up",
                  std::vector<vec3>{{0, 0, 0}, {0, 0, 0.5f}, {0, 0, 0.5f}, {0, 0, 0}},
                  std::vector<vec3>(4, slope - vec3{0, 0, 1}),
                  {}}};
    b.targets = {{"up", std::vector<vec3>{{0, 0, 0.5f}, {0, 0, 0.5f}, {0, 0, 0.5f}, {0, 0, 0.5f}}, {}, {}}};
    Scene scene = scene_of({a, b});
    for (Node& node : scene.nodes) node.morph_weights = {1};
    const Scene out = prepared(scene);
    for (const std::size_t v : {0u, 3u}) EXPECT_LE(length(out.meshes[1].normals[v] - slope), 1e-6f);
    for (const std::size_t v : {1u, 2u}) EXPECT_LE(length(out.meshes[1].normals[v] - vec3{0, 0, 1}), 1e-6f);
    for (const vec3 n : out.meshes[0].normals) EXPECT_LE(length(n - slope), 1e-6f);
}

}  // namespace
}  // namespace rakelight
