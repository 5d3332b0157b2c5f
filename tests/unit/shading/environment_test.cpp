// SPDX-License-Identifier: Apache-2.0
#include "shading/environment.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "shading/lights/studio_light.h"
#include "support/scene_builder.h"
#include "support/shared.h"

namespace rakelight::shading {
namespace {

class CountingPacker final : public EnvironmentPacker {
public:
    std::shared_ptr<const PackedEnvironment> pack(const EnvironmentImages& images, const ImageHandle&,
                                                  Context&) const override {
        if (fails) throw Error(ErrorCode::bad_file, "too many texels");
        ++packed;
        levels = images.light.mirrored.size();
        has_sky = !images.sky.levels.empty();
        return std::make_shared<PackedEnvironment>();
    }
    mutable int packed = 0;
    mutable std::size_t levels = 0;
    mutable bool has_sky = false;
    bool fails = false;
};

ImageHandle gray(int code) {
    return test::picture(test::rgb_pixels(8, 4, [code](int, int) { return std::array{code, code, code}; }));
}

TEST(EnvironmentCache, TheStudiosLightIsWhatIsMadeOfItsPicture) {
    Context context({.threads = 1});
    const EnvironmentLight ready = studio_light(context);
    const EnvironmentLight made =
        make_environment_light(make_mip_chain(studio_panorama(), ColorSpace::linear, context), context);
    EXPECT_EQ(ready.irradiance, made.irradiance);
    ASSERT_EQ(ready.mirrored.size(), made.mirrored.size());
    for (std::size_t i = 0; i < ready.mirrored.size(); ++i) {
        EXPECT_EQ(ready.mirrored[i].size, made.mirrored[i].size);
        EXPECT_EQ(ready.mirrored[i].texels, made.mirrored[i].texels);
    }
}

TEST(EnvironmentCache, PacksTheSkyOnlyWhereItIsSeen) {
    Context context({.threads = 1});
    CountingPacker packer;
    EnvironmentCache cache;
    Scene scene;
    for (const ImageHandle& image : {ImageHandle(), gray(200)}) {
        scene.environment = Environment{.image = image, .is_background = false};
        packer.packed = 0;
        ASSERT_TRUE(cache.update(scene, packer, false, context));
        EXPECT_FALSE(packer.has_sky);
        scene.environment->is_background = true;
        ASSERT_TRUE(cache.update(scene, packer, false, context));
        EXPECT_TRUE(packer.has_sky);
        scene.environment->is_background = false;
        ASSERT_TRUE(cache.update(scene, packer, true, context));
        EXPECT_EQ(packer.packed, 2) << "what has a sky stays";
    }
}

TEST(EnvironmentCache, KeepsWhatIsMadeOfAPictureAndTurnsItAnew) {
    Context context({.threads = 1});
    CountingPacker packer;
    EnvironmentCache cache;
    Scene scene;
    EXPECT_FALSE(cache.update(scene, packer, false, context));
    scene.environment = Environment{.image = gray(255), .intensity = 0.5f, .rotation_rad = pi / 2};
    const auto used = cache.update(scene, packer, false, context);
    ASSERT_TRUE(used);
    EXPECT_EQ(packer.levels, std::size_t(environment_levels));
    EXPECT_NEAR(used->factors.turn[0][0], 0, 1e-7);
    EXPECT_FLOAT_EQ(used->factors.turn[2][0], 1);
    EXPECT_EQ(used->factors.intensity, 0.5f);
    EXPECT_NEAR(used->factors.irradiance[0][1], 1, 1e-3) << "white all around gives white";
    scene.environment->rotation_rad = 0;
    EXPECT_FLOAT_EQ(cache.update(scene, packer, false, context)->factors.turn[0][0], 1);
    EXPECT_EQ(packer.packed, 1);
    scene.environment->image = gray(128);
    EXPECT_TRUE(cache.update(scene, packer, false, context));
    EXPECT_EQ(packer.packed, 2);
    scene.environment->is_light = scene.environment->is_background = false;
    EXPECT_FALSE(cache.update(scene, packer, false, context));
    scene.environment->is_light = true;
    EXPECT_TRUE(cache.update(scene, packer, false, context));
    EXPECT_EQ(packer.packed, 3) << "it was let go while nobody used it";
}

TEST(EnvironmentCache, WhatCannotBeDecodedOrPackedIsAWarningAndIsLeftOut) {
    Context context({.threads = 1});
    CountingPacker packer;
    EnvironmentCache cache;
    Scene scene;
    auto broken = std::make_shared<EncodedImage>();
    broken->name = "sky.hdr";
    broken->decode = [](const EncodedImage&, Context&) -> Pixels { throw Error(ErrorCode::bad_file, "cut off"); };
    scene.environment = Environment{.image = broken};
    EXPECT_FALSE(cache.update(scene, packer, false, context));
    packer.fails = true;
    scene.environment->image = gray(9);
    EXPECT_FALSE(cache.update(scene, packer, false, context));
    const auto entries = context.report().entries();
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_EQ(entries[0].message, "environment left out: cut off");
    EXPECT_EQ(entries[0].place, "sky.hdr");
    EXPECT_EQ(entries[1].message, "environment left out: too many texels");
    packer.fails = false;
    EXPECT_TRUE(cache.update(scene, packer, false, context)) << "it is tried anew";
}

TEST(EnvironmentCache, ACancelledContextIsNoFaultOfThePicture) {
    Context context({.threads = 1});
    context.cancel();
    EnvironmentCache cache;
    Scene scene;
    scene.environment = Environment{.image = gray(9)};
    EXPECT_THROW(cache.update(scene, CountingPacker(), false, context), Error);
    EXPECT_TRUE(context.report().entries().empty());
}

TEST(EnvironmentLevels, OfTheTextForGlslAreAsManyAsAreMade) {
    std::ifstream file(test::source_dir() / "src/lighting/maps.glsl");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_NE(text.str().find("#define RL_ENVIRONMENT_LEVELS " + std::to_string(environment_levels) + "\n"),
              std::string::npos);
}

}  // namespace
}  // namespace rakelight::shading
