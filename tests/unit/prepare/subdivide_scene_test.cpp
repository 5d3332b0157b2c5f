// SPDX-License-Identifier: Apache-2.0
#include "prepare/refine/subdivide_scene.h"

#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include "math/linear.h"
#include "prepare/prepare_scene.h"
#include "prepare/shapes/primitives.h"
#include "scene/placement.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

const std::vector<std::array<std::uint32_t, 4>> cube_quads = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                                              {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};

Mesh mesh_of_quads(const std::vector<vec3>& positions, const std::vector<std::array<std::uint32_t, 4>>& quads) {
    Mesh mesh;
    std::vector<std::uint32_t> indices, polygons;
    for (const auto& [a, b, c, d] : quads) {
        polygons.insert(polygons.end(), 2, std::uint32_t(indices.size() / 3));
        indices.insert(indices.end(), {a, b, c, a, c, d});
    }
    mesh.positions = positions;
    mesh.indices = std::move(indices);
    mesh.polygons = std::move(polygons);
    return mesh;
}

std::vector<vec3> cube_corners() {
    std::vector<vec3> corners;
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f})
            for (const float z : {-1.0f, 1.0f}) corners.push_back({x, y, z});
    return corners;
}

Scene scene_of(std::vector<Mesh> meshes) {
    Scene scene;
    for (std::uint32_t i = 0; i < meshes.size(); ++i) {
        scene.nodes.emplace_back().meshes = {i};
        scene.meshes.push_back(std::move(meshes[i]));
    }
    return scene;
}

Scene cube() { return scene_of({mesh_of_quads(cube_corners(), cube_quads)}); }

/// The cube's sides, each an object with corners of its own.
Scene cube_of_six() {
    std::vector<Mesh> sides;
    for (const auto& quad : cube_quads) {
        std::vector<vec3> corners;
        for (const std::uint32_t v : quad) corners.push_back(cube_corners()[v]);
        sides.push_back(mesh_of_quads(corners, {{0, 1, 2, 3}}));
    }
    return scene_of(std::move(sides));
}

using Point = std::tuple<float, float, float>;
Point key(vec3 p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }

bool is_closed(const Scene& scene) {
    std::map<std::pair<Point, Point>, int> edges;
    for (const Mesh& mesh : scene.meshes)
        for (std::size_t i = 0; i < mesh.indices.size(); ++i)
            ++edges[{key(mesh.positions[mesh.indices[i]]),
                     key(mesh.positions[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]])}];
    return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
        return edges.contains({e.first.second, e.first.first});
    });
}

/// All normals at each place, of all meshes.
std::map<Point, std::set<Point>> normals_at(const Scene& scene) {
    std::map<Point, std::set<Point>> out;
    for (const Mesh& mesh : scene.meshes)
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            out[key(mesh.positions[v])].insert(key(mesh.normals[v]));
    return out;
}

const std::string* remark_with(const Context& context, const std::string& words) {
    for (const auto& entry : const_cast<Context&>(context).report().entries())
        if (entry.message.find(words) != std::string::npos) return &entry.message;
    return nullptr;
}

TEST(SubdivideScene, ACubeOfQuadsBecomesCatmullClarksAndOneOfTrianglesLoops) {
    Context context;
    Scene quads = cube();
    const Scene out = subdivide_scene(quads, {.level = 3}, context);
    EXPECT_NO_THROW(validate(out));
    EXPECT_EQ(out.meshes[0].triangle_count(), 6u * 64 * 2);
    EXPECT_EQ(out.meshes[0].positions.size(), 6u * 64 + 2);
    EXPECT_TRUE(normals_at(out).contains(key({0.5f, 0.5f, 0.5f})));  // Halstead et al. 1993
    ASSERT_TRUE(remark_with(context, "Catmull-Clark"));
    quads.meshes[0].polygons = {};
    Context other;
    const Scene triangles = subdivide_scene(quads, {.level = 3}, other);
    EXPECT_EQ(triangles.meshes[0].triangle_count(), 12u * 64);
    EXPECT_TRUE(is_closed(triangles));
    ASSERT_TRUE(remark_with(other, "(Loop)"));
    // Whoever asks for the other scheme gets it
    EXPECT_EQ(subdivide_scene(quads, {.level = 3, .scheme = SubdivisionScheme::catmull_clark}, other)
                  .meshes[0]
                  .triangle_count(),
              12u * 3 * 16 * 2);
    EXPECT_EQ(
        subdivide_scene(cube(), {.level = 3, .scheme = SubdivisionScheme::loop}, other).meshes[0].triangle_count(),
        12u * 64);
}

TEST(SubdivideScene, SixObjectsAreTheSurfaceOfOneToTheBit) {
    Context context;
    const Scene whole = subdivide_scene(cube(), {.level = 4}, context);
    const Scene parts = subdivide_scene(cube_of_six(), {.level = 4}, context);
    ASSERT_EQ(parts.meshes.size(), 6u);
    EXPECT_TRUE(is_closed(parts));
    EXPECT_EQ(normals_at(parts), normals_at(whole));
}

TEST(SubdivideScene, ASphereCutIntoSixteenObjectsIsTheWholeOneToTheLastDigitOfFloats) {
    Context context;
    const Scene whole = subdivide_scene(make_primitive({.tolerance = 0.05}), {.level = 3}, context);
    const Scene parts = subdivide_scene(make_primitive({.tolerance = 0.05, .objects = 16}), {.level = 3}, context);
    ASSERT_EQ(parts.nodes.size(), 16u);
    EXPECT_TRUE(is_closed(whole));
    EXPECT_TRUE(is_closed(parts));
    EXPECT_EQ(triangle_count(whole), triangle_count(parts));
    for (const auto& [place, normals] : normals_at(parts)) ASSERT_EQ(normals.size(), 1u);  // no seam
    // The same points, of which a few may differ by the rounding of a sum in another order
    std::map<std::array<long, 3>, vec3> cells;
    const auto cell = [](vec3 p) {
        return std::array{std::lround(p.x * 1e5f), std::lround(p.y * 1e5f), std::lround(p.z * 1e5f)};
    };
    for (const vec3 p : whole.meshes[0].positions) cells[cell(p)] = p;
    std::size_t all = 0, same = 0;
    for (const Mesh& mesh : parts.meshes)
        for (const vec3 p : mesh.positions) {
            ++all;
            const auto found = cells.find(cell(p));
            if (found == cells.end()) continue;  // on a cell's border
            EXPECT_LE(length(found->second - p), 1.2e-7f);
            same += found->second == p;
        }
    EXPECT_GT(double(same), 0.99 * double(all));
}

TEST(SubdivideScene, ObjectsUnderOtherMatricesMeetWhereTheyMetBefore) {
    Context context;
    Scene parts = cube_of_six();
    for (std::size_t i = 0; i < 6; ++i) {  // each side in a space of its own, one of them mirrored
        Transform& t = parts.nodes[i].local;
        t.scale = {i == 3 ? -2.0 : 2.0, 0.5, 1};
        t.translation = {double(i), -3, 0.25};
        std::vector<vec3> moved;
        for (const vec3 p : parts.meshes[i].positions)
            moved.push_back({(p.x - float(i)) / float(t.scale.x), (p.y + 3) * 2, p.z - 0.25f});
        parts.meshes[i].positions = std::move(moved);
        if (i != 3) continue;
        std::vector<std::uint32_t> turned(parts.meshes[i].indices.begin(), parts.meshes[i].indices.end());
        std::reverse(turned.begin(), turned.end());
        parts.meshes[i].indices = std::move(turned);
    }
    const Scene out = subdivide_scene(parts, {.level = 3}, context);
    const auto want = normals_at(subdivide_scene(cube(), {.level = 3}, context));
    const std::vector<dmat4> world = world_matrices(out);
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t v = 0; v < out.meshes[i].positions.size(); ++v) {
            const dvec3 p = transform_point(world[i], cast<double>(out.meshes[i].positions[v]));
            const dvec3 n = normalize_or(
                cofactor(upper_left(world[i])) * cast<double>(out.meshes[i].normals[v]) * (i == 3 ? -1.0 : 1.0),
                dvec3{});
            double nearest = 9, turn = 9;
            for (const auto& [place, normals] : want) {
                const double d = length(p - dvec3{std::get<0>(place), std::get<1>(place), std::get<2>(place)});
                if (d >= nearest) continue;
                nearest = d;
                const auto [x, y, z] = *normals.begin();
                turn = length(n - dvec3{x, y, z});
            }
            EXPECT_LT(nearest, 1e-6);
            EXPECT_LT(turn, 1e-6);
        }
}

TEST(SubdivideScene, PlacementsThatTouchNothingGoOnSharingTheirMesh) {
    Context context;
    Scene scene = cube();
    for (const double x : {5.0, 10.0}) {
        scene.nodes.push_back(scene.nodes[0]);
        scene.nodes.back().local.translation = {x, 0, 0};
        scene.nodes.back().local.scale = {1, x == 10 ? -1.0 : 1.0, 1};
    }
    const Scene apart = subdivide_scene(scene, {.level = 2}, context);
    EXPECT_EQ(apart.meshes.size(), 1u);
    scene.nodes[1].local.translation = {2, 0, 0};  // now it shares a side with the first
    const Scene joined = subdivide_scene(scene, {.level = 2}, context);
    EXPECT_EQ(joined.meshes.size(), 3u);
    std::set<std::uint32_t> used;
    for (const Node& node : joined.nodes) used.insert(node.meshes[0]);
    EXPECT_EQ(used.size(), 3u);
}

TEST(SubdivideScene, CreasesKeepACubeACubeAndSofterOnesRoundIt) {
    Context context;
    double before = 0;
    for (const double sharpness : {0.0, 1.0, 2.0, 3.0, 10.0}) {
        const Scene out =
            subdivide_scene(cube(), {.level = 4, .crease_angle_rad = radians(60), .sharpness = sharpness}, context);
        double farthest = 0;
        for (const vec3 p : out.meshes[0].positions) farthest = std::max(farthest, double(length(p)));
        EXPECT_GT(farthest, before);
        before = farthest;
        EXPECT_TRUE(is_closed(out));
    }
    EXPECT_NEAR(before, std::sqrt(3.0), 1e-6);
    const Scene sharp = subdivide_scene(cube(), {.level = 2, .crease_angle_rad = radians(60)}, context);
    EXPECT_EQ(normals_at(sharp)[key({1, 1, 1})].size(), 3u);
    EXPECT_EQ(normals_at(sharp)[key({1, 1, 0})].size(), 2u);
}

TEST(SubdivideScene, TextureCoordinatesRunOverTheBordersOfObjects) {
    Context context;
    const auto strip = [](float x) {  // unit quads along x, u = x / 2
        Mesh mesh = mesh_of_quads({{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0}}, {{0, 1, 2, 3}});
        mesh.texcoords.push_back(std::vector<vec2>{{x / 2, 0}, {x / 2 + 0.5f, 0}, {x / 2 + 0.5f, 1}, {x / 2, 1}});
        return mesh;
    };
    for (const SubdivisionUv uv : {SubdivisionUv::boundaries, SubdivisionUv::smooth, SubdivisionUv::linear}) {
        const Scene out = subdivide_scene(scene_of({strip(0), strip(1)}), {.level = 3, .uv = uv}, context);
        std::map<Point, std::set<std::pair<float, float>>> at;
        for (const Mesh& mesh : out.meshes)
            for (std::size_t v = 0; v < mesh.positions.size(); ++v)
                at[key(mesh.positions[v])].insert({mesh.texcoords[0][v].x, mesh.texcoords[0][v].y});
        for (const auto& [place, values] : at) EXPECT_EQ(values.size(), 1u);
        // smooth coordinates follow the points, so that u stays x / 2
        for (const auto& [place, values] : at)
            if (uv == SubdivisionUv::smooth) {
                EXPECT_NEAR(values.begin()->first, std::get<0>(place) / 2, 1e-7);
            }
    }
}

TEST(SubdivideScene, ColorsAndSecondTextureCoordinatesComeAlong) {
    Context context;
    Scene scene = cube();
    std::vector<vec4> colors;
    std::vector<vec2> uv;
    for (const vec3 p : cube_corners()) {
        colors.push_back({p.x, 0.5f, 0.25f, 1});
        uv.push_back({p.y, p.z});
    }
    scene.meshes[0].colors = colors;
    scene.meshes[0].texcoords = {{}, uv};
    const Scene out = subdivide_scene(scene, {.level = 2, .uv = SubdivisionUv::smooth}, context);
    const Mesh& mesh = out.meshes[0];
    EXPECT_NO_THROW(validate(out));
    EXPECT_TRUE(mesh.texcoords[0].empty());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        EXPECT_NEAR(mesh.texcoords[1][v].x, mesh.positions[v].y, 1e-7);
        EXPECT_EQ(mesh.colors[v].y, 0.5f);
        EXPECT_LE(std::abs(mesh.colors[v].x), 1);
        EXPECT_EQ(mesh.colors[v].x > 0, mesh.positions[v].x > 0);
    }
}

TEST(SubdivideScene, LevelsEndWhereEdgesAreShortEnoughInTheWorld) {
    Context context;
    Scene scene = cube();  // edges of 2 m
    const auto triangles = [&](double edge) {
        return subdivide_scene(scene, {.level = 6, .edge = edge}, context).meshes[0].triangle_count();
    };
    EXPECT_EQ(triangles(1), 12u * 4);
    EXPECT_EQ(triangles(0.9), 12u * 16);
    EXPECT_EQ(triangles(1e-6), 12u * 4096);
    EXPECT_EQ(triangles(100), 12u * 4);  // one level at least
    scene.nodes[0].local.scale = {0.25, 0.25, 0.25};
    EXPECT_EQ(triangles(0.25), 12u * 4);
    EXPECT_EQ(triangles(0.24), 12u * 16);
}

TEST(SubdivideScene, AMeshsOwnWordCountsBeforeTheScenes) {
    Context context;
    Scene scene = cube();
    scene.nodes.push_back(scene.nodes[0]);
    scene.nodes[1].meshes = {1};
    scene.nodes[1].local.translation = {9, 0, 0};
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].subdivision = Subdivision{};  // stays a cube
    EXPECT_FALSE(wants_subdivision(scene, {}));
    const Scene out = subdivide_scene(scene, {.level = 2}, context);
    EXPECT_EQ(out.meshes[0].triangle_count(), 12u * 16);
    EXPECT_EQ(out.meshes[1].positions.identity(), scene.meshes[1].positions.identity());
    EXPECT_FALSE(wants_subdivision(out, {.level = 2}));  // not twice
    scene.meshes[1].subdivision->level = 1;
    EXPECT_TRUE(wants_subdivision(scene, {}));
    EXPECT_EQ(subdivide_scene(scene, {}, context).meshes[1].triangle_count(), 12u * 4);
}

TEST(SubdivideScene, AllPlacementsAreCountedBeforeTheyAreWelded) {
    Scene scene = scene_of({test::ball_mesh(64, 32)});
    Context enough({.max_memory = 16 << 20}), too_small({.max_memory = 16 << 20});
    EXPECT_NO_THROW(subdivide_scene(scene, {.level = 1}, enough));
    scene.nodes.resize(1000, scene.nodes[0]);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) scene.nodes[i].local.translation = {3.0 * double(i), 0, 0};
    try {
        subdivide_scene(scene, {.level = 1}, too_small);  // all have the same surface, but that is known too late
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("where the vertices of all placements meet"), std::string::npos)
            << error.what();
    }
}

TEST(SubdivideScene, WhatNeedsTooMuchMemoryIsOneErrorBeforeItIsMade) {
    Context context({.max_memory = 10'000'000});
    EXPECT_NO_THROW(subdivide_scene(cube(), {.level = 4}, context));
    try {
        subdivide_scene(cube(), {.level = 8}, context);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_file);
        EXPECT_NE(std::string(error.what()).find("subdivision into 786432 triangles"), std::string::npos)
            << error.what();
    }
    EXPECT_THROW(subdivide_scene(cube(), {.level = 9}, context), Error);
    EXPECT_THROW(subdivide_scene(cube(), {.level = 1, .sharpness = 11}, context), Error);
}

TEST(SubdivideScene, TrianglesWithCornersAtOnePlaceAreLeftOutWithARemark) {
    Context context;
    Scene scene = cube();
    std::vector<std::uint32_t> indices(scene.meshes[0].indices.begin(), scene.meshes[0].indices.end());
    indices.insert(indices.end(), {0, 0, 1, 2, 2, 2});
    scene.meshes[0].indices = std::move(indices);
    std::vector<std::uint32_t> polygons(scene.meshes[0].polygons.begin(), scene.meshes[0].polygons.end());
    polygons.insert(polygons.end(), {100, 101});
    scene.meshes[0].polygons = std::move(polygons);
    const Scene out = subdivide_scene(scene, {.level = 2}, context);
    EXPECT_EQ(out.meshes[0].triangle_count(), 12u * 16);
    EXPECT_TRUE(remark_with(context, "2 triangles with corners at one place"));
    scene.meshes[0].indices = std::vector<std::uint32_t>{0, 0, 1};
    scene.meshes[0].polygons = {};
    EXPECT_EQ(subdivide_scene(scene, {.level = 2}, context).meshes[0].triangle_count(), 0u);
}

TEST(SubdivideScene, PartedEdgesAndLostTargetsAreSaid) {
    Context context;
    Scene scene = cube_of_six();
    std::vector<std::uint32_t> turned(scene.meshes[2].indices.begin(), scene.meshes[2].indices.end());
    std::reverse(turned.begin(), turned.end());
    scene.meshes[2].indices = std::move(turned);
    scene.meshes[0].targets = {{"open", std::vector<vec3>(4), {}, {}}};
    const Scene out = subdivide_scene(scene, {.level = 2}, context);
    EXPECT_TRUE(out.meshes[0].targets.empty());
    EXPECT_TRUE(remark_with(context, "4 edges have more than two faces"));
    EXPECT_TRUE(remark_with(context, "morph targets of 1 subdivided mesh"));
}

TEST(SubdivideScene, ThreadsDoNotChangeABit) {
    Context one({.threads = 1}), many({.threads = 8});
    const Scene scene = make_primitive({.shape = PrimitiveShape::torus, .tolerance = 0.05, .objects = 7});
    const Scene a = subdivide_scene(scene, {.level = 3}, one), b = subdivide_scene(scene, {.level = 3}, many);
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        const auto same = [](const auto& x, const auto& y) {
            return std::equal(x.begin(), x.end(), y.begin(), y.end());
        };
        EXPECT_TRUE(same(a.meshes[i].positions, b.meshes[i].positions));
        EXPECT_TRUE(same(a.meshes[i].normals, b.meshes[i].normals));
        EXPECT_TRUE(same(a.meshes[i].texcoords[0], b.meshes[i].texcoords[0]));
        EXPECT_TRUE(same(a.meshes[i].indices, b.meshes[i].indices));
    }
}

// --- in the way of prepare

TEST(SubdivideScene, PrepareKeepsTheLimitsNormalsUnlessFlatOnesAreAskedFor) {
    Context context;
    PrepareOptions options;
    options.subdivision.level = 2;
    for (const NormalSource source :
         {NormalSource::automatic, NormalSource::file, NormalSource::object, NormalSource::model}) {
        options.normals = source;
        Scene glTF = cube_of_six();
        glTF.missing_normals_are_flat = true;
        for (const auto& [place, normals] : normals_at(prepare_scene(glTF, options, context)))
            EXPECT_EQ(normals.size(), 1u);
    }
    options.normals = NormalSource::flat;
    std::size_t most = 0;
    for (const auto& [place, normals] : normals_at(prepare_scene(cube(), options, context)))
        most = std::max(most, normals.size());
    EXPECT_GT(most, 3u);
}

TEST(SubdivideScene, FrontsThatTurnClockwiseGiveTheSameSurface) {
    Context context;
    Scene scene = cube();
    std::vector<std::uint32_t> turned(scene.meshes[0].indices.begin(), scene.meshes[0].indices.end());
    std::reverse(turned.begin(), turned.end());
    scene.meshes[0].indices = std::move(turned);
    PrepareOptions options;
    options.subdivision.level = 2;
    options.clockwise_fronts = true;
    const Scene out = prepare_scene(scene, options, context);
    EXPECT_EQ(out.meshes[0].triangle_count(), 12u * 16);  // still quads
    for (std::size_t v = 0; v < out.meshes[0].positions.size(); ++v)
        EXPECT_GT(dot(out.meshes[0].positions[v], out.meshes[0].normals[v]), 0.4f);
}

TEST(SubdivideScene, DisplacementGoesAlongTheLimitsNormals) {
    Context context;
    Scene scene = make_primitive({.tolerance = 0.02, .objects = 4});
    auto image = std::make_shared<EncodedImage>();
    image->decode = [](const EncodedImage&, Context&) {
        Pixels p{.width = 1, .height = 1, .channels = 1, .component = Component::f32, .is_linear = true};
        const float one = 1;
        p.bytes.resize(4);
        std::memcpy(p.row(0), &one, 4);
        return p;
    };
    scene.textures.push_back({"heights", image, {}});
    scene.materials[0].height_texture.texture = 0;
    scene.materials[0].bump = Bump::displacement;
    scene.materials[0].relief = Relief{.depth = 0.1f, .bias = 1};  // all of it above the surface
    PrepareOptions options;
    options.subdivision.level = 2;
    options.displacement.edge = 9;  // nothing is cut
    const Scene out = prepare_scene(scene, options, context);
    EXPECT_TRUE(is_closed(out));
    const Scene limit = subdivide_scene(scene, options.subdivision, context);
    for (std::size_t i = 0; i < limit.meshes.size(); ++i) {
        for (std::size_t v = 0; v < limit.meshes[i].positions.size(); ++v) {
            const vec3 way = out.meshes[i].positions[v] - limit.meshes[i].positions[v];
            EXPECT_GT(length(way), 0.02f);
            EXPECT_GT(dot(normalize_or(way, {0, 0, 0}), limit.meshes[i].normals[v]), 0.99999f);
        }
    }
}

}  // namespace
}  // namespace rakelight
