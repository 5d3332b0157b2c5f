// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <rakelight/error.h>

#include "math/linear.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

Bounds box(dvec3 low, dvec3 high) {
    Bounds b;
    b.low = low;
    b.high = high;
    return b;
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
    EXPECT_LT(camera.z_far / camera.z_near, 10);
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
            const Camera camera = default_camera(b, aspect);
            expect_sane(camera);
            expect_all_corners_seen(camera, aspect, b);
        }
}

TEST(DefaultCamera, StandsAsNearAsTheMarginLets) {
    for (const Bounds& b : {box({-1, -1, -1}, {1, 1, 1}), box({0, 0, 0}, {10, 1, 1}), box({-1, 0, -1}, {1, 7, 1})}) {
        const Camera camera = default_camera(b, 2);
        dmat4 to_camera;
        ASSERT_TRUE(inverse_affine(camera.to_world, to_camera));
        const double tangent = std::tan(radians(20));
        double widest = 0;
        for (int k = 0; k < 8; ++k) {
            const dvec3 p = transform_point(
                to_camera, {k & 1 ? b.high.x : b.low.x, k & 2 ? b.high.y : b.low.y, k & 4 ? b.high.z : b.low.z});
            widest = std::max({widest, std::fabs(p.x) / (-p.z * tangent * 2), std::fabs(p.y) / (-p.z * tangent)});
        }
        EXPECT_LE(widest, 0.92 + 1e-9);
        EXPECT_GT(widest, 0.85);
    }
}

TEST(DefaultCamera, LooksFromFrontRightAbove) {
    const Camera camera = default_camera(box({-1, -1, -1}, {1, 1, 1}), 1);
    const dvec3 eye = camera.to_world[3].xyz();
    EXPECT_NEAR(eye.x / eye.z, 0.45, 1e-12);
    EXPECT_NEAR(eye.y / eye.z, 0.35, 1e-12);
    EXPECT_NEAR(camera.vertical_fov_rad, radians(40), 1e-15);
}

TEST(DefaultCamera, IsFiniteForPointsNothingAndBrokenAspects) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const Bounds& b :
         {Bounds{}, box({0, 0, 0}, {0, 0, 0}), box({1e30, 1e30, 1e30}, {1e30, 1e30, 1e30}), box({3, 3, 3}, {3, 3, 3})})
        for (const double aspect : {1.0, 0.0, -1.0, nan, inf, 1e300, 1e-300}) {
            const Camera camera = default_camera(b, aspect);
            for (const dvec4& column : camera.to_world.columns) EXPECT_TRUE(is_finite(column.xyz()));
            EXPECT_GT(camera.z_near, 0);
            EXPECT_GT(camera.z_far, camera.z_near);
            EXPECT_TRUE(std::isfinite(camera.z_far));
        }
}

TEST(DefaultCamera, OfAPointFarOutStandsApartFromIt) {
    const Bounds b = box({1e30, 0, 0}, {1e30, 0, 0});
    EXPECT_NE(default_camera(b, 1).to_world[3].xyz(), b.center());
}

TEST(ViewCamera, LooksFromTheNamedSide) {
    const Bounds b = box({0, 0, 0}, {2, 4, 6});
    const std::pair<const char*, dvec3> sides[] = {{"front", {0, 0, 1}}, {"back", {0, 0, -1}}, {"left", {-1, 0, 0}},
                                                   {"right", {1, 0, 0}}, {"top", {0, 1, 0}},   {"bottom", {0, -1, 0}}};
    for (const auto& [name, toward_eye] : sides) {
        const Camera camera = view_camera(b, 1.5, name);
        expect_sane(camera);
        expect_all_corners_seen(camera, 1.5, b);
        EXPECT_NEAR(dot(camera.to_world[2].xyz(), toward_eye), 1, 1e-12) << name;
    }
    EXPECT_NEAR(view_camera(b, 1, "top").to_world[1].z, -1, 1e-12) << "from the top, -Z is up in the picture";
    EXPECT_NEAR(view_camera(b, 1, "isometric").to_world[2].x, 1 / std::sqrt(3.0), 1e-12);
}

TEST(ViewCamera, RefusesAnUnknownSideByName) {
    try {
        view_camera(Bounds{}, 1, "behind");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::usage);
        EXPECT_NE(std::string(e.what()).find("behind"), std::string::npos);
    }
}

TEST(DefaultLights, AreAmbientKeyAndFillInTheCamerasFrame) {
    const Camera camera = view_camera(Bounds{}, 1, "back");
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
