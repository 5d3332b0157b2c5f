// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <rakelight/base/error.h>
#include <rakelight/scene/scene_queries.h>

#include "math/linear.h"
#include "scene/drawn_vertices.h"
#include "scene/fitted_camera.h"

namespace rakelight {
namespace {

Bounds box(dvec3 low, dvec3 high) {
    Bounds b;
    b.low = low;
    b.high = high;
    return b;
}

/// Points at places, each on a node of its own.
Scene points(const std::vector<dvec3>& places) {
    Scene scene;
    Mesh mesh;
    mesh.topology = Topology::points;
    mesh.positions = std::vector<vec3>{{0, 0, 0}};
    mesh.indices = std::vector<std::uint32_t>{0};
    scene.meshes.push_back(std::move(mesh));
    for (const dvec3& place : places) {
        Node node;
        node.local.translation = place;
        node.meshes = {0};
        scene.nodes.push_back(std::move(node));
    }
    return scene;
}

/// The corners of a box; nothing for an empty one.
Scene corners(const Bounds& b) {
    std::vector<dvec3> places;
    for (int k = 0; k < 8 && !b.empty(); ++k)
        places.push_back({k & 1 ? b.high.x : b.low.x, k & 2 ? b.high.y : b.low.y, k & 4 ? b.high.z : b.low.z});
    return points(places);
}

Camera camera_of(const Scene& scene, double aspect, const std::string& side = "default",
                 const FitOptions& wishes = {}) {
    return view_camera(DrawnVertices(scene), aspect, side, wishes);
}
Camera camera_of(const Bounds& b, double aspect, const std::string& side = "default", const FitOptions& wishes = {}) {
    return camera_of(corners(b), aspect, side, wishes);
}

/// The corner's place in the picture: x and y within -1..1 when it is seen, z the distance along the view.
dvec3 seen_at(const Camera& camera, double aspect, dvec3 p) {
    const dmat4& m = camera.to_world;
    const dvec3 d = p - m[3].xyz();
    const double z = -dot(d, m[2].xyz()), t = std::tan(camera.vertical_fov_rad / 2);
    return {dot(d, m[0].xyz()) / (z * t * aspect), dot(d, m[1].xyz()) / (z * t), z};
}

void expect_all_corners_seen(const Camera& camera, double aspect, const Bounds& b) {
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p{corner & 1 ? b.high.x : b.low.x, corner & 2 ? b.high.y : b.low.y,
                      corner & 4 ? b.high.z : b.low.z};
        const dvec3 s = seen_at(camera, aspect, p);
        EXPECT_LE(std::fabs(s.x), 1.0 + 1e-6);
        EXPECT_LE(std::fabs(s.y), 1.0 + 1e-6);
        EXPECT_GE(s.z, camera.z_near);
        EXPECT_LE(s.z, camera.z_far);
    }
}

void expect_sane(const Camera& camera) {
    for (const dvec4& column : camera.to_world.columns) EXPECT_TRUE(is_finite(column.xyz()));
    EXPECT_GT(camera.z_near, 0);
    EXPECT_GT(camera.z_far, camera.z_near);
    EXPECT_TRUE(std::isfinite(camera.z_far));
    EXPECT_LT(camera.z_far / camera.z_near, 20);
    EXPECT_NEAR(determinant(upper_left(camera.to_world)), 1, 1e-9);
}

TEST(DefaultCamera, SeesTheWholeBoxAtEveryAspectAndScale) {
    const Bounds boxes[] = {box({-1, -1, -1}, {1, 1, 1}),
                            box({0, 0, 0}, {10, 0.1, 1}),
                            box({5, 5, 5}, {5, 9, 5}),
                            box({-1, 0, -1}, {1, 0, 1}),
                            box({-1e30, -1e30, 0}, {1e30, 1e30, 0}),
                            box({-1e-30, -1e-30, 0}, {1e-30, 1e-30, 0}),
                            box({1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 1, 1e6 + 1})};
    for (const Bounds& b : boxes)
        for (const double aspect : {0.01, 0.5, 1.0, 16.0 / 9, 50.0}) {
            const Camera camera = camera_of(b, aspect);
            expect_sane(camera);
            expect_all_corners_seen(camera, aspect, b);
        }
}

/// The least rectangle of the picture (each side -1..1) that the places take.
Bounds rectangle_of(const Scene& scene, const Camera& camera, double aspect) {
    Bounds seen;
    for (const Node& node : scene.nodes) {
        const dvec3 d = node.local.translation - camera.to_world[3].xyz();
        const bool parallel = camera.projection == Projection::orthographic;
        const double z = parallel ? 1 : -dot(d, camera.to_world[2].xyz());
        const double half = parallel ? camera.half_height : std::tan(camera.vertical_fov_rad / 2) * z;
        const dvec3 p{dot(d, camera.to_world[0].xyz()) / (half * aspect), dot(d, camera.to_world[1].xyz()) / half, 0};
        seen.low = min(seen.low, p), seen.high = max(seen.high, p);
    }
    return seen;
}

/// 90 % of the tighter side, in the middle of both.
void expect_fills(const Scene& scene, const Camera& camera, double aspect, double share = 0.9) {
    const Bounds seen = rectangle_of(scene, camera, aspect);
    EXPECT_NEAR(std::max(seen.high.x - seen.low.x, seen.high.y - seen.low.y), 2 * share, 1e-9);
    EXPECT_NEAR(seen.low.x, -seen.high.x, 0.05) << aspect;
    EXPECT_NEAR(seen.low.y, -seen.high.y, 0.05) << aspect;
}

TEST(DefaultCamera, FillsNineTenthsOfTheTighterSideByTheSilhouetteInTheMiddleOfBoth) {
    std::uint32_t state = 12345;
    const auto random = [&] { return double((state = state * 1664525 + 1013904223) >> 8) / 0x1p24; };
    std::vector<Scene> scenes{corners(box({-1, -1, -1}, {1, 1, 1})), corners(box({0, 0, 0}, {10, 1, 1})),
                              corners(box({-1, 0, -1}, {1, 7, 1})), corners(box({1e6, 5, 5}, {1e6 + 3, 9, 5}))};
    for (int n = 0; n < 12; ++n) {  // lopsided clouds
        std::vector<dvec3> places;
        for (int k = 0; k < 40; ++k) places.push_back({std::pow(random(), 3) * 4, random(), std::pow(random(), 5) * 2});
        scenes.push_back(points(places));
    }
    for (const Scene& scene : scenes)
        for (const double aspect : {0.5, 1.0, 16.0 / 9, 3.0})
            for (const char* side : {"default", "front", "top", "isometric"}) {
                expect_fills(scene, camera_of(scene, aspect, side), aspect);
                expect_fills(scene, camera_of(scene, aspect, side, {.orthographic = true}), aspect);
                const FitOptions wishes{.vertical_fov_rad = radians(75), .fill = 0.5};
                expect_fills(scene, camera_of(scene, aspect, side, wishes), aspect, 0.5);
            }
}

TEST(DefaultCamera, StandsInFrontOfTheModelThoughItsFrontIsAPoint) {
    const Scene needle = points({{0, 0, 0}, {0, 0, 1}});
    const Camera camera = camera_of(needle, 1, "front");
    EXPECT_GT(camera.to_world[3].z, 1.1);
    expect_sane(camera_of(points({{0, 0, 0}, {0, 0, 1}, {0.001, 0, 0}}), 1, "front"));
}

TEST(DefaultCamera, LooksAlongADirectionAndGoesRoundAboutTheUpThatTheWorldHas) {
    const Bounds b = box({-1, -1, -1}, {1, 1, 1});
    const Camera along = camera_of(b, 1, "default", {.direction = dvec3{0, 0, -3}});
    const Camera front = camera_of(b, 1, "front");
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(length(along.to_world[k].xyz() - front.to_world[k].xyz()), 0, 1e-12) << k;
    const auto toward_eye = [&](const FitOptions& wishes) {
        return camera_of(b, 1, "front", wishes).to_world[2].xyz();
    };
    EXPECT_NEAR(length(toward_eye({.azimuth_rad = radians(90)}) - dvec3{1, 0, 0}), 0, 1e-12);
    EXPECT_NEAR(length(toward_eye({.elevation_rad = radians(90)}) - dvec3{0, 1, 0}), 0, 1e-12);
    const FitOptions z_up{.world_up = dvec3{0, 0, 2}, .azimuth_rad = radians(90)};
    EXPECT_NEAR(length(toward_eye(z_up) - dvec3{1, 0, 0}), 0, 1e-12);
    const Camera down = camera_of(b, 1, "default", {.direction = dvec3{0, -1, 0}});
    EXPECT_NEAR(down.to_world[1].z, -1, 1e-12);
}

TEST(DefaultCamera, LooksFromFrontRightAbove) {
    const Camera camera = camera_of(box({-1, -1, -1}, {1, 1, 1}), 1);
    const dvec3 eye = camera.to_world[2].xyz();
    EXPECT_NEAR(eye.x / eye.z, 0.45, 1e-12);
    EXPECT_NEAR(eye.y / eye.z, 0.35, 1e-12);
    EXPECT_NEAR(camera.vertical_fov_rad, radians(40), 1e-15);
}

TEST(DefaultCamera, IsFiniteForPointsNothingAndBrokenAspects) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const Bounds& b :
         {Bounds{}, box({0, 0, 0}, {0, 0, 0}), box({1e30, 1e30, 1e30}, {1e30, 1e30, 1e30}), box({3, 3, 3}, {3, 3, 3})})
        for (const double aspect : {1.0, 0.0, -1.0, nan, inf, 1e300, 1e-300}) {
            const Camera camera = camera_of(b, aspect);
            for (const dvec4& column : camera.to_world.columns) EXPECT_TRUE(is_finite(column.xyz()));
            EXPECT_GT(camera.z_near, 0);
            EXPECT_GT(camera.z_far, camera.z_near);
            EXPECT_TRUE(std::isfinite(camera.z_far));
        }
}

TEST(DefaultCamera, OfAPointFarOutStandsApartFromIt) {
    const Bounds b = box({1e30, 0, 0}, {1e30, 0, 0});
    EXPECT_NE(camera_of(b, 1).to_world[3].xyz(), b.center());
}

TEST(ViewCamera, LooksFromTheNamedSide) {
    const Bounds b = box({0, 0, 0}, {2, 4, 6});
    const std::pair<const char*, dvec3> sides[] = {{"front", {0, 0, 1}}, {"back", {0, 0, -1}}, {"left", {-1, 0, 0}},
                                                   {"right", {1, 0, 0}}, {"top", {0, 1, 0}},   {"bottom", {0, -1, 0}}};
    for (const auto& [name, toward_eye] : sides) {
        const Camera camera = camera_of(b, 1.5, name);
        expect_sane(camera);
        expect_all_corners_seen(camera, 1.5, b);
        EXPECT_NEAR(dot(camera.to_world[2].xyz(), toward_eye), 1, 1e-12) << name;
    }
    EXPECT_NEAR(camera_of(b, 1, "top").to_world[1].z, -1, 1e-12) << "from the top, -Z is up in the picture";
    EXPECT_NEAR(camera_of(b, 1, "isometric").to_world[2].x, 1 / std::sqrt(3.0), 1e-12);
}

TEST(ViewCamera, SidesTurnWithTheUpAxis) {
    const Bounds b = box({0, 0, 0}, {2, 4, 6});
    struct Case {
        const char* side;
        dvec3 toward_eye, up;
    };
    const Case z_up[] = {{"front", {0, -1, 0}, {0, 0, 1}}, {"back", {0, 1, 0}, {0, 0, 1}},
                         {"left", {-1, 0, 0}, {0, 0, 1}},  {"right", {1, 0, 0}, {0, 0, 1}},
                         {"top", {0, 0, 1}, {0, 1, 0}},    {"bottom", {0, 0, -1}, {0, -1, 0}}};
    for (const auto& [side, toward_eye, up] : z_up)
        for (const FitOptions& wishes : {FitOptions{.world_up = dvec3{0, 0, 1}}, FitOptions{.up = dvec3{0, 0, 5}}}) {
            const Camera camera = camera_of(b, 1.5, side, wishes);
            EXPECT_NEAR(length(camera.to_world[2].xyz() - toward_eye), 0, 1e-12) << side;
            EXPECT_NEAR(length(camera.to_world[1].xyz() - up), 0, 1e-12) << side;
            expect_fills(corners(b), camera, 1.5);
        }
    const Camera rolled = camera_of(b, 1, "front", {.world_up = dvec3{0, 0, 1}, .up = dvec3{1, 0, 0}});
    EXPECT_NEAR(rolled.to_world[1].x, 1, 1e-12) << "the picture's own up";
}

TEST(ViewCamera, RefusesAnUnknownSideByName) {
    try {
        camera_of(Bounds{}, 1, "behind");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::usage);
        EXPECT_NE(std::string(e.what()).find("behind"), std::string::npos);
    }
}

TEST(DefaultLights, AreAmbientKeyAndFillInTheCamerasFrame) {
    const Camera camera = camera_of(Bounds{}, 1, "back");
    const auto lights = default_lights(camera.to_world);
    ASSERT_EQ(lights.size(), 3u);
    EXPECT_EQ(lights[0].type, LightType::ambient);
    EXPECT_EQ(lights[0].ambient, (vec3{0.12f, 0.12f, 0.12f}));
    EXPECT_EQ(lights[0].diffuse, (vec3{0, 0, 0}));
    EXPECT_EQ(lights[1].diffuse, (vec3{0.68f, 0.68f, 0.68f}));
    EXPECT_EQ(lights[2].diffuse, (vec3{0.2f, 0.2f, 0.2f}));
    const dvec3 right = camera.to_world[0].xyz(), up = camera.to_world[1].xyz(), toward_eye = camera.to_world[2].xyz();
    for (const std::size_t i : {1u, 2u}) {
        EXPECT_EQ(lights[i].type, LightType::directional);
        EXPECT_EQ(lights[i].units, LightUnits::classical);
        EXPECT_EQ(lights[i].ambient, (vec3{0, 0, 0}));
        EXPECT_NEAR(length(lights[i].direction), 1, 1e-12);
        EXPECT_LT(dot(lights[i].direction, toward_eye), -0.3) << "what faces the camera is lit";
    }
    EXPECT_GT(dot(lights[1].direction, right), 0.2) << "the key light comes from the left";
    EXPECT_LT(dot(lights[1].direction, up), -0.2) << "and from above";
    EXPECT_LT(dot(lights[2].direction, right), -0.2) << "the fill comes from the right";
}

}  // namespace
}  // namespace rakelight
