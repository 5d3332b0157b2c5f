// SPDX-License-Identifier: Apache-2.0
// Height and normal maps through the engine: what a square of the plane z = 0, two meters wide, shows of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "engines/raster/inspect/inspection.h"
#include "math/isa.h"
#include "unit/raster/shade/relief_scenes.h"

using namespace rakelight;
using namespace rakelight::test;

TEST(ReliefEngine, AConstantDepthShowsThePlaneThatLiesThatDeep) {
    // One width is 2 m: a tenth of it sinks the plane by 0.2 m.
    const Camera camera = looking_from({1.1, 0.7, 2});
    const Frame sunk = show(square_with(constant(0), -0.2), {Bump::none}, camera);
    for (const Bump bump : {Bump::parallax, Bump::steep, Bump::occlusion}) {
        const Frame got = show(square_with(constant(0)), {bump}, camera);
        int compared = 0;
        for (std::size_t i = 0; i < got.color.size(); ++i) {
            const vec4 a = got.color[i], b = sunk.color[i];
            const auto is_inside = [](float x) { return x > 0.05f && x < 0.95f; };
            if (!is_inside(a.x) || !is_inside(a.y) || !is_inside(b.x) || !is_inside(b.y)) continue;
            ++compared;
            ASSERT_NEAR(a.x, b.x, 2e-4f);
            ASSERT_NEAR(a.y, b.y, 2e-4f);
        }
        EXPECT_GT(compared, size * size / 10);
    }
}

TEST(ReliefEngine, ABiasLiftsTheReliefAndDepthMapsAreReadTheOtherWayRound) {
    const Camera camera = looking_from({1.1, 0.7, 2});
    const Frame raised = show(square_with(constant(1), 0.1), {Bump::none}, camera);
    const Frame biased = show(square_with(constant(1)), {Bump::occlusion, {.depth = 0.1f, .bias = 0.5f}}, camera);
    const Frame depths =
        show(square_with(constant(0)), {Bump::occlusion, {.depth = 0.1f, .bias = 0.5f, .holds_depth = true}}, camera);
    const std::size_t middle = size / 2 * size + size / 2;
    EXPECT_NEAR(biased.color[middle].x, raised.color[middle].x, 2e-4f);
    EXPECT_NEAR(biased.color[middle].y, raised.color[middle].y, 2e-4f);
    EXPECT_TRUE(same_bits(depths, biased));
}

TEST(ReliefEngine, AHeightBumpHasTheNormalsOfItsSlopes) {
    const float length = std::sqrt(1.01f);
    expect_near(normal_of(square_with(ramp_along_u()), {}), {-0.1f / length, 0, 1 / length}, 2e-5f);
    expect_near(normal_of(square_with(ramp_along_v()), {}), {0, 0.1f / length, 1 / length}, 2e-5f);  // v counts down
    expect_near(normal_of(square_with(constant(0.3f)), {}), {0, 0, 1}, 0);
}

TEST(ReliefEngine, ARepeatedTextureIsLessDeepAndKeepsItsSlopes) {
    Scene scene = square_with(ramp_along_u());
    scene.materials[0].height_texture.transform.scale = {4, 4};
    scene.materials[0].height_texture.transform.offset = {-1.6f, -1.4f};
    const float length = std::sqrt(1.01f);
    expect_near(normal_of(scene, {}), {-0.1f / length, 0, 1 / length}, 5e-5f);
    // Turned by a quarter, what rose along u rises along v: u' = v, so tangents of these coordinates point to greater v.
    scene.materials[0].height_texture.transform = {{0, 1}, {1, 1}, float(pi / 2)};
    scene.meshes[0].tangents = std::vector<vec4>(scene.meshes[0].positions.size(), vec4{0, -1, 0, 1});
    const vec3 turned = normal_of(scene, {});
    EXPECT_NEAR(turned.x, 0, 1e-5f);
    EXPECT_NEAR(std::fabs(turned.y), 0.1f / length, 2e-5f);
}

TEST(ReliefEngine, FromBehindABumpIsADent) {
    const Scene scene = square_with(ramp_along_u());
    const vec3 front = normal_of(scene, {}, looking_from({0, 0, 4})),
               back = normal_of(scene, {}, looking_from({0, 0, -4}));
    expect_near(back, front * -1.0f, 1e-5f);
}

TEST(ReliefEngine, OutlinesStayThoseOfTheMeshUnlessTheyAreToBeLimited) {
    const Camera camera = looking_from({1.6, 0.4, 1});
    Scene scene = square_with(waves());
    scene.materials[0].normal_texture = add_texture(scene, picture(normal_codes()));
    const Frame plain = draw(scene, camera, settings_of({Bump::none}));
    for (const Bump bump :
         {Bump::height, Bump::normal, Bump::parallax, Bump::parallax_limited, Bump::steep, Bump::occlusion}) {
        const Frame bumpy = draw(scene, camera, settings_of({bump}));
        EXPECT_EQ(bumpy.object, plain.object);
        EXPECT_FALSE(same_bits(bumpy, plain)) << "nothing was bumped";
    }
    const Frame limited =
        draw(scene, camera, settings_of({Bump::occlusion, {.depth = 0.1f, .limit_silhouette = true}}));
    std::size_t gone = 0, grown = 0;
    for (std::size_t i = 0; i < plain.object.size(); ++i) {
        gone += plain.object[i] != no_index && limited.object[i] == no_index;
        grown += plain.object[i] == no_index && limited.object[i] != no_index;
    }
    EXPECT_EQ(grown, 0u);
    EXPECT_GT(gone, 50u);
}

TEST(ReliefEngine, WhatALimitedReliefLeavesOpenShowsWhatIsBehind) {
    const Camera camera = looking_from({1.6, 0.4, 1});
    Scene scene = square_with(constant(0));
    Material red = matte({1, 0, 0});
    red.double_sided = true;
    scene.materials.push_back(red);
    add_object(scene, square_mesh(1, 4), translation(dvec3{0, 0, -1}));
    const Frame f = draw(scene, camera, settings_of({Bump::steep, {.depth = 0.1f, .limit_silhouette = true}}));
    const Frame whole = draw(scene, camera, settings_of({Bump::steep}));
    std::size_t behind = 0;
    for (std::size_t i = 0; i < f.object.size(); ++i) behind += whole.object[i] == 0 && f.object[i] == 1;
    EXPECT_GT(behind, 50u);
}

TEST(ReliefEngine, AStepThrowsItsShadowAsFarAsItIsHigh) {
    Scene scene = square_with(step_at_middle());
    scene.materials[0].base_color_texture = {};
    // The step is 0.6 of 0.2 m; light comes from its side at 45 degrees, so the shadow is 0.12 m = 0.06 widths long.
    scene.lights = {directional({-1, 0, -1})};
    const auto row = [&](bool self_shadow) {
        const Relief relief{.depth = 0.1f, .min_steps = 64, .max_steps = 64, .self_shadow = self_shadow};
        return draw(scene, flat_camera(), settings_of({Bump::occlusion, relief}));
    };
    const Frame lit = row(false), shadowed = row(true);
    for (int x = 0; x < size; ++x) {
        const double u = (x + 0.5) / size;
        const float a = pixel(lit, x, size / 2).x, b = pixel(shadowed, x, size / 2).x;
        if (u > 0.45 && u < 0.49) {
            EXPECT_EQ(b, 0) << u;
        } else if (u < 0.43 || u > 0.51) {
            EXPECT_EQ(a, b) << u;
        }
    }
}

TEST(ReliefEngine, TheOtherSetOfTextureCoordinatesMovesAlong) {
    Scene scene = square_with(constant(0));
    Mesh mesh = square_mesh(0);
    std::vector<vec2> twice;
    for (const vec2 uv : mesh.texcoords[0]) twice.push_back({2 * uv.y - 0.5f, 2 * uv.x - 0.5f});
    mesh.texcoords.emplace_back(twice);
    scene.meshes[0] = mesh;
    const Camera camera = looking_from({1.1, 0.7, 2});
    const Frame first = show(scene, {Bump::parallax}, camera);
    scene.materials[0].base_color_texture.texcoord_set = 1;
    const Frame second = show(scene, {Bump::parallax}, camera);
    const std::size_t middle = size / 2 * size + size / 2;
    EXPECT_NEAR(second.color[middle].x, 2 * first.color[middle].y - 0.5f, 1e-3f);
    EXPECT_NEAR(second.color[middle].y, 2 * first.color[middle].x - 0.5f, 1e-3f);
}

TEST(ReliefEngine, AutomaticTakesTheNormalMapElseTheHeightMap) {
    Scene scene = square_with(waves());
    const Camera camera = looking_from({1.1, 0.7, 2});
    const auto drawn = [&](Bump bump) { return draw(scene, camera, settings_of({bump})); };
    EXPECT_TRUE(same_bits(drawn(Bump::automatic), drawn(Bump::height)));
    EXPECT_FALSE(same_bits(drawn(Bump::automatic), drawn(Bump::none)));
    scene.materials[0].normal_texture = add_texture(scene, picture(normal_codes()));
    EXPECT_TRUE(same_bits(drawn(Bump::automatic), drawn(Bump::normal)));
    EXPECT_FALSE(same_bits(drawn(Bump::automatic), drawn(Bump::height)));
    EXPECT_TRUE(same_bits(drawn(Bump::displacement), drawn(Bump::none)));  // the bumps are in the triangles
    scene.materials[0].bump = Bump::none;                                  // the material's own choice goes first
    EXPECT_TRUE(same_bits(drawn(Bump::steep), drawn(Bump::none)));
}

TEST(ReliefEngine, NoMapActsOnAMeshWithoutTextureCoordinates) {
    Scene scene = square_with(waves());
    scene.materials[0].base_color_texture = {};
    const Camera camera = looking_from({1.1, 0.7, 2});
    const auto expect_plain = [&] {
        const Frame plain = draw(scene, camera, settings_of({Bump::none}));
        for (const Bump bump : {Bump::automatic, Bump::height, Bump::normal, Bump::parallax, Bump::parallax_limited,
                                Bump::steep, Bump::occlusion}) {
            const Wanted wanted{bump, {.depth = 0.1f, .self_shadow = true, .limit_silhouette = true}};
            EXPECT_TRUE(same_bits(draw(scene, camera, settings_of(wanted)), plain)) << int(bump);
        }
    };
    scene.meshes[0].texcoords.clear();
    expect_plain();
    scene.materials[0].normal_texture = add_texture(scene, picture(normal_codes()));
    expect_plain();
    scene.meshes[0] = square_mesh(0);
    scene.materials[0].normal_texture.texcoord_set = scene.materials[0].height_texture.texcoord_set = 1;
    expect_plain();
}

TEST(ReliefEngine, LightsThatCastNoShadowPassReliefs) {
    Scene scene = square_with(waves());
    scene.lights = {directional({-1, -0.4, -0.5})};
    const Camera camera = looking_from({0.3, 0.4, 3});
    const Wanted open{Bump::occlusion, {.depth = 0.2f}},
        shadowed{Bump::occlusion, {.depth = 0.2f, .self_shadow = true}};
    const Frame without = draw(scene, camera, settings_of(open));
    EXPECT_GT(difference(draw(scene, camera, settings_of(shadowed)), without), 1e-3);
    const auto seen = [&](int x) {
        Context context({.threads = 1});
        const raster::Inspection inspection(scene, camera, settings_of(shadowed), context);
        const raster::PixelExplanation e = inspection.explain(x, size / 2, context);
        return e.layers.at(0).lights.at(0).seen;
    };
    const auto least_seen = [&] {
        float least = 1;
        for (int x = size / 4; x < 3 * size / 4; ++x) least = std::min(least, seen(x));
        return least;
    };
    EXPECT_LT(least_seen(), 0.5f);
    scene.lights[0].casts_shadow = false;
    EXPECT_TRUE(same_bits(draw(scene, camera, settings_of(shadowed)), without));
    EXPECT_EQ(least_seen(), 1.0f);
}

TEST(ReliefEngine, EveryInstructionSetAndNumberOfThreadsGivesTheSameBits) {
    Scene scene = square_with(waves());
    scene.materials[0].normal_texture = add_texture(scene, picture(normal_codes()));
    scene.lights = {directional({-1, -0.4, -0.7})};
    const Camera camera = looking_from({1.6, 0.4, 1});
    for (const Bump bump : {Bump::height, Bump::parallax_limited, Bump::steep, Bump::occlusion})
        for (const TangentSpace space : {TangentSpace::world, TangentSpace::vertex}) {
            RenderSettings s = settings_of({bump, {.depth = 0.1f, .self_shadow = true, .limit_silhouette = true}});
            s.tangent_space = space;
            s.anisotropy = bump == Bump::height ? 8 : 1;
            const auto with = [&](Isa isa, int threads) {
                setenv("RAKELIGHT_ISA", name(isa), 1);
                Frame f = draw(scene, camera, s, threads);
                unsetenv("RAKELIGHT_ISA");
                return f;
            };
            const Frame scalar = with(Isa::scalar, 1);
            for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512})
                EXPECT_TRUE(!is_available(isa) || same_bits(with(isa, 2), scalar)) << name(isa);
        }
}
