// SPDX-License-Identifier: Apache-2.0
#include "prepare/displace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <tuple>

#include "math/linear.h"
#include "prepare/primitives.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

/// A height map by formula of u, v in 0..1.
ImageHandle heights(const std::function<double(double, double)>& height, int size = 64) {
    auto image = std::make_shared<EncodedImage>();
    image->name = "heights";
    image->decode = [height, size](const EncodedImage&, Context&) {
        Pixels p{.width = size, .height = size, .channels = 1, .component = Component::f32, .is_linear = true};
        p.bytes.resize(p.row_bytes() * std::size_t(size));
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const float h = float(height((x + 0.5) / size, (y + 0.5) / size));
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
    const Scene out = displace_scene(plane, {.edge = 1e-4, .most_triangles = 5000}, context);
    EXPECT_LE(out.meshes[0].triangle_count(), 5000u);
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_NE(context.report().entries()[0].message.find("5000 triangles"), std::string::npos);
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
