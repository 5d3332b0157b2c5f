// SPDX-License-Identifier: Apache-2.0
// Clipping against slow references: polygons cut in extended precision, and rays through pixel centers for triangles
// that pass through the plane of the eye, where a division before clipping would wrap them round.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "engines/raster/geometry/clip.h"
#include "engines/raster/raster_engine.h"
#include "math/functions.h"
#include "support/scene_builder.h"

using namespace rakelight;
using namespace rakelight::raster;
using namespace rakelight::test;

namespace {

using Exact = long double;  // 64 bits of mantissa: what single precision holds has 40 to spare

struct ExactVertex {
    Exact x, y, w, distance;
};
using Polygon = std::vector<ExactVertex>;

/// A plane as the numbers by which a vertex's are weighed; >= 0 inside.
struct Plane {
    Exact x, y, w, distance, one;
    Exact of(const ExactVertex& v) const { return x * v.x + y * v.y + w * v.w + distance * v.distance + one; }
};

Polygon cut(const Polygon& in, const Plane& plane) {
    Polygon out;
    for (std::size_t i = 0; i < in.size(); ++i) {
        const ExactVertex &a = in[i], &b = in[(i + 1) % in.size()];
        const Exact da = plane.of(a), db = plane.of(b);
        if (da >= 0) out.push_back(a);
        if ((da >= 0) == (db >= 0)) continue;
        const Exact t = da / (da - db);
        out.push_back({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.w + (b.w - a.w) * t,
                       a.distance + (b.distance - a.distance) * t});
    }
    return out;
}

PictureCamera picture_camera_of(double near, double far) {
    Camera camera;
    camera.vertical_fov_rad = radians(90);
    camera.z_near = near;
    camera.z_far = far;
    return shading::make_picture_camera(camera, dmat4{}, {.width = 512, .height = 512});
}

/// [px] on the screen, about its middle
std::pair<Exact, Exact> screen(const ExactVertex& v) { return {v.x / v.w * 256, v.y / v.w * 256}; }

/// Twice the area on the screen [px^2].
Exact area(const Polygon& p) {
    Exact sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto [ax, ay] = screen(p[i]);
        const auto [bx, by] = screen(p[(i + 1) % p.size()]);
        sum += ax * by - bx * ay;
    }
    return sum;
}

/// [px] of a point from the border of a convex polygon on the screen; negative inside.
Exact outside_by(const ExactVertex& v, const Polygon& p, Exact sign) {
    Exact most = -1e30L;
    const auto [x, y] = screen(v);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto [ax, ay] = screen(p[i]);
        const auto [bx, by] = screen(p[(i + 1) % p.size()]);
        const Exact length = std::hypot(bx - ax, by - ay);
        if (length > 1e-9L) most = std::max(most, -sign * ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / length);
    }
    return most;
}

}  // namespace

/// Near and far plane: the polygon on the screen has the reference's area, and each corner lies in the reference to a
/// hundredth of what corners are rounded to (1/256 px), as far as single precision of its own coordinates allows.
TEST(ClipReference, PolygonsAgreeWithExtendedPrecision) {
    const PictureCamera view = picture_camera_of(0.5, 60);
    const ClipVolume volume(view);
    const Plane near{0, 0, 0, 1, -0.5L}, far{0, 0, 0, -1, 60};
    std::mt19937 random(21);
    std::uniform_real_distribution<float> place(-30, 30), depth(-40, 100);
    int cut_by_near = 0, cut_by_far = 0, gone = 0, compared = 0;
    for (int n = 0; n < 20000; ++n) {
        ClipVertex t[3];
        Polygon exact;
        unsigned codes = 0;
        for (ClipVertex& v : t) {
            const float distance = depth(random);
            v = {place(random), place(random), distance, distance};
            codes |= outcode(v, volume);
            exact.push_back({v.x, v.y, v.w, v.distance});
        }
        exact = cut(cut(exact, near), far);
        ClipVertex out[max_clipped_vertices];
        const std::size_t count = clip_triangle(t, codes & (clip_near | clip_far), volume, out);
        cut_by_near += (codes & clip_near) != 0;
        cut_by_far += (codes & clip_far) != 0;
        if (exact.size() < 3) {
            EXPECT_EQ(count, 0u) << n;
            ++gone;
            continue;
        }
        ASSERT_EQ(count, exact.size()) << n;
        Polygon ours;
        for (std::size_t i = 0; i < count; ++i) ours.push_back({out[i].x, out[i].y, out[i].w, out[i].distance});
        const Exact expected = area(exact), found = area(ours);
        Exact reach = 1;  // [px]
        for (const ExactVertex& v : exact)
            reach = std::max({reach, std::fabs(screen(v).first), std::fabs(screen(v).second)});
        EXPECT_NEAR(double(found), double(expected), double(reach * reach) * 2e-6) << n;
        if (std::fabs(expected) < reach * reach * 1e-4L) continue;  // slivers have no inside to speak of
        for (const ExactVertex& v : ours)
            EXPECT_LT(double(outside_by(v, exact, expected > 0 ? 1 : -1)), 1e-5 * double(reach)) << n;
        ++compared;
    }
    EXPECT_GT(cut_by_near, 5000);
    EXPECT_GT(cut_by_far, 5000);
    EXPECT_GT(gone, 100);
    EXPECT_GT(compared, 10000);
}

namespace {

constexpr int side = 96;

struct Triangle {
    dvec3 corner[3];
};

/// Where the ray through a place of the picture meets a triangle's plane; a camera at the origin of 90 degrees looks
/// along -z.
struct Meeting {
    double distance;   ///< [m] along the view axis
    unsigned outside;  ///< a bit for each edge, and each of near and far plane, that it lies beyond
};

Meeting meet(const Triangle& t, double x, double y, const Camera& camera) {
    const dvec3 direction{x / side * 2 - 1, 1 - y / side * 2, -1};
    const dvec3 e1 = t.corner[1] - t.corner[0], e2 = t.corner[2] - t.corner[0],
                p = cross(direction, e2);  // Moeller & Trumbore 1997
    const double det = dot(e1, p);
    const dvec3 s = -t.corner[0], q = cross(s, e1);
    const double u = dot(s, p) / det, v = dot(direction, q) / det, at = dot(e2, q) / det;
    return {at, unsigned(u < 0) | unsigned(v < 0) << 1 | unsigned(u + v > 1) << 2 |
                    unsigned(!(at >= camera.z_near)) << 3 | unsigned(!(at <= camera.z_far)) << 4};
}

}  // namespace

TEST(ClipReference, TrianglesThroughThePlaneOfTheEyeCoverWhatRaysMeet) {
    std::mt19937 random(22);
    std::uniform_real_distribution<double> place(-6, 6);
    Camera camera;
    camera.vertical_fov_rad = radians(90);
    camera.z_near = 0.25;
    camera.z_far = 1000;
    int checked = 0, covered = 0;
    for (int n = 0; n < 400; ++n) {
        Triangle t;
        for (dvec3& c : t.corner) c = cast<double>(cast<float>(dvec3{place(random), place(random), place(random)}));
        const auto behind =
            std::count_if(std::begin(t.corner), std::end(t.corner), [](const dvec3& c) { return c.z > 0; });
        if (behind == 0 || behind == 3) continue;
        Scene scene;
        scene.materials = {matte()};
        Mesh mesh;
        mesh.positions =
            std::vector<vec3>{cast<float>(t.corner[0]), cast<float>(t.corner[1]), cast<float>(t.corner[2])};
        mesh.indices = std::vector<std::uint32_t>{0, 1, 2};
        mesh.material = 0;
        add_object(scene, std::move(mesh));
        Context context({.threads = 1});
        const auto engine = make_engine();
        engine->prepare(scene, context);
        Frame frame;
        engine->render(camera,
                       {.width = side,
                        .height = side,
                        .channels = channel_depth,
                        .shading = Shading::unlit,
                        .background = {0, 0, 0, 0}},
                       frame, context);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double step = 1.0 / 64;  // nearer to an edge than this, rounding to 1/256 px may decide
                const Meeting middle = meet(t, x + 0.5, y + 0.5, camera);
                bool is_clear = true;
                for (int k = 0; k < 9; ++k)
                    is_clear &= meet(t, x + 0.5 + (k % 3 - 1) * step, y + 0.5 + (k / 3 - 1) * step, camera).outside ==
                                middle.outside;
                if (!is_clear) continue;
                const auto i = std::size_t(y * side + x);
                ASSERT_EQ(frame.color[i].w > 0, middle.outside == 0)
                    << "triangle " << n << ", pixel " << x << ", " << y;
                ++checked;
                if (middle.outside != 0) continue;
                ++covered;
                const double d = middle.distance;
                EXPECT_NEAR(double(frame.depth[i]), d, 2e-4 * d + 4e-5 * d * d)
                    << "triangle " << n << ", pixel " << x << ", " << y;
            }
    }
    EXPECT_GT(checked, 1'000'000);
    EXPECT_GT(covered, 100'000);
}

/// Where the near plane cuts: a floor under the eye reaches down to the last row that a ray meets beyond the near
/// plane, and no farther.
TEST(ClipReference, TheNearPlaneEndsAFloorWhereItMeetsIt) {
    for (const double near : {0.5, 1.0, 2.0, 4.0}) {
        Scene scene;
        scene.materials = {matte()};
        Mesh floor = square_mesh(0);
        floor.positions = std::vector<vec3>{{-50, -1, 50}, {50, -1, 50}, {50, -1, -50}, {-50, -1, -50}};
        add_object(scene, floor);
        Camera camera;
        camera.vertical_fov_rad = radians(90);
        camera.z_near = near;
        camera.z_far = 40;
        Context context({.threads = 1});
        const auto engine = make_engine();
        engine->prepare(scene, context);
        Frame frame;
        engine->render(camera, {.width = side, .height = side, .shading = Shading::unlit, .background = {0, 0, 0, 0}},
                       frame, context);
        // A point d away lies 1 / d below the middle; rows count from the top, the middle is at side / 2.
        const double last = side / 2 * (1 + std::min(1.0, 1 / near)), first = side / 2 * (1 + 1.0 / camera.z_far);
        for (int y = 0; y < side; ++y) {
            const double center = y + 0.5;
            if (std::fabs(center - last) < 0.01 || std::fabs(center - first) < 0.01) continue;
            EXPECT_EQ(frame.color[std::size_t(y * side + side / 2)].w > 0, center > first && center < last)
                << near << ", row " << y;
        }
    }
}

/// Where the far plane cuts: the same floor begins at the first row that a ray meets before the far plane.
TEST(ClipReference, TheFarPlaneEndsAFloorWhereItMeetsIt) {
    for (const bool orthographic : {false, true})
        for (const double far : {1.5, 2.0, 4.0, 8.0}) {
            Scene scene;
            scene.materials = {matte()};
            Mesh floor = square_mesh(0);
            floor.positions = std::vector<vec3>{{-50, -1, 50}, {50, -1, 50}, {50, -1, -50}, {-50, -1, -50}};
            if (orthographic)  // tilted, so that each row has a distance of its own
                floor.positions = std::vector<vec3>{{-50, -20, 20}, {50, -20, 20}, {50, 20, -20}, {-50, 20, -20}};
            add_object(scene, floor);
            Camera camera;
            camera.projection = orthographic ? Projection::orthographic : Projection::perspective;
            camera.vertical_fov_rad = radians(90);
            camera.half_height = 10;
            camera.z_near = 0.5;
            camera.z_far = far;
            Context context({.threads = 1});
            const auto engine = make_engine();
            engine->prepare(scene, context);
            Frame frame;
            engine->render(camera,
                           {.width = side, .height = side, .shading = Shading::unlit, .background = {0, 0, 0, 0}},
                           frame, context);
            for (int y = 0; y < side; ++y) {
                // Distance along the view axis where the middle of a row meets the floor.
                const double down = (y + 0.5) / (side / 2.0) - 1, distance = orthographic ? -10 * down : 1 / down;
                if (std::fabs(distance - far) < 0.05 || std::fabs(distance - 0.5) < 0.05) continue;
                EXPECT_EQ(frame.color[std::size_t(y * side + side / 2)].w > 0, distance > 0.5 && distance < far)
                    << far << ", row " << y << (orthographic ? ", parallel" : "");
            }
        }
}
