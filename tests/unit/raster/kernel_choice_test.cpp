// SPDX-License-Identifier: Apache-2.0
// Kernels for some of all materials give what the one for every material gives, to the bit: the same source, with less in it.
#include <gtest/gtest.h>

#include "engines/raster/kernels/kernel_types.h"
#include "unit/raster/busy_scene.h"
#include "unit/raster/drawn.h"

namespace rakelight::raster {
namespace {

using test::busy_view;

/// Fog of density 0 changes nothing, but only the kernel for every material knows fog.
Scene for_every_kernel(Scene scene) {
    scene.fog.kind = FogKind::exponential;
    scene.fog.density = 0;
    return scene;
}

RenderSettings settings_for(Lighting lighting) {
    RenderSettings s;
    s.width = 120, s.height = 80;
    s.lighting = lighting;
    s.channels = channel_normal;
    return s;
}

void expect_same(const Scene& scene, const RenderSettings& settings, const std::string& what) {
    const Frame few = test::draw(scene, busy_view(), settings);
    const Frame every = test::draw(for_every_kernel(scene), busy_view(), settings);
    EXPECT_TRUE(test::same_bits(few, every)) << what;
    EXPECT_TRUE(test::same_bits(few.normal, every.normal)) << what;
}

constexpr Lighting all_models[] = {Lighting::lambert, Lighting::phong, Lighting::blinn_phong, Lighting::pbr};

TEST(KernelChoice, EachGivesTheBitsOfTheOneForEveryMaterial) {
    for (const Lighting lighting : all_models)
        for (const int samples : {1, 4})
            for (const int anisotropy : {1, 8}) {
                RenderSettings s = settings_for(lighting);
                s.samples = samples, s.anisotropy = anisotropy;
                expect_same(test::busy_scene(), s,
                            std::to_string(int(lighting)) + ", samples " + std::to_string(samples) + ", anisotropy " +
                                std::to_string(anisotropy));
            }
}

TEST(KernelChoice, AlsoWhereLightIsNotEvaluatedAtThePixels) {
    for (const Lighting lighting : all_models)
        for (const Shading shading : {Shading::unlit, Shading::flat, Shading::gouraud}) {
            RenderSettings s = settings_for(lighting);
            s.shading = shading;
            expect_same(test::busy_scene(), s, std::to_string(int(lighting)) + " " + std::to_string(int(shading)));
        }
}

TEST(KernelChoice, AlsoInAnEnvironmentAndInShadow) {
    Scene around = test::busy_scene();
    around.environment.emplace();
    for (const bool shadows : {false, true}) {
        RenderSettings s = settings_for(Lighting::pbr);
        s.shadows = shadows, s.shadow_size = 64;
        expect_same(around, s, shadows ? "environment, shadows" : "environment");
        expect_same(test::busy_scene(), s, shadows ? "shadows" : "lights");
    }
}

TEST(KernelChoice, AlsoFromAParallelViewAndForAViewerAtInfinity) {
    Camera parallel = busy_view();
    parallel.projection = Projection::orthographic;
    parallel.half_height = 3;
    for (const Lighting lighting : all_models) {
        RenderSettings s = settings_for(lighting);
        const Frame few = test::draw(test::busy_scene(), parallel, s);
        EXPECT_TRUE(test::same_bits(few, test::draw(for_every_kernel(test::busy_scene()), parallel, s)));
        s.viewer_at_infinity = true;
        expect_same(test::busy_scene(), s, "viewer at infinity " + std::to_string(int(lighting)));
    }
}

TEST(KernelChoice, MapsOfFloatTexelsAreReadByTheKernelForEveryMaterial) {
    Scene scene = test::busy_scene();
    Pixels floats;
    floats.width = floats.height = 8, floats.channels = 4;
    floats.component = Component::f32, floats.is_linear = true;
    const std::vector<vec4> colors(64, {0.25f, 0.5f, 2, 1});
    floats.bytes.resize(64 * sizeof(vec4));
    std::memcpy(floats.bytes.data(), colors.data(), floats.bytes.size());
    const TextureUse use = test::add_texture(scene, test::picture(floats));
    for (Material& m : scene.materials) m.base_color_texture = use;
    for (const Lighting lighting : all_models)
        expect_same(scene, settings_for(lighting), std::to_string(int(lighting)));
}

}  // namespace
}  // namespace rakelight::raster
