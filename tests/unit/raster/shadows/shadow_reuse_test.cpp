// SPDX-License-Identifier: Apache-2.0
// Shadow maps are kept from picture to picture where they would be the same, and drawn again where they would not.
#include <gtest/gtest.h>

#include <new>

#include "engines/raster/shadows/shadow_maps.h"
#include "shading/lights/lights.h"
#include "unit/raster/shadows/shadow_scenes.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

Scene ball_on_floor(const Light& light) {
    Scene scene;
    scene.materials = {matte()};
    scene.lights = {light};
    add_square(scene, 4, lying());
    add_object(scene, sphere_mesh(16, 32), translation(dvec3{0, 1, 0}));
    return scene;
}

RenderSettings shadowed(int size = 64) {
    return {.width = 64, .height = 48, .shadows = true, .shadow_size = size, .background = {0, 0, 0, 1}};
}

const Camera from_left = looking({-4, 4, 5}, {0, 0.5, 0}), from_right = looking({5, 3, 3}, {0, 0.5, 0});

/// One engine that draws picture after picture.
class Drawing {
public:
    explicit Drawing(const Scene& scene) { take(scene); }
    void take(const Scene& scene) { engine_->prepare(scene, context_); }
    Frame operator()(const Camera& camera, const RenderSettings& settings) {
        Frame frame;
        engine_->render(camera, settings, frame, context_);
        return frame;
    }

private:
    Context context_{{.threads = 2}};
    std::unique_ptr<Engine> engine_ = raster::make_engine();
};

}  // namespace

TEST(ShadowReuse, PicturesOfOneEngineAreThoseOfAnEngineEach) {
    const Scene scene = ball_on_floor(lamp({2, 5, 1}));
    Drawing drawing(scene);
    RenderSettings biased = shadowed(), soft = shadowed(), part = shadowed(), without = shadowed();
    biased.shadow_bias = 9;
    soft.shadow_filter = 4;
    part.window = {10, 7, 30, 20};
    without.shadows = false;
    for (const Camera& camera : {from_left, from_right, from_left})
        for (const RenderSettings& s : {shadowed(), biased, soft, part, shadowed(96), without, shadowed()})
            EXPECT_TRUE(same_bits(drawing(camera, s), draw(scene, camera, s)));
}

TEST(ShadowReuse, ASceneThatWasEditedHasNewMaps) {
    Scene scene = ball_on_floor(lamp({2, 5, 1}));
    Drawing drawing(scene);
    const Frame before = drawing(from_left, shadowed());
    scene.lights[0].position = {-2, 5, 1};
    drawing.take(scene);
    const Frame after = drawing(from_left, shadowed());
    EXPECT_FALSE(same_bits(before, after));
    EXPECT_TRUE(same_bits(after, draw(scene, from_left, shadowed())));
    scene.nodes[1].local.matrix = translation(dvec3{1, 1, 0});
    drawing.take(scene);
    EXPECT_TRUE(same_bits(drawing(from_left, shadowed()), draw(scene, from_left, shadowed())));
}

TEST(ShadowReuse, MapsAreDrawnOnceForAllCamerasAndAgainForAnotherSizeOrFilter) {
    using namespace rakelight::raster;
    Context context({.threads = 1});
    shading::TextureCache textures;
    const DrawList list = cpu_shading::make_draw_list(ball_on_floor(lamp({2, 5, 1})), textures, context);
    ShadowMaps maps;
    const auto drawn_for = [&](dvec3 eye, const RenderSettings& s) {
        const std::uint64_t before = maps.drawn();
        std::vector<lighting::LightParameters> lights = shading::make_lights(list.scene, list.node_to_world, eye);
        maps.update(list, s, *scalar::kernels(), *scalar::geometry_kernels(), eye, lights, context);
        EXPECT_EQ(lights[0].shadow, s.shadows ? 0 : -1);
        return maps.drawn() - before;
    };
    EXPECT_EQ(drawn_for({0, 0, 9}, shadowed()), 6u);  // a point light
    EXPECT_EQ(drawn_for({5, 0, 0}, shadowed()), 0u);
    RenderSettings other = shadowed();
    other.shadow_bias = 3, other.width = 17, other.window = {1, 2, 3, 4};
    EXPECT_EQ(drawn_for({5, 0, 0}, other), 0u);
    other.shadow_filter = 2;
    EXPECT_EQ(drawn_for({5, 0, 0}, other), 6u);
    EXPECT_EQ(drawn_for({5, 0, 0}, shadowed(128)), 6u);
    other.shadows = false;
    EXPECT_EQ(drawn_for({5, 0, 0}, other), 0u);
    EXPECT_EQ(maps.data(), nullptr);
    EXPECT_EQ(drawn_for({5, 0, 0}, shadowed(128)), 6u);
    maps.forget();
    EXPECT_EQ(drawn_for({5, 0, 0}, shadowed(128)), 6u);
}

TEST(ShadowReuse, MapsAreChargedToTheBudgetAsLongAsTheyAreKept) {
    constexpr std::uint64_t a_face = 64 * 64 * 8;
    const Scene scene = ball_on_floor(lamp({2, 5, 1}));
    auto engine = raster::make_engine();
    Frame frame;
    {
        Context context({.threads = 1});
        engine->prepare(scene, context);
        const auto charged_after = [&](const RenderSettings& s) {
            const RenderStats stats = engine->render(from_left, s, frame, context);
            EXPECT_EQ(stats.shadow_maps, s.shadows ? 6u : 0u);
            EXPECT_EQ(stats.shadow_bytes,
                      s.shadows ? std::uint64_t(s.shadow_size) * std::uint64_t(s.shadow_size) * 8 * 6 : 0u);
            return context.memory().charged();
        };
        const std::uint64_t small = charged_after(shadowed());
        EXPECT_EQ(charged_after(shadowed()), small);  // kept, and not charged again
        EXPECT_EQ(charged_after(shadowed(128)), small + 18 * a_face);
        RenderSettings without = shadowed();
        without.shadows = false;
        EXPECT_LE(charged_after(without), small - 6 * a_face);
        EXPECT_EQ(charged_after(shadowed()), small);
        engine->prepare(scene, context);
        EXPECT_EQ(context.memory().charged(), small - 6 * a_face);
        engine->render(from_left, shadowed(), frame, context);
    }
    Context other({.threads = 1});  // the engine outlives the first
    engine->prepare(scene, other);
    EXPECT_LT(other.memory().charged(), a_face);
}

TEST(ShadowReuse, MapsThatTheSceneLeavesNoRoomForAreAUsageError) {
    Context context({.threads = 1, .max_memory = 1'000'000});
    auto engine = raster::make_engine();
    engine->prepare(ball_on_floor(lamp({2, 5, 1})), context);
    RenderSettings without = shadowed();
    without.shadows = false;
    Frame first;
    engine->render(from_left, without, first, context);
    // All but 100,000 bytes of what the picture itself leaves.
    const std::uint64_t of_picture = context.memory().charged();
    const MemoryCharge scene(context.memory(), 900'000 - of_picture, "the scene");
    Frame frame;
    try {
        engine->render(from_left, shadowed(), frame, context);  // 196 608 bytes: less than half of it
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::usage);
        EXPECT_NE(std::string(e.what()).find("need 196608 bytes, more than 100000"), std::string::npos) << e.what();
    }
    EXPECT_LE(context.memory().charged(), 900'000u);
}

TEST(ShadowReuse, AfterACancelledPictureTheMapsAreWhole) {
    using namespace rakelight::raster;
    const Scene scene = ball_on_floor(lamp({2, 5, 1}));
    Context context({.threads = 1}), cancelled({.threads = 1});
    cancelled.cancel();
    auto engine = make_engine();
    engine->prepare(scene, context);
    Frame frame;
    EXPECT_THROW(engine->render(from_left, shadowed(), frame, cancelled), Error);
    engine->render(from_left, shadowed(), frame, context);
    EXPECT_TRUE(same_bits(frame, draw(scene, from_left, shadowed())));
}

TEST(ShadowReuse, ASceneThatCouldNotBePreparedLeavesNoMapsOfTheOneBefore) {
    const Scene scene = ball_on_floor(lamp({2, 5, 1}));
    Scene dark = scene;
    dark.lights.clear();
    auto image = std::make_shared<EncodedImage>();
    image->decode = [](const EncodedImage&, Context&) -> Pixels { throw std::bad_alloc(); };
    Scene failing = dark;
    failing.environment.emplace();
    failing.environment->image = image;
    Drawing drawing(scene);
    drawing(from_left, shadowed());  // with maps of a light that the next scene lacks
    EXPECT_THROW(drawing.take(failing), std::bad_alloc);
    EXPECT_TRUE(same_bits(drawing(from_left, shadowed()), draw(dark, from_left, shadowed())));
}
