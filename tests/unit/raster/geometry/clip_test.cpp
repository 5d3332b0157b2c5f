// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/geometry/clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "shading/guard_band.h"

using namespace rakelight;
using namespace rakelight::raster;

namespace {

PictureCamera picture_camera_of(int width = 640, int height = 480) {
    Camera camera;
    camera.vertical_fov_rad = radians(90);
    camera.z_near = 0.5;
    camera.z_far = 100;
    return shading::make_picture_camera(camera, dmat4{}, {.width = width, .height = height});
}

/// A vertex at camera-space (x, y) at `distance` for the view above (field of view 90 degrees).
ClipVertex at(double x, double y, double distance) {
    return {float(x * 480.0 / 640.0), float(y), float(distance), float(distance)};
}

}  // namespace

TEST(Clip, AVertexInTheMiddleIsOutsideOfNothing) {
    EXPECT_EQ(outcode(at(0, 0, 10), ClipVolume(picture_camera_of())), 0u);
}

TEST(Clip, OutcodesNameThePlane) {
    const ClipVolume volume(picture_camera_of());
    EXPECT_EQ(outcode(at(0, 0, 0.4), volume), unsigned(clip_near));
    EXPECT_EQ(outcode(at(0, 0, 101), volume), unsigned(clip_far));
    EXPECT_TRUE(outcode(at(-20, 0, 10), volume) & clip_left);
    EXPECT_TRUE(outcode(at(20, 0, 10), volume) & clip_right);
    EXPECT_TRUE(outcode(at(0, 20, 10), volume) & clip_top);
    EXPECT_TRUE(outcode(at(0, -20, 10), volume) & clip_bottom);
    EXPECT_TRUE(outcode(at(0, 0, -10), volume) & clip_near) << "behind the eye";
}

TEST(Clip, NonFiniteVerticesAreOutsideOfEverything) {
    const ClipVolume volume(picture_camera_of());
    EXPECT_EQ(outcode({std::nanf(""), 0, 1, 1}, volume), outside_all);
    EXPECT_EQ(outcode({0, std::numeric_limits<float>::infinity(), 1, 1}, volume), outside_all);
}

TEST(Clip, ATriangleThroughTheEyePlaneKeepsOnlyItsFrontPart) {
    const ClipVolume volume(picture_camera_of());
    const ClipVertex triangle[3] = {at(-1, -1, 5), at(1, -1, 5), at(0, 1, -5)};
    ClipVertex out[max_clipped_vertices];
    const std::size_t count = clip_triangle(triangle, clip_near, volume, out);
    ASSERT_EQ(count, 4u);
    for (std::size_t i = 0; i < count; ++i) EXPECT_GE(out[i].w, 0.4999f);
}

TEST(Clip, ATriangleThroughTheFarPlaneKeepsOnlyItsNearPart) {
    const ClipVolume volume(picture_camera_of());
    const ClipVertex triangle[3] = {at(-1, -1, 50), at(1, -1, 50), at(0, 1, 200)};
    ClipVertex out[max_clipped_vertices];
    ASSERT_EQ(clip_triangle(triangle, clip_far, volume, out), 4u);
    int at_far = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_LE(out[i].distance, 100.0001f);
        if (std::fabs(out[i].distance - 100) > 1e-3f) continue;
        ++at_far;
        EXPECT_NEAR(out[i].y, -1 + 2.0 / 3, 1e-5) << "a third of the way to the far corner";
    }
    EXPECT_EQ(at_far, 2);
    const ClipVertex behind[3] = {at(-1, -1, 101), at(1, -1, 150), at(0, 1, 200)};
    EXPECT_EQ(clip_triangle(behind, clip_far, volume, out), 0u);
}

TEST(Clip, NeighborsThatShareAnEdgeGetTheSameNewVertex) {
    const ClipVolume volume(picture_camera_of());
    const ClipVertex p = at(0.3, -0.7, 7), q = at(0.1, 0.9, -3);
    const ClipVertex one[3] = {p, q, at(-2, 0, 4)}, two[3] = {q, p, at(2, 0, 4)};
    ClipVertex a[max_clipped_vertices], b[max_clipped_vertices];
    const std::size_t na = clip_triangle(one, clip_near, volume, a), nb = clip_triangle(two, clip_near, volume, b);
    int equal = 0;
    for (std::size_t i = 0; i < na; ++i)
        for (std::size_t k = 0; k < nb; ++k)
            equal += a[i].x == b[k].x && a[i].y == b[k].y && a[i].w == b[k].w && std::fabs(a[i].w - 0.5f) < 1e-5f;
    EXPECT_EQ(equal, 1);
}

TEST(Clip, NothingIsLeftOfATriangleBehindTheNearPlane) {
    const ClipVertex behind[3] = {at(-1, -1, 0.1), at(1, -1, 0.2), at(0, 1, -1)};
    ClipVertex out[max_clipped_vertices];
    EXPECT_EQ(clip_triangle(behind, clip_near, ClipVolume(picture_camera_of()), out), 0u);
}

TEST(Clip, ACutAtTheNearPlaneLiesThereHoweverFarTheOtherEnd) {
    const ClipVolume volume(picture_camera_of());
    for (const double far : {1e3, 1e9, 1e18, 1e30}) {
        const ClipVertex triangle[3] = {at(-1, -1, far), at(1, -1, far), at(0, 1, -1)};
        ClipVertex out[max_clipped_vertices];
        const std::size_t count = clip_triangle(triangle, clip_near, volume, out);
        ASSERT_EQ(count, 4u) << far;
        int at_near = 0;
        for (std::size_t i = 0; i < count; ++i)
            at_near += std::fabs(out[i].w - 0.5f) < 1e-6f && out[i].w == out[i].distance;
        EXPECT_EQ(at_near, 2) << far;
    }
}

TEST(Clip, TenThousandRandomTrianglesStayInsideAndKeepTheirPlane) {
    const PictureCamera view = picture_camera_of();
    const ClipVolume volume(view);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> big(-1e7, 1e7), depth(-200, 200);
    for (int n = 0; n < 10000; ++n) {
        const ClipVertex t[3] = {at(big(random), big(random), depth(random)),
                                 at(big(random), big(random), depth(random)),
                                 at(big(random), big(random), depth(random))};
        ClipVertex out[max_clipped_vertices];
        const std::size_t count = clip_triangle(t, cutting_planes, volume, out);
        ASSERT_LE(count, max_clipped_vertices);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_GT(out[i].w, 0);
            const dvec2 p = view.screen(out[i]);
            EXPECT_LT(std::fabs(p.x), shading::guard_band_px * 1.01);
            EXPECT_LT(std::fabs(p.y), shading::guard_band_px * 1.01);
        }
    }
}
