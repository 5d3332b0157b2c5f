// SPDX-License-Identifier: Apache-2.0
// Energy of what the engine itself shades: a white metal under lights from all directions, each as strong as the solid
// angle that it stands for. By reciprocity their sum is what leaves the surface of a beam along the view.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

/// Lights along the mirror directions of v = +z on facets of slope alpha q / (1 - q) about n, q even in 0..1: dense where
/// a lobe as wide as alpha is high, and all of the hemisphere about n.
std::vector<Light> lights_around(dvec3 n, double alpha) {
    constexpr int rings = 160, sectors = 96;
    const dvec3 v{0, 0, 1}, across{n.z, 0, -n.x}, up{0, 1, 0};
    std::vector<Light> lights;
    for (int i = 0; i < rings; ++i) {
        const double q = (i + 0.5) / rings, tangent = alpha * q / (1 - q);
        const double z = 1 / std::sqrt(1 + tangent * tangent), s = tangent * z;
        const double step = alpha / ((1 - q) * (1 - q)) * z * z / rings;  // d theta
        for (int k = 0; k < sectors; ++k) {
            const double phi = 2 * pi * (k + 0.5) / sectors;
            const dvec3 h = across * (s * std::cos(phi)) + up * (s * std::sin(phi)) + n * z;
            const double v_dot_h = dot(v, h);
            const dvec3 l = h * (2 * v_dot_h) - v;
            if (v_dot_h <= 0 || dot(l, n) <= 0) continue;
            const float share =
                float(4 * v_dot_h * s * step * 2 * pi / sectors / pi);  // a light of 1 has irradiance pi
            lights.push_back(directional(l * -1.0, {share, share, share}));
        }
    }
    return lights;
}

/// A white metal, seen at an angle to its normal, its grain turned about it from the plane of view [rad].
struct WhiteMetal {
    double roughness, angle, anisotropy = 0, turn = 0;
};

enum class Under { lights, compensated_lights, ambient_light };

/// Radiance under even light of 1 from all around.
double radiance(const WhiteMetal& metal, Under light) {
    const dvec3 n{std::sin(metal.angle), 0, std::cos(metal.angle)};
    Scene scene;
    Material m;
    m.base_color = {1, 1, 1, 1};
    m.metallic_roughness.metallic = 1, m.metallic_roughness.roughness = float(metal.roughness);
    m.metallic_roughness.anisotropy = float(metal.anisotropy);
    m.metallic_roughness.anisotropy_rotation_rad = float(metal.turn);
    scene.materials = {m};
    Mesh mesh = square_mesh(0);
    mesh.normals = std::vector<vec3>(4, vec3{float(n.x), float(n.y), float(n.z)});
    mesh.tangents = std::vector<vec4>(4, vec4{float(n.z), 0, float(-n.x), 1});
    add_object(scene, std::move(mesh));
    const double alpha = metal.roughness * metal.roughness, square = metal.anisotropy * metal.anisotropy;
    Light ambient;
    ambient.type = LightType::ambient;
    ambient.ambient = {1, 1, 1};
    scene.lights = {ambient};
    if (light != Under::ambient_light) scene.lights = lights_around(n, alpha + (1 - alpha) * square);
    RenderSettings s{.width = 1, .height = 1, .lighting = Lighting::pbr};
    s.multiple_scattering = light == Under::compensated_lights;
    return double(pixel(draw(scene, flat_camera(), s), 0, 0).x);
}

/// Directional albedo of a white metal at that angle between beam and normal.
double albedo(double roughness, double angle, bool compensated) {
    return radiance({roughness, angle}, compensated ? Under::compensated_lights : Under::lights);
}

}  // namespace

TEST(EngineFurnace, WithCompensationGgxReflectsAllWithinOnePercent) {
    for (const double roughness : {0.25, 0.4, 0.6, 0.8, 1.0})
        for (const double degrees : {0.0, 30.0, 60.0, 75.0, 85.0, 89.0, 89.9})
            EXPECT_NEAR(albedo(roughness, radians(degrees), true), 1, 0.01) << roughness << " at " << degrees;
}

TEST(EngineFurnace, WithoutCompensationARoughMetalKeepsOneMinusLogTwoOfABeamFromAbove) {
    EXPECT_NEAR(albedo(1, 0, false), 1 - std::log(2.0), 2e-3);
    for (const double roughness : {0.25, 0.6, 1.0})
        for (const double degrees : {0.0, 60.0, 85.0, 89.9})
            EXPECT_LE(albedo(roughness, radians(degrees), false), 1.002) << roughness << " at " << degrees;
}

TEST(EngineFurnace, AmbientLightIsTheSumOfLightsFromAllAroundOnBrushedMetalToo) {
    for (const double roughness : {0.2236, 0.3, 0.5})
        for (const double anisotropy : {0.4, 0.7, 1.0})
            for (const double degrees : {0.0, 30.0, 60.0, 80.0})
                for (const double turn : {0.0, pi / 4, pi / 2}) {
                    const WhiteMetal metal = {roughness, radians(degrees), anisotropy, turn};
                    const double sum = radiance(metal, Under::lights);
                    EXPECT_NEAR(radiance(metal, Under::ambient_light), sum, 0.05)
                        << roughness << " " << anisotropy << " at " << degrees << ", " << turn;
                    EXPECT_NEAR(radiance(metal, Under::compensated_lights), 1, 0.05)
                        << roughness << " " << anisotropy << " at " << degrees << ", " << turn;
                }
}
