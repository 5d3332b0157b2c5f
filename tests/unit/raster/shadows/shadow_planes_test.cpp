// SPDX-License-Identifier: Apache-2.0
// How far the planes of surfaces are carried over a shadow map: rough ground deep in a shadow, the blurred edge of a
// shadow, corners in the light.
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/raster/shadows/shadow_scenes.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int width = 160, height = 120;

RenderSettings shadowed(int filter, int size = 1024) {
    return {.width = width,
            .height = height,
            .shadows = true,
            .shadow_size = size,
            .shadow_filter = filter,
            .background = {0, 0, 0, 1}};
}

Scene scene_with(const Light& light) {
    Scene scene;
    Material white = matte();
    white.classical.specular = {};
    white.double_sided = true;
    scene.materials = {white};
    scene.lights = {light};
    return scene;
}

/// [0, 1): of a lattice point.
double noise(int x, int y) {
    std::uint32_t h = std::uint32_t(x) * 0x9e3779b1u ^ std::uint32_t(y) * 0x85ebca77u;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return (h ^ h >> 15) * 0x1p-32;
}

/// A lattice of side 2 `half` about y = 0, `cells` a side, whose points lie up to `rough` above it. Lit as if it were
/// flat: what light its facets get is seen in full however they turn.
Mesh rough_ground(double half, int cells, double rough) {
    std::vector<vec3> points, normals;
    std::vector<std::uint32_t> indices;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const double x = (2.0 * i / cells - 1) * half, z = (2.0 * j / cells - 1) * half;
            points.push_back({float(x), float(rough * noise(i, j)), float(z)});
            normals.push_back({0, 1, 0});
        }
    const auto at = [&](int i, int j) { return std::uint32_t(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i)
            for (const std::uint32_t n :
                 {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i + 1, j)})
                indices.push_back(n);
    Mesh mesh;
    mesh.positions = points;
    mesh.normals = normals;
    mesh.indices = indices;
    mesh.material = 0;
    return mesh;
}

/// Pixels with light, and without, of those that show something.
struct Shares {
    int bright = 0, dark = 0;
};
Shares shares_of(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
    RenderSettings without = settings;
    without.shadows = false;
    const Frame with = draw(scene, camera, settings), lit = draw(scene, camera, without);
    Shares out;
    for (std::size_t i = 0; i < with.color.size(); ++i) {
        if (lit.color[i].x < 0.01f) continue;
        out.bright += with.color[i].x > 0.01f * lit.color[i].x;
        out.dark += with.color[i].x < 0.5f * lit.color[i].x;
    }
    return out;
}

/// Whether a pixel shows what faces up.
std::vector<bool> floor_pixels(const Scene& scene, const Camera& camera) {
    const RayCast exact(scene);
    const dmat4& m = camera.to_world;
    const double h = std::tan(camera.vertical_fov_rad / 2);
    std::vector<bool> out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double u = ((x + 0.5) / width * 2 - 1) * h * width / height, v = (1 - (y + 0.5) / height * 2) * h;
            const auto hit = exact.nearest(m[3].xyz(), m[0].xyz() * u + m[1].xyz() * v - m[2].xyz());
            out.push_back(hit && hit->normal.y > 0.99);
        }
    return out;
}

}  // namespace

TEST(ShadowPlanes, RoughGroundDeepInAShadowIsDarkHoweverItsFacetsTurn) {
    Light lights[] = {directional({-0.6, -1, 0.5}), lamp({3, 5, -2.5}), spot_at({3, 5, -2.5}, {0, 0, 0}, 0.9)};
    for (const Light& light : lights)
        for (const int filter : {0, 1, 4}) {
            Scene scene = scene_with(light);
            add_object(scene, rough_ground(5, 80, 0.15), dmat4{});
            dmat4 roof = lying();
            roof[3] = {0, 1.5, 0, 1};
            add_square(scene, 2.5, roof);
            // Under the middle of the roof and a little along the light: its shadow ends over a meter away.
            const Shares s = shares_of(scene, looking({-0.9, 1.2, 2.5}, {-0.9, 0, 0.75}, 0.5), shadowed(filter));
            EXPECT_GT(s.bright + s.dark, 8000) << filter;
            EXPECT_EQ(s.bright, 0) << "filter " << filter << " light " << int(light.type);
        }
}

TEST(ShadowPlanes, RoughGroundInTheLightHasNoneWhereNoFacetHidesAnother) {
    // Facets fall by at most 1 in 1.19 along the light, which falls by 1 in 1.1: all of them are in the light, some
    // with a cosine of 0.03.
    const double step = 0.125, rough = step / 1.68;
    for (const int filter : {0, 1, 4}) {
        Scene scene = scene_with(directional({-1.1, -1, 0}));
        add_object(scene, rough_ground(5, 80, rough), dmat4{});
        const Shares s = shares_of(scene, looking({-0.9, 3, 2.5}, {-0.9, 0, 0.75}, 0.5), shadowed(filter));
        EXPECT_GT(s.bright, width * height * 99 / 100);
        EXPECT_LE(s.dark, width * height / 1000) << filter;
    }
}

TEST(ShadowPlanes, ABlurredEdgeHasNoStepWhereThePlaneOfWhatThrowsItMeetsTheFloor) {
    // A steep pane over a floor, in light from straight above: its plane meets the floor where the edge is blurred.
    Scene scene = scene_with(directional({0, -1, 0}));
    add_square(scene, 4, lying());
    dmat4 pane;
    const double s = 1 / std::sqrt(10.0);  // three up, one aside
    pane[0] = {0, 0, 1, 0}, pane[1] = {s, 3 * s, 0, 0}, pane[2] = {-3 * s, s, 0, 0}, pane[3] = {0.31, 1.27, 0, 1};
    add_square(scene, 1, pane);  // over x from -0.006 to 0.626, its lower edge 0.32 above the floor
    const Camera camera = looking({-0.5, 2.5, 0.6}, {-0.05, 0, 0}, 0.2);
    const std::vector<bool> floor = floor_pixels(scene, camera);
    for (const int filter : {1, 2, 4}) {
        const Frame frame = draw(scene, camera, shadowed(filter, 64));  // texels of 0.14 m, 20 pixels and more
        float most = 0;
        for (std::size_t i = width; i < floor.size(); ++i)
            for (const std::size_t beside : {i - 1, i - width})
                if (floor[i] && floor[beside] && i % width > 0)
                    most = std::max(most, std::fabs(frame.color[i].x - frame.color[beside].x));
        EXPECT_GT(most, 0.002f) << filter;
        EXPECT_LT(most, 0.04f) << filter;
    }
}

TEST(ShadowPlanes, AFloorAndAWallThatMeetInTheLightAreLitUpToTheEdgeWhateverTheFilter) {
    for (const double steep : {0.5, 1.0, 3.0})
        for (const int filter : {0, 1, 4}) {
            Scene scene = scene_with(directional({0, -steep, -1}));
            add_square(scene, 4, lying());
            add_square(scene, 4, translation(dvec3{0, 4, 0}));
            const Shares s = shares_of(scene, looking({0.3, 0.3, 0.5}, {0, 0, 0}, 0.5), shadowed(filter, 256));
            EXPECT_GT(s.bright, width * height * 99 / 100);
            EXPECT_EQ(s.dark, 0) << steep << ' ' << filter;
        }
}
