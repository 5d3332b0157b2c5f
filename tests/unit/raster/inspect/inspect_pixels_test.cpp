// SPDX-License-Identifier: Apache-2.0
// What the pixel stages leave: the terms of the lights add up to the picture, and the picture is the engine's.
#include "engines/raster/inspect/inspect_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>

#include "engines/raster/inspect/inspect_samples.h"
#include "engines/raster/inspect/inspect_shading.h"
#include "engines/raster/multisample.h"
#include "unit/raster/busy_scene.h"
#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int width = 96, height = 70;

RenderSettings settings(int samples) {
    return {.width = width, .height = height, .samples = samples, .background = {0, 0, 0, 1}};
}

std::vector<vec4> draw(const Scene& scene, const RenderSettings& s) { return test::draw(scene, busy_view(), s).color; }

struct Looked {
    Context context{{.threads = 1}};
    raster::Inspection inspection;
    raster::Inspection::Geometry open, drawn;
    raster::PixelStageData data;
    Looked(const Scene& scene, const RenderSettings& s, std::size_t max_lights = 8)
        : inspection(scene, busy_view(), s, context),
          open(inspection, {}, true, context),
          drawn(inspection, {}, false, context),
          data(inspect_pixels(inspection, open, drawn, max_lights, context)) {}
};

/// Light from all around and fog, too.
Scene busy_scene_in_fog() {
    Scene scene = busy_scene();
    scene.environment = Environment{.intensity = 0.5f, .is_background = false};
    scene.fog = {FogKind::exponential, {0.4f, 0.3f, 0.6f}, 0, 1, 0.2f};
    return scene;
}

vec3 sum_of_terms(const raster::PixelStageData& d, std::size_t p) {
    vec3 sum = d.emission[p] + d.own_color[p];
    for (const raster::TermPictures& t : d.lights) sum += t.ambient[p] + t.diffuse[p] + t.specular[p];
    for (const std::vector<vec3>* term :
         {&d.other_lights, &d.around_diffuse, &d.around_specular, &d.transmitted, &d.fog})
        if (!term->empty()) sum += (*term)[p];
    return sum;
}

}  // namespace

TEST(InspectPixels, TermsOfLightsSurroundingsAndFogAddUpToThePictureInShadowToo) {
    const Scene scene = busy_scene_in_fog();
    for (const Shading shading : {Shading::phong, Shading::gouraud, Shading::flat}) {
        RenderSettings s = settings(1);
        s.shading = shading;
        s.shadows = true;
        s.shadow_size = 256;
        const Looked looked(scene, s, shading == Shading::flat ? 8 : 2);
        EXPECT_EQ(looked.data.other_lights.empty(), shading == Shading::flat);
        int shown = 0;
        for (std::size_t p = 0; p < looked.data.color.size(); ++p) {
            if (!looked.data.shows(p)) continue;
            ++shown;
            const vec3 sum = sum_of_terms(looked.data, p);
            const vec4 color = looked.data.color[p];
            const float tolerance = 2e-5f * (1 + color.x + color.y + color.z);
            EXPECT_NEAR(sum.x, color.x, tolerance) << p;
            EXPECT_NEAR(sum.y, color.y, tolerance) << p;
            EXPECT_NEAR(sum.z, color.z, tolerance) << p;
        }
        EXPECT_GT(shown, 4000);
    }
}

TEST(InspectPixels, ShadowFogAndReliefAreThoseOfThePixel) {
    RenderSettings s = settings(1);
    s.shadows = true;
    s.bump = Bump::steep;
    Scene scene = busy_scene_in_fog();
    scene.materials[0].height_texture = scene.materials[0].base_color_texture;
    const Looked looked(scene, s);
    Context context({.threads = 1});
    int dark = 0, foggy = 0, moved = 0, beside = 0;
    for (int p = 30; p < width * height; p += 97) {
        const raster::PixelExplanation e = looked.inspection.explain(p % width, p / width, context);
        const auto at = std::size_t(p);
        if (e.samples[0].triangle == SIZE_MAX) continue;
        const raster::ShadedLayer& layer = e.layers[0];
        const raster::PixelTrace& t = layer.trace;
        EXPECT_EQ(looked.data.fog_share[at], t.fog_share);
        foggy += t.fog_share < 0.8f;
        for (std::size_t i = 0; i < 5; ++i) {
            bool arrives = !layer.is_unlit;
            if (arrives) {
                const raster::TracedLight& l = layer.lights[i];
                arrives = std::ranges::any_of(l.ambient_color, [](float x) { return x > 0; }) ||
                          std::ranges::any_of(l.diffuse_color, [](float x) { return x > 0; });
                beside += !arrives && l.spot == 0;
            }
            EXPECT_EQ(looked.data.seen[i][at], arrives ? layer.lights[i].seen : -1) << p;
        }
        if (!layer.is_unlit) dark += layer.lights[0].seen < 0.5f;
        if (!t.map[role_height].is_used) continue;
        EXPECT_EQ(looked.data.relief_height[at], t.relief_height);
        EXPECT_EQ(looked.data.relief_shift[at].x, t.relief_texcoord[0][0] - t.texcoord[0][0]);
        moved += looked.data.relief_shift[at].x != 0;
    }
    EXPECT_GT(dark, 3);
    EXPECT_GT(beside, 3) << "beside a cone";
    EXPECT_GT(foggy, 3);
    EXPECT_GT(moved, 3);
}

TEST(InspectPixels, TermsOfAllLightsAddUpToThePictureAlsoWhereSurfacesAreLaidOver) {
    const Scene scene = busy_scene();
    for (const Shading shading : {Shading::phong, Shading::gouraud, Shading::flat}) {
        RenderSettings s = settings(1);
        s.shading = shading;
        s.background = {0.3f, 0.2f, 0.1f, shading == Shading::flat ? 0.5f : 1.0f};
        const Looked looked(scene, s);
        int laid_over = 0;
        for (std::size_t p = 0; p < looked.data.color.size(); ++p) {
            if (!looked.data.shows(p)) {
                EXPECT_EQ(looked.data.own_color[p], vec3{}) << p;
                continue;
            }
            vec3 sum = looked.data.emission[p] + looked.data.own_color[p];
            for (const raster::TermPictures& t : looked.data.lights) sum += t.ambient[p] + t.diffuse[p] + t.specular[p];
            const vec4 color = looked.data.color[p];
            const float tolerance = 2e-5f * (1 + color.x + color.y + color.z);
            EXPECT_NEAR(sum.x, color.x, tolerance) << p;
            EXPECT_NEAR(sum.y, color.y, tolerance) << p;
            EXPECT_NEAR(sum.z, color.z, tolerance) << p;
            laid_over += looked.data.layer_count[p] > 0;
        }
        EXPECT_GT(laid_over, 500);
    }
}

TEST(InspectPixels, OverdrawIsThatOfTheChannel) {
    const Scene scene = busy_scene();  // masked and blended surfaces, too
    RenderSettings s = settings(1);
    const Looked looked(scene, s);
    s.channels = channel_overdraw;
    const Frame frame = draw(scene, busy_view(), s);
    int laid_over = 0;
    for (std::size_t p = 0; p < frame.overdraw.size(); ++p) {
        ASSERT_EQ(looked.data.overdraw[p], frame.overdraw[p]) << p;
        EXPECT_TRUE(frame.overdraw[p] == 0 || (looked.data.faces[p] & 4));
        laid_over += looked.data.layer_count[p] > 0;
    }
    EXPECT_GT(laid_over, 100) << "which do not count";
}

TEST(InspectPixels, ThePictureIsTheEnginesAlsoWithLinesBehindGlass) {
    Scene scene = busy_scene();
    Mesh lines;
    lines.topology = Topology::lines;
    lines.positions = std::vector<vec3>{{-3, -1, -1}, {3, 1, 1}, {-3, 2, 1}, {3, -2, -1}};
    lines.indices = std::vector<std::uint32_t>{0, 1, 2, 3};
    lines.material = 4;
    add_object(scene, std::move(lines));
    for (const int samples : {1, 4}) {
        RenderSettings s = settings(samples);
        s.line_width = 4;
        const Looked looked(scene, s);
        EXPECT_TRUE(same_bits(looked.data.color, draw(scene, s))) << samples;
        EXPECT_FALSE(same_bits(looked.data.color, draw(busy_scene(), s))) << samples;
    }
}

TEST(InspectPixels, ALayerShowsByItsAlphaAndLetsThroughTheRest) {
    Scene scene;
    scene.materials = {matte({1, 0.5f, 0}), matte({0, 0, 1})};
    scene.materials[1].alpha_mode = AlphaMode::blend;
    scene.materials[1].base_color.w = 0.25f;
    add_object(scene, square_mesh(0, 9));
    add_object(scene, square_mesh(1, 9), translation(dvec3{0, 0, 1}));
    scene.lights = {directional({0, 0, -1})};
    const raster::PixelStageData data = Looked(scene, settings(1)).data;
    const vec3 diffuse = data.lights[0].diffuse[width * 35 + 48];
    EXPECT_NEAR(diffuse.x, 0.75f, 1e-6f);
    EXPECT_NEAR(diffuse.y, 0.375f, 1e-6f);
    EXPECT_NEAR(diffuse.z, 0.25f, 1e-6f);
}

TEST(InspectPixels, ThePictureIsTheEnginesToTheBitForAnyNumberOfSamples) {
    const Scene scene = busy_scene();
    const Looked one(scene, settings(1));
    EXPECT_TRUE(one.data.center_color.empty());
    for (const int samples : {1, 4, 8}) {
        const std::vector<vec4> picture = draw(scene, settings(samples));
        const Looked looked(scene, settings(samples));
        EXPECT_TRUE(same_bits(looked.data.color, picture)) << samples;
        EXPECT_TRUE(same_bits(looked.data.centers(), one.data.color)) << samples;
        EXPECT_EQ(looked.data.draw, one.data.draw);
        Context context({.threads = 1});
        EXPECT_TRUE(same_bits(draw_shaded(looked.inspection, Shading::phong, context).color, picture)) << samples;
    }
}

TEST(InspectPixels, SamplesAreCountedAndTheirMeanIsThePixel) {
    const Scene scene = busy_scene();
    for (const int samples : {4, 8}) {
        const Looked looked(scene, settings(samples));
        const Window part{64, 16, 16, 16};
        const raster::SampleColors colors = inspect_samples(looked.inspection, looked.drawn, part);
        ASSERT_EQ(colors.color.size(), std::size_t(16 * 16 * samples));
        for (std::size_t i = 0; i < 256; ++i) {
            const std::size_t p = (16 + i / 16) * width + 64 + i % 16;
            const vec4* const its = &colors.color[i * std::size_t(samples)];
            EXPECT_EQ(shading::mean_of_samples(its, std::size_t(samples)), looked.data.color[p]);
            float low = 1, high = 0;
            for (int k = 0; k < samples; ++k)
                low = std::min(low, std::min(its[k].x, 1.0f)), high = std::max(high, std::min(its[k].x, 1.0f));
            EXPECT_LE(high - low, looked.data.sample_spread[p]);
        }
        int edges = 0;
        for (std::size_t p = 0; p < looked.data.color.size(); ++p) {
            const int covered = looked.data.samples_covered[p], shown = looked.data.visible_triangles[p];
            EXPECT_LE(covered, samples);
            EXPECT_LE(shown, covered);
            EXPECT_EQ(shown == 0, covered == 0);
            edges += shown > 1;
        }
        EXPECT_GT(edges, 100);
    }
}
