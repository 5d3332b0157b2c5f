// SPDX-License-Identifier: Apache-2.0
// The preset of the fixed-function pipeline: what it sets, what goes before it, what it makes of materials and lights.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "support/temporary_folder.h"
#include "world/keys/fixed_function.h"

#include <rakelight/world/render_keys.h>
#include <rakelight/world/world_request.h>

namespace rakelight {
namespace {

WorldValue value(const std::string& key, const std::string& word) { return {.key = key, .words = {word}}; }
const WorldValue preset = value("preset", "fixed-function");

PictureRequest read(std::vector<WorldValue> values) {
    PictureRequest request;
    request.output = "picture.png";
    read_render_keys(values, request);
    return request;
}

TEST(FixedFunction, SetsWhatThePipelineCouldDo) {
    const PictureRequest r = read({preset});
    EXPECT_EQ(r.preset, Preset::fixed_function);
    EXPECT_EQ(r.settings.shading, Shading::gouraud);
    EXPECT_EQ(r.settings.lighting, Lighting::blinn_phong);
    EXPECT_EQ(r.settings.specular_form, SpecularForm::textbook);
    EXPECT_EQ(r.settings.bump, Bump::none);
    EXPECT_TRUE(r.settings.viewer_at_infinity);
    EXPECT_FALSE(r.settings.shadows || r.settings.ambient_occlusion);
    EXPECT_EQ(r.tone.mapping, ToneMapping::none);
    EXPECT_EQ(read({value("preset", "none")}).settings, RenderSettings{});
}

TEST(FixedFunction, WhatIsGivenGoesBeforeItInAnyOrder) {
    const WorldValue phong = value("shading", "phong"), shadows = value("shadows", "on"),
                     here = value("viewer-infinity", "off"), bump = value("bump", "auto");
    for (const auto& values : {std::vector{preset, phong, shadows, here, bump}, {bump, here, shadows, phong, preset}}) {
        const PictureRequest r = read(values);
        EXPECT_EQ(r.settings.shading, Shading::phong);
        EXPECT_EQ(r.settings.bump, Bump::automatic);
        EXPECT_TRUE(r.settings.shadows);
        EXPECT_FALSE(r.settings.viewer_at_infinity);
        EXPECT_EQ(r.settings.lighting, Lighting::blinn_phong);
        // Also where that is the default: it is written, and comes back.
        PictureRequest back;
        back.output = r.output;
        read_render_keys(written_render_keys(r), back);
        EXPECT_EQ(back.settings, r.settings);
    }
    const std::vector<WorldValue> written = written_render_keys(read({preset}));
    EXPECT_EQ(written.size(), 1u) << "the preset says the rest";
}

TEST(FixedFunction, FromOutsideItTakesThePlaceOfAWorldsOwnSettings) {
    const test::TemporaryFolder folder;
    const std::string file = folder.file("a.scene.toml");
    std::ofstream(file) << "[[primitive]]\ntype = \"sphere\"\n[render]\nshading = \"flat\"\nshadows = true\n"
                           "tone-mapping = \"aces\"\nresolution = [64, 48]\n";
    Context context;
    const std::vector<WorldValue> given = {preset};
    const PictureRequest r = read_world_request(file, {}, {.values = given}, context).picture;
    EXPECT_EQ(r.settings.shading, Shading::gouraud);
    EXPECT_FALSE(r.settings.shadows);
    EXPECT_EQ(r.tone.mapping, ToneMapping::none);
    EXPECT_EQ(r.settings.width, 64) << "what the preset does not decide stays";
    const std::vector<WorldValue> none = {value("preset", "none")};
    EXPECT_EQ(read_world_request(file, {}, {.values = none}, context).picture.settings.shading, Shading::flat);
}

Scene scene_of(const Material& m) {
    Scene scene;
    scene.materials = {m};
    return scene;
}

TEST(FixedFunction, MetallicRoughnessMaterialsKeepTheHighlightsCenter) {
    for (const float roughness : {0.3f, 0.5f, 0.8f}) {
        Material m;
        m.base_color = {0.8f, 0.4f, 0.2f, 1};
        m.metallic_roughness = {.metallic = 0.25f, .roughness = roughness};
        const Material out = with_preset(scene_of(m), read({preset})).materials[0];
        EXPECT_EQ(out.model, MaterialModel::classical);
        EXPECT_FALSE(out.classical.is_normalized);
        const double n = std::min(2 / std::pow(double(roughness), 4) - 2, 128.0);
        EXPECT_NEAR(out.classical.shininess, std::max(n, 1.0), 1e-3 * n);
        const double f0[3] = {0.04 * 0.75 + 0.8 * 0.25, 0.04 * 0.75 + 0.4 * 0.25, 0.04 * 0.75 + 0.2 * 0.25};
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(out.base_color[c], double(m.base_color[c]) * 0.75, 1e-6);
            EXPECT_NEAR(out.classical.ambient[c], m.base_color[c], 1e-6);
            EXPECT_NEAR(out.classical.specular[c], std::min(1.0, f0[c] * (std::max(n, 1.0) + 2) / 8), 1e-4);
        }
    }
}

TEST(FixedFunction, LeavesOutWhatHasNoPlaceInIt) {
    Material m;
    m.emission = {1, 1, 1};
    m.emission_texture.texture = m.occlusion_texture.texture = m.base_color_texture.texture = 0;
    m.bump = Bump::occlusion, m.lighting = Lighting::ward, m.shading = Shading::phong;
    Scene scene = scene_of(m);
    scene.nodes.resize(1);
    scene.nodes[0].shading = Shading::flat;
    scene.environment = Environment{.is_light = true, .is_background = false};
    const Scene out = with_preset(scene, read({preset}));
    const Material& made = out.materials[0];
    EXPECT_TRUE(bool(made.base_color_texture)) << "the one texture";
    EXPECT_FALSE(bool(made.emission_texture) || bool(made.occlusion_texture));
    EXPECT_EQ(made.emission, (vec3{0, 0, 0}));
    EXPECT_EQ(made.bump, Bump::none);
    EXPECT_EQ(made.lighting, Lighting::automatic);
    EXPECT_FALSE(made.shading || out.nodes[0].shading);
    EXPECT_FALSE(out.environment);
    EXPECT_TRUE(with_preset(scene, read({preset, value("hdri-ambient", "on")})).environment->is_light);
    EXPECT_EQ(with_preset(scene, read({preset, value("lighting", "ward")})).materials[0].lighting, Lighting::ward);
    EXPECT_EQ(with_preset(scene, read({})).materials, scene.materials);
}

TEST(FixedFunction, HasTheFirstEightLightsBesideAmbientOnes) {
    std::vector<Light> lights(12);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        lights[i].type = i % 6 == 1 ? LightType::ambient : LightType::point;
        lights[i].name = std::to_string(i);
    }
    const PictureRequest r = read({preset});
    EXPECT_EQ(lights_beyond_preset(lights, r), 2u);
    const std::vector<Light> kept = within_preset(lights, r);
    ASSERT_EQ(kept.size(), 10u);
    EXPECT_EQ(kept.back().name, "9");
    EXPECT_EQ(within_preset(lights, read({})).size(), 12u);
    EXPECT_EQ(lights_beyond_preset(kept, r), 0u);
}

}  // namespace
}  // namespace rakelight
