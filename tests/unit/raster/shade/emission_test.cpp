// SPDX-License-Identifier: Apache-2.0
// Emission on pixels: added to what lights give, dimmed by a coat, not there on unlit surfaces.
#include <gtest/gtest.h>

#include "unit/raster/facing_square.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

Material glowing(vec3 emission) {
    Material m = metallic(0, 0.5f);
    m.emission = emission;
    return m;
}

constexpr Lighting all_models[] = {Lighting::lambert,    Lighting::phong, Lighting::blinn_phong,
                                   Lighting::oren_nayar, Lighting::ward,  Lighting::pbr};

TEST(Emission, IsSeenWithoutLightUnderEveryModel) {
    const Scene dark = facing_square(glowing({0.25f, 3, 0.5f}), {0, 0, 0}, {0, 0, 0});
    for (const Lighting model : all_models) {
        const vec4 seen = middle(dark, model);
        EXPECT_EQ(seen.x, 0.25f) << int(model);
        EXPECT_EQ(seen.y, 3.0f) << int(model);  // brighter than white
        EXPECT_EQ(seen.z, 0.5f) << int(model);
    }
}

TEST(Emission, IsAddedToWhatLightsGive) {
    for (const Lighting model : all_models) {
        const vec4 without = middle(facing_square(glowing({0, 0, 0})), model),
                   with = middle(facing_square(glowing({0.25f, 0, 0.5f})), model);
        EXPECT_NEAR(with.x, without.x + 0.25f, 1e-6) << int(model);
        EXPECT_EQ(with.y, without.y) << int(model);
        EXPECT_NEAR(with.z, without.z + 0.5f, 1e-6) << int(model);
    }
}

TEST(Emission, IsDimmedByWhatACoatReflects) {
    Material m = glowing({1, 1, 1});
    m.metallic_roughness.clearcoat = 1;
    EXPECT_NEAR(middle(facing_square(m, {0, 0, 0}, {0, 0, 0}), Lighting::pbr).x, 0.96, 1e-6);
}

/// A picture that is there but cannot be decoded, and coordinates that this engine does not have.
TEST(Emission, IsNotThereWhereItsTextureIsMissing) {
    auto broken = std::make_shared<EncodedImage>();
    broken->name = "broken.png";
    broken->decode = [](const EncodedImage&, Context&) -> Pixels { throw Error(ErrorCode::bad_file, "broken"); };
    for (const bool is_broken : {true, false}) {
        Scene scene = facing_square(glowing({1, 1, 0}), {0, 0, 0}, {0, 0, 0});
        const ImageHandle white = picture(rgb_pixels(1, 1, [](int, int) { return std::array<int, 3>{255, 255, 255}; }));
        scene.materials[0].emission_texture = add_texture(scene, is_broken ? broken : white);
        scene.materials[0].emission_texture.texcoord_set = is_broken ? 0 : 2;
        Context context({.threads = 1});
        auto engine = raster::make_engine();
        engine->prepare(scene, context);
        Frame frame;
        engine->render(flat_camera(), {.width = 32, .height = 32}, frame, context);
        EXPECT_EQ(pixel(frame, 16, 16), (vec4{0, 0, 0, 1}));
        int said = 0;
        for (const ReportEntry& e : context.report().entries())
            said += e.message == "the emission texture is missing: there is no emission" ? int(e.count) : 0;
        EXPECT_EQ(said, 1);
    }
}

TEST(Emission, IsNotThereOnUnlitSurfaces) {
    Material m = glowing({1, 1, 1});
    m.model = MaterialModel::unlit;
    EXPECT_EQ(middle(facing_square(m), Lighting::pbr).x, 0.5f);
}

}  // namespace
