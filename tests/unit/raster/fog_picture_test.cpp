// SPDX-License-Identifier: Apache-2.0
// Fog in pictures: closed forms at known distances.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr vec3 fog_color{0.2f, 0.4f, 0.8f};

/// An unlit wall of color `color` at z = 0.
Scene wall(FogKind kind, vec4 color = {1, 0.5f, 0.25f, 1}) {
    Scene scene;
    add_object(scene, square_mesh(add_unlit(scene, color), 50));
    scene.fog = {.kind = kind, .color = fog_color, .start = 2, .end = 12, .density = 0.1f};
    return scene;
}

double factor(FogKind kind, double d) {
    switch (kind) {
        case FogKind::none:
            return 1;
        case FogKind::linear:
            return std::min(1.0, std::max(0.0, (12 - d) / 10));
        case FogKind::exponential:
            return std::exp(-0.1 * d);
        case FogKind::exponential_squared:
            return std::exp(-0.01 * d * d);
    }
    return 1;
}

void expect_mix(const Frame& f, int x, int y, double seen) {
    const double own[3] = {1, 0.5, 0.25};
    const vec4 is = pixel(f, x, y);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(is[c], own[c] * seen + double(fog_color[c]) * (1 - seen), 2e-6) << x << ' ' << y;
}

constexpr FogKind kinds[] = {FogKind::none, FogKind::linear, FogKind::exponential, FogKind::exponential_squared};

TEST(FogPicture, MixesByTheDistanceFromTheEyeNotByTheDepth) {
    Camera camera;
    camera.vertical_fov_rad = 1.5;
    camera.to_world = translation(dvec3{0, 0, 5});
    for (const FogKind kind : kinds) {
        const Frame f = draw(wall(kind), camera, {.width = 64, .height = 64});
        for (const int x : {0, 17, 63})
            for (const int y : {0, 31}) {
                const double h = std::tan(0.75), u = ((x + 0.5) / 32 - 1) * h, v = ((y + 0.5) / 32 - 1) * h;
                expect_mix(f, x, y, factor(kind, 5 * std::sqrt(1 + u * u + v * v)));
            }
    }
}

TEST(FogPicture, OfAParallelViewIsTheSameAllOverAPlaneAcross) {
    for (const FogKind kind : kinds) {
        const Frame f = draw(wall(kind), flat_camera(7), {.width = 16, .height = 16});
        expect_mix(f, 0, 0, factor(kind, 7));
        expect_mix(f, 15, 8, factor(kind, 7));
    }
}

TEST(FogPicture, LeavesTheBackgroundAsItIs) {
    Scene scene = wall(FogKind::exponential);
    scene.nodes[0].local.matrix = scaling(dvec3{0.001, 0.001, 0.001});
    const Frame f = draw(scene, flat_camera(7), {.width = 16, .height = 16, .background = {0.3f, 0.2f, 0.1f, 1}});
    EXPECT_EQ(pixel(f, 0, 0), (vec4{0.3f, 0.2f, 0.1f, 1}));
}

TEST(FogPicture, LiesOverLitSurfacesOfEveryShadingAlike) {
    Scene lit = wall(FogKind::exponential);
    lit.materials[0] = matte({1, 0.5f, 0.25f});
    lit.lights = {directional({0, 0, -1})};
    for (const Shading shading : {Shading::unlit, Shading::flat, Shading::gouraud, Shading::phong})
        expect_mix(draw(lit, flat_camera(7), {.width = 16, .height = 16, .shading = shading}), 5, 5,
                   factor(FogKind::exponential, 7));
}

}  // namespace
