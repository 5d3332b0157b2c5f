// SPDX-License-Identifier: Apache-2.0
#include "prepare/refine/displace.h"

#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <tuple>

#include "math/linear.h"
#include "prepare/shapes/primitives.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

/// A height map by formula of u, v in 0..1.
ImageHandle heights(const std::function<double(double, double)>& height, int width = 64, int rows = 0) {
    auto image = std::make_shared<EncodedImage>();
    image->name = "heights";
    image->decode = [height, width, size = rows > 0 ? rows : width](const EncodedImage&, Context&) {
        Pixels p{.width = width, .height = size, .channels = 1, .component = Component::f32, .is_linear = true};
        p.bytes.resize(p.row_bytes() * std::size_t(size));
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < width; ++x) {
                const float h = float(height((x + 0.5) / width, (y + 0.5) / size));
                std::memcpy(p.row(y) + std::size_t(x) * sizeof h, &h, sizeof h);
            }
        return p;
    };
    return image;
}

Scene with_heights(Scene scene, ImageHandle image, const Relief& relief) {
    scene.textures.push_back({"heights", std::move(image), {}});
    for (Material& m : scene.materials) {
        m.height_texture.texture = std::uint32_t(scene.textures.size() - 1);
        m.bump = Bump::displacement;
        m.relief = relief;
    }
    return scene;
}

using Point = std::tuple<float, float, float>;
bool is_closed(const Scene& scene) {
    const auto key = [](vec3 p) { return Point(p.x + 0.0f, p.y + 0.0f, p.z + 0.0f); };
    std::map<std::pair<Point, Point>, int> edges;
    for (const Mesh& mesh : scene.meshes)
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k)
                ++edges[{key(mesh.positions[mesh.indices[i + k]]), key(mesh.positions[mesh.indices[i + (k + 1) % 3]])}];
    for (const auto& [edge, count] : edges)
        if (!edges.contains({edge.second, edge.first})) return false;
    return true;
}

TEST(Displace, APlaneFollowsItsHeightMap) {
    Context context;
    const auto wave = [](double u, double v) { return 0.5 + 0.5 * std::sin(2 * pi * u) * std::sin(2 * pi * v); };
    const Scene plane =
        with_heights(make_primitive({.shape = PrimitiveShape::plane}), heights(wave), {.depth = 0.1f, .bias = 0.25f});
    ASSERT_TRUE(wants_displacement(plane, {}));
    const Scene out = displace_scene(plane, {.edge = 0.02}, context);
    EXPECT_NO_THROW(validate(out));
    EXPECT_TRUE(out.meshes[0].normals.empty());
    ASSERT_GT(out.meshes[0].positions.size(), 5000u);
    for (std::size_t v = 0; v < out.meshes[0].positions.size(); ++v) {
        const vec3 p = out.meshes[0].positions[v];
        const vec2 uv = out.meshes[0].texcoords[0][v];
        EXPECT_NEAR(p.x, 2 * uv.x - 1, 1e-6);
        // a tenth of the texture's width, which is 2 m here; a quarter of it above the plane
        if (uv.x < 0.02f || uv.x > 0.98f || uv.y < 0.02f || uv.y > 0.98f) continue;
        EXPECT_NEAR(p.y, 0.2 * (wave(double(uv.x), double(uv.y)) - 0.75), 2e-3);
    }
}

TEST(Displace, DepthMapsGoTheOtherWay) {
    Context context;
    const auto even = heights([](double, double) { return 0.25; });
    const auto y_of = [&](const Relief& relief) {
        return displace_scene(with_heights(make_primitive({.shape = PrimitiveShape::plane}), even, relief), {.edge = 1},
                              context)
            .meshes[0]
            .positions[0]
            .y;
    };
    EXPECT_NEAR(y_of({.depth = 0.1f}), 0.2 * (0.25 - 1), 1e-6);
    EXPECT_NEAR(y_of({.depth = 0.1f, .holds_depth = true}), 0.2 * -0.25, 1e-6);
    EXPECT_NEAR(y_of({.depth = 0.1f, .bias = 1}), 0.2 * 0.25, 1e-6);
}

TEST(Displace, ASphereOfSixteenObjectsStaysClosedWhateverItsHeightsAndSeams) {
    Context context;
    const auto rough = [](double u, double v) {
        return 0.5 + 0.3 * std::sin(37 * u + 11 * v) + 0.2 * u;
    };  // not periodic: a seam in u
    Scene sphere = make_primitive({.tolerance = 0.02, .objects = 16});
    ASSERT_TRUE(is_closed(sphere));
    sphere = with_heights(std::move(sphere), heights(rough), {.depth = 0.03f});
    const Scene out = displace_scene(sphere, {.edge = 0.06}, context);
    EXPECT_TRUE(is_closed(out));
    EXPECT_EQ(out.nodes.size(), 16u);
    double nearest = 2, farthest = 0;
    for (const Mesh& mesh : out.meshes)
        for (const vec3 p : mesh.positions)
            nearest = std::min(nearest, double(length(p))), farthest = std::max(farthest, double(length(p)));
    EXPECT_LT(nearest, 0.97);  // the outline changes
    EXPECT_GT(farthest - nearest, 0.03);
}

TEST(Displace, ObjectsPlacedByOtherMatricesMeetWhereTheyMetBefore) {
    Context context;
    Scene planes = make_primitive({.shape = PrimitiveShape::plane});
    planes.nodes.push_back(planes.nodes[0]);  // an instance, moved by a plane's width and mirrored
    planes.nodes[1].local.translation = {2, 0, 0};
    planes.nodes[1].local.scale = {1, 1, -1};
    planes =
        with_heights(std::move(planes), heights([](double u, double v) { return 0.5 + 0.5 * std::sin(9 * u + 5 * v); }),
                     {.depth = 0.05f});
    const Scene out = displace_scene(planes, {.edge = 0.1}, context);
    ASSERT_EQ(out.meshes.size(), 2u);
    std::map<int, float> border;  // by z in a grid finer than the vertices
    for (const vec3 p : out.meshes[0].positions)
        if (std::abs(p.x - 1) < 1e-5f) border[int(std::lround(p.z * 1000))] = p.y;
    ASSERT_GT(border.size(), 15u);
    std::size_t met = 0;
    for (const vec3 p : out.meshes[1].positions) {
        if (std::abs(p.x + 1) > 1e-5f) continue;
        const auto other = border.find(int(std::lround(-p.z * 1000)));
        ASSERT_NE(other, border.end());
        EXPECT_NEAR(other->second, p.y, 1e-6);
        ++met;
    }
    EXPECT_EQ(met, border.size());
}

TEST(Displace, WhatIsNotDisplacedHoldsTheBorderAndIsCutAlongIt) {
    Context context;
    Scene sphere = make_primitive({.tolerance = 0.02, .objects = 2});
    sphere = with_heights(std::move(sphere), heights([](double, double) { return 0.0; }), {.depth = 0.05f});
    sphere.materials.push_back(Material{.name = "smooth"});
    sphere.meshes[1].material = 1;
    const Scene out = displace_scene(sphere, {.edge = 0.06}, context);
    EXPECT_TRUE(is_closed(out));
    for (const vec3 p : out.meshes[1].positions) ASSERT_GT(length(p), 0.97f);  // chords of the border, nothing deeper
    EXPECT_EQ(out.meshes[1].normals.empty(), out.meshes[1].positions.size() != sphere.meshes[1].positions.size());
}

TEST(Displace, PlacementsThatComeOutEqualGoOnSharingTheirMesh) {
    Context context;
    Scene planes = make_primitive({.shape = PrimitiveShape::plane});
    planes.nodes.push_back(planes.nodes[0]);
    planes.nodes[1].local.translation = {0, 8, 0};
    planes = with_heights(std::move(planes), heights([](double u, double) { return u; }), {.depth = 0.05f});
    EXPECT_EQ(displace_scene(planes, {.edge = 0.25}, context).meshes.size(), 1u);
}

TEST(Displace, NothingChangesWithoutAMapOrTheWish) {
    const Scene sphere = make_primitive({});
    EXPECT_FALSE(wants_displacement(sphere, {.is_on = true}));
    Scene with_map = with_heights(sphere, heights([](double, double) { return 1.0; }), {});
    with_map.materials[0].bump = Bump::automatic;
    EXPECT_FALSE(wants_displacement(with_map, {}));
    EXPECT_TRUE(wants_displacement(with_map, {.is_on = true}));
    with_map.materials[0].bump = Bump::normal;
    EXPECT_FALSE(wants_displacement(with_map, {.is_on = true}));
}

TEST(Displace, TheLimitOfTrianglesIsKeptAndSaid) {
    Context context;
    const Scene plane =
        with_heights(make_primitive({.shape = PrimitiveShape::plane}), heights([](double u, double) { return u; }), {});
    const Scene out = displace_scene(plane, {.edge = 1e-4, .max_triangles = 5000}, context);
    EXPECT_LE(out.meshes[0].triangle_count(), 5000u);
    ASSERT_EQ(context.report().entries().size(), 1u);
    const std::string made = std::to_string(out.meshes[0].triangle_count());
    EXPECT_NE(context.report().entries()[0].message.find("stops at " + made + " of 5000 triangles"), std::string::npos);
}

TEST(Displace, TrianglesOfWhatIsNotDisplacedDoNotUseUpTheLimit) {
    Context context;
    Scene planes = make_primitive({.shape = PrimitiveShape::plane, .divisions = 60});
    planes = with_heights(std::move(planes), heights([](double u, double) { return u; }), {});
    const Scene alone = make_primitive({.shape = PrimitiveShape::plane});
    planes.meshes.push_back(alone.meshes[0]);
    planes.nodes.push_back(planes.nodes[0]);
    planes.nodes[1].meshes = {1};
    planes.nodes[1].local.translation = {0, 5, 0};
    planes.materials.push_back(planes.materials[0]);
    planes.materials[0].bump = Bump::none;
    planes.meshes[1].material = 1;
    ASSERT_GT(planes.meshes[0].triangle_count(), 5000u);
    const Scene out = displace_scene(planes, {.edge = 0.1, .max_triangles = 5000}, context);
    EXPECT_GT(out.meshes[1].triangle_count(), 1000u);
    EXPECT_TRUE(context.report().entries().empty());
}

/// Of the white map's plane over the surface, for a depth of 1 that lies above it wholly.
double height_of_white(Scene plane, const TextureTransform& transform, ImageHandle white) {
    Context context;
    plane = with_heights(std::move(plane), std::move(white), {.depth = 1, .bias = 1});
    for (Material& m : plane.materials) m.height_texture.transform = transform;
    return double(displace_scene(plane, {.edge = 1}, context).meshes[0].positions[0].y);
}

TEST(Displace, ADepthIsOneWidthOfTheTextureAsItsTransformHasIt) {
    const Scene plane = make_primitive({.shape = PrimitiveShape::plane});  // 2 m
    const auto white = [] { return heights([](double, double) { return 1.0; }); };
    EXPECT_NEAR(height_of_white(plane, {}, white()), 2, 1e-6);
    EXPECT_NEAR(height_of_white(plane, {.scale = {30, 30}}, white()), 2.0 / 30, 1e-6);
    EXPECT_NEAR(height_of_white(plane, {.scale = {-0.5f, 0.5f}, .rotation_rad = 0.7f}, white()), 4, 1e-6);
    // as parallax: texels are square, so a texture of twice the height is mapped to 1 m by 2 m
    EXPECT_NEAR(height_of_white(plane, {.scale = {2, 1}}, heights([](double, double) { return 1.0; }, 4, 8)), 1, 1e-6);
}

/// A strip of columns, 1 m wide, u = x^2 / 2: the texture gets narrower along it.
Mesh strip(int from, int to) {
    std::vector<vec3> positions, normals;
    std::vector<vec2> uv;
    std::vector<std::uint32_t> indices;
    for (int i = from; i <= to; ++i)
        for (int j = 0; j < 2; ++j) {
            const float x = float(i) * 0.1f;
            positions.push_back({x, 0, float(j)});
            normals.push_back({0, 1, 0});
            uv.push_back({x * x / 2, float(j)});
        }
    for (std::uint32_t i = 0; i < std::uint32_t(to - from); ++i)
        for (const std::uint32_t k : {0u, 1u, 3u, 0u, 3u, 2u}) indices.push_back(2 * i + k);
    Mesh mesh{.name = "strip"};
    mesh.positions = std::move(positions);
    mesh.normals = std::move(normals);
    mesh.texcoords.emplace_back(std::move(uv));
    mesh.indices = std::move(indices);
    mesh.material = 0;
    return mesh;
}

Scene strips(const std::vector<int>& cuts) {
    Scene scene;
    scene.materials.emplace_back();
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        scene.meshes.push_back(strip(cuts[k], cuts[k + 1]));
        scene.nodes.emplace_back().meshes = {std::uint32_t(k)};
    }
    return scene;
}

/// Heights of all vertices by their numbers of x and z in a fine grid.
std::map<std::pair<long, long>, float> surface_of(const std::vector<int>& cuts, const ImageHandle& image) {
    Context context;
    const Scene scene = with_heights(strips(cuts), image, {.depth = 0.2f, .bias = 1});
    std::map<std::pair<long, long>, float> out;
    for (const Mesh& mesh : displace_scene(scene, {.edge = 0.05}, context).meshes)
        for (const vec3 p : mesh.positions) out[{std::lround(p.x * 1e4f), std::lround(p.z * 1e4f)}] = p.y;
    return out;
}

TEST(Displace, ItDoesNotMatterIntoHowManyObjectsASurfaceIsCut) {
    const auto white = heights([](double, double) { return 1.0; });
    const auto whole = surface_of({0, 40}, white);
    ASSERT_GT(whole.size(), 1000u);
    for (const auto& [at, y] : whole) ASSERT_NEAR(y, 0.2 * std::sqrt(4.0 / 8.0), 1e-6);  // 4 m^2, u to 8
    EXPECT_EQ(surface_of({0, 13, 27, 40}, white), whole);
    const auto wave = heights([](double u, double v) { return 0.5 + 0.3 * std::sin(2 * pi * u) + 0.2 * v; });
    EXPECT_EQ(surface_of({0, 13, 27, 40}, wave), surface_of({0, 40}, wave));
}

TEST(Displace, ReliefFinerThanTheTrianglesFadesAndIsSaid) {
    const auto checks = heights([](double u, double v) { return double((int(u * 32) + int(v * 32)) % 2); });
    Scene plane = make_primitive({.shape = PrimitiveShape::plane});
    plane = with_heights(std::move(plane), checks, {.depth = 0.1f});
    const auto spread = [&](double edge, std::size_t remarks) {
        Context context;
        const Scene out = displace_scene(plane, {.edge = edge}, context);
        const auto by_y = [](vec3 a, vec3 b) { return a.y < b.y; };
        const auto& p = out.meshes[0].positions;
        const auto [low, high] = std::minmax_element(p.begin(), p.end(), by_y);
        EXPECT_EQ(context.report().entries().size(), remarks);
        for (const ReportEntry& entry : context.report().entries())
            EXPECT_NE(entry.message.find("'displacement-edge'"), std::string::npos);
        return double(high->y - low->y);
    };
    EXPECT_NEAR(spread(0.02, 0), 0.2, 1e-3);  // checks of 1/16 m
    EXPECT_LT(spread(0.3, 1), 0.01);          // gray, where points of the map would be black or white
}

TEST(Displace, AMapThatCannotBeDecodedIsAWarning) {
    Context context;
    auto image = std::make_shared<EncodedImage>();
    image->decode = [](const EncodedImage&, Context&) -> Pixels { throw Error(ErrorCode::bad_file, "broken"); };
    const Scene plane = with_heights(make_primitive({.shape = PrimitiveShape::plane}), image, {});
    const Scene out = displace_scene(plane, {}, context);
    EXPECT_EQ(out.meshes[0].positions.identity(), plane.meshes[0].positions.identity());
    EXPECT_EQ(context.report().entries().size(), 1u);
}

}  // namespace
}  // namespace rakelight
