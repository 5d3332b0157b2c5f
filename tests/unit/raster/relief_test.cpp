// SPDX-License-Identifier: Apache-2.0
// Height and normal maps through the engine: what a square of the plane z = 0, two metres wide, shows of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "engines/raster/inspection.h"
#include "math/isa.h"
#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int size = 128;

/// A picture of linear floats, value(u, v) at the texels' centers; u and v 0..1, v down.
template <class Value>
Pixels field(int texels, const Value& value) {
    Pixels p;
    p.width = p.height = texels;
    p.channels = 3;
    p.component = Component::f32;
    p.is_linear = true;
    for (int y = 0; y < texels; ++y)
        for (int x = 0; x < texels; ++x) {
            const vec3 v = value((float(x) + 0.5f) / float(texels), (float(y) + 0.5f) / float(texels));
            const auto* const bytes = reinterpret_cast<const std::byte*>(&v);
            p.bytes.insert(p.bytes.end(), bytes, bytes + sizeof v);
        }
    return p;
}
Pixels constant(float h) {
    return field(4, [h](float, float) { return vec3{h, h, h}; });
}
Pixels ramp_along_u() {
    return field(64, [](float u, float) { return vec3{u, u, u}; });
}
Pixels ramp_along_v() {
    return field(64, [](float, float v) { return vec3{v, v, v}; });
}
Pixels step_at_middle() {
    return field(256, [](float u, float) { return u < 0.5f ? vec3{0.2f, 0.2f, 0.2f} : vec3{0.8f, 0.8f, 0.8f}; });
}
/// u in red, v in green.
Pixels coordinates() {
    return field(64, [](float u, float v) { return vec3{u, v, 0.5f}; });
}
/// Waves in both directions, as heights.
Pixels waves() {
    return field(128, [](float u, float v) {
        const float a = std::fabs(u * 6 - std::floor(u * 6) - 0.5f) * 2,
                    b = std::fabs(v * 6 - std::floor(v * 6) - 0.5f) * 2;
        const float h = 0.1f + 0.8f * a * (1 - a) * 4 * b;
        return vec3{h, h, h};
    });
}
/// Codes of a tangent-space normal map, green up: tilts that change over the square.
Pixels normal_codes(bool green_down = false) {
    return rgb_pixels(64, 64, [green_down](int x, int y) {
        const int g = 90 + 70 * (y % 16) / 15;
        return std::array<int, 3>{80 + 100 * (x % 16) / 15, green_down ? 255 - g : g, 230};
    });
}

constexpr Sampler one_level{.wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge, .mip = MipFilter::none};

struct Wanted {
    Bump bump = Bump::height;
    Relief relief{.depth = 0.1f};
};

Scene square_with(const Pixels& heights, double z = 0) {
    Scene scene;
    Material m = matte();
    m.double_sided = true;
    m.base_color_texture = add_texture(scene, picture(coordinates()), one_level);
    m.height_texture = add_texture(scene, picture(heights), one_level);
    scene.materials = {m};
    add_object(scene, square_mesh(0), translation(dvec3{0, 0, z}));
    scene.lights = {directional({0, 0, -1})};
    return scene;
}

Camera looking_from(dvec3 eye) {
    Camera camera;
    camera.vertical_fov_rad = 0.6;
    camera.near = 0.1;
    camera.far = 100;
    camera.to_world = look_at(eye, dvec3{0, 0, 0}, dvec3{0, 1, 0});
    return camera;
}

RenderSettings settings_of(const Wanted& wanted, Shading shading = Shading::phong) {
    RenderSettings s{.width = size, .height = size, .channels = channel_normal | channel_object, .shading = shading};
    s.bump = wanted.bump;
    s.relief = wanted.relief;
    return s;
}

/// Own colors: where the base color map is read.
Frame show(const Scene& scene, const Wanted& wanted, const Camera& camera) {
    return draw(scene, camera, settings_of(wanted, Shading::unlit));
}

vec3 normal_of(const Scene& scene, const Wanted& wanted, const Camera& camera = flat_camera()) {
    const Frame f = draw(scene, camera, settings_of(wanted));
    return f.normal[std::size_t(size / 2 * size + size / 2)];
}

void expect_near(vec3 got, vec3 expected, float tolerance) {
    EXPECT_NEAR(got.x, expected.x, tolerance);
    EXPECT_NEAR(got.y, expected.y, tolerance);
    EXPECT_NEAR(got.z, expected.z, tolerance);
}

double difference(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum += std::fabs(double(a.color[i][c]) - double(b.color[i][c]));
    return sum / double(3 * a.color.size());
}
double largest_difference(const Frame& a, const Frame& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::fabs(double(a.color[i][c]) - double(b.color[i][c])));
    return most;
}

/// A quarter of a tube of few faces about +Y, its tangents leaning by `skew` on the normals.
Scene bent_scene(double skew) {
    Scene scene;
    Material m = matte({0.8f, 0.8f, 0.8f});
    m.classical.specular = {0.5f, 0.5f, 0.5f};
    m.classical.shininess = 12;
    m.normal_texture = add_texture(scene, picture(normal_codes()));
    scene.materials = {m};
    Mesh mesh;
    std::vector<vec3> positions, normals;
    std::vector<vec4> tangents;
    std::vector<vec2> uv;
    std::vector<std::uint32_t> indices;
    constexpr std::uint32_t columns = 4;
    for (std::uint32_t i = 0; i <= columns; ++i)
        for (std::uint32_t j = 0; j < 2; ++j) {
            const double x = -0.8 + 1.6 * i / columns, z = std::sqrt(1 - x * x);
            positions.push_back({float(x), j == 0 ? -0.8f : 0.8f, float(z - 0.8)});
            normals.push_back({float(x), 0, float(z)});
            const dvec3 t = normalize_or(dvec3{z + skew * x, 0, -x + skew * z}, dvec3{1, 0, 0});
            tangents.push_back({float(t.x), float(t.y), float(t.z), 1});
            uv.push_back({float(i) / columns, j == 0 ? 1.0f : 0.0f});
        }
    for (std::uint32_t i = 0; i < columns; ++i)
        for (const std::uint32_t k : {0u, 2u, 3u, 0u, 3u, 1u}) indices.push_back(2 * i + k);
    mesh.positions = positions, mesh.normals = normals, mesh.tangents = tangents;
    mesh.texcoords.emplace_back(uv);
    mesh.indices = indices;
    mesh.material = 0;
    add_object(scene, mesh);
    Light light;
    light.type = LightType::point;
    light.position = {0.7, 0.9, 1.2};
    scene.lights = {light, directional({0.3, -0.5, -1}, {0.4f, 0.4f, 0.4f})};
    return scene;
}

Frame bent(TangentSpace space, double skew, bool orthogonalize, bool normalize = true) {
    RenderSettings s{.width = size, .height = size};
    s.bump = Bump::normal;
    s.tangent_space = space;
    s.orthogonalize = orthogonalize;
    s.normalize_frames = normalize;
    return draw(bent_scene(skew), looking_from({0.5, 0.4, 3.2}), s);
}

}  // namespace

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
    // Turned by a quarter, what rose along u rises along v.
    scene.materials[0].height_texture.transform = {{0, 1}, {1, 1}, float(pi / 2)};
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
    const Scene scene = square_with(waves());
    const Frame plain = draw(scene, camera, settings_of({Bump::none}));
    for (const Bump bump : {Bump::height, Bump::parallax, Bump::parallax_limited, Bump::steep, Bump::occlusion})
        EXPECT_EQ(draw(scene, camera, settings_of({bump})).object, plain.object);
    const Frame limited =
        draw(scene, camera, settings_of({Bump::occlusion, {.depth = 0.1f, .limit_silhouette = true}}));
    std::size_t gone = 0, grown = 0;
    for (std::size_t i = 0; i < plain.object.size(); ++i) {
        gone += plain.object[i] != none && limited.object[i] == none;
        grown += plain.object[i] == none && limited.object[i] != none;
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
    scene.materials[0].bump = Bump::none;  // the material's own choice goes first
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

TEST(ReliefEngine, GreenDownMapsAreFlipped) {
    Scene up = square_with(constant(0)), down = up;
    up.materials[0].normal_texture = add_texture(up, picture(normal_codes(false)));
    down.materials[0].normal_texture = add_texture(down, picture(normal_codes(true)));
    down.materials[0].green_down = true;
    const Frame a = draw(up, flat_camera(), settings_of({Bump::normal})),
                b = draw(down, flat_camera(), settings_of({Bump::normal}));
    for (std::size_t i = 0; i < a.normal.size(); ++i) expect_near(a.normal[i], b.normal[i], 2e-5f);
}

TEST(ReliefEngine, CenteredDecodingTakes128AsZero) {
    Scene scene = square_with(constant(0));
    scene.materials[0].normal_texture = add_texture(scene, picture(rgb_pixels(2, 2, [](int, int) {
                                                        return std::array<int, 3>{128, 128, 255};
                                                    })));
    EXPECT_GT(normal_of(scene, {Bump::normal}).x, 0.003f);
    scene.materials[0].centered_normals = true;
    expect_near(normal_of(scene, {Bump::normal}), {0, 0, 1}, 3e-5f);
}

TEST(ReliefEngine, BumpTermsAskedForActAlone) {
    Scene scene = bent_scene(0);
    const auto shown = [&](BumpTerms terms, Bump bump, vec3 diffuse, vec3 specular) {
        Scene s = scene;
        s.materials[0].base_color = {diffuse.x, diffuse.y, diffuse.z, 1};
        s.materials[0].classical.specular = specular;
        RenderSettings settings = settings_of({bump});
        settings.bump_terms = terms;
        return draw(s, looking_from({0.5, 0.4, 3.2}), settings);
    };
    const vec3 white{1, 1, 1}, black{0, 0, 0};
    for (const bool specular : {false, true}) {
        const vec3 kd = specular ? black : white, ks = specular ? white : black;
        const BumpTerms same = specular ? BumpTerms::specular : BumpTerms::diffuse;
        const BumpTerms other = specular ? BumpTerms::diffuse : BumpTerms::specular;
        EXPECT_LT(largest_difference(shown(same, Bump::normal, kd, ks), shown(BumpTerms::both, Bump::normal, kd, ks)),
                  1e-6);
        EXPECT_LT(largest_difference(shown(other, Bump::normal, kd, ks), shown(BumpTerms::both, Bump::none, kd, ks)),
                  1e-6);
        EXPECT_GT(difference(shown(same, Bump::normal, kd, ks), shown(BumpTerms::both, Bump::none, kd, ks)), 1e-3);
    }
}

TEST(TangentSpaceLighting, PerPixelIsThePictureOfTheWorld) {
    EXPECT_LT(largest_difference(bent(TangentSpace::pixel, 0, true), bent(TangentSpace::world, 0, true)), 5e-6);
    EXPECT_LT(largest_difference(bent(TangentSpace::pixel, 0.5, true), bent(TangentSpace::world, 0.5, true)), 5e-6);
}

TEST(TangentSpaceLighting, PerVertexDiffersOnBentSurfacesAndNotOnFlatOnes) {
    EXPECT_GT(difference(bent(TangentSpace::vertex, 0, true), bent(TangentSpace::world, 0, true)), 1e-3);
    Scene flat = square_with(constant(0));
    flat.materials[0].normal_texture = add_texture(flat, picture(normal_codes()));
    RenderSettings s = settings_of({Bump::normal});
    const Frame world = draw(flat, looking_from({0.3, 0.4, 3}), s);
    s.tangent_space = TangentSpace::vertex;
    EXPECT_LT(largest_difference(draw(flat, looking_from({0.3, 0.4, 3}), s), world), 1e-5);
}

TEST(TangentSpaceLighting, TheTransposedIsTheInverseOfOrthonormalFramesOnly) {
    EXPECT_LT(largest_difference(bent(TangentSpace::transposed, 0.5, true), bent(TangentSpace::vertex, 0.5, true)),
              5e-6);
    EXPECT_GT(difference(bent(TangentSpace::transposed, 0.5, false), bent(TangentSpace::vertex, 0.5, false)), 1e-3);
}

TEST(TangentSpaceLighting, UnnormalizedFramesAreInterpolatedAsMikkTSpaceBakesExpect) {
    // Between two vertices whose normals and tangents are 2 a apart in angle, both are shorter by cos a: the same
    // factor for n and t, and its square for cross(n, t).
    const Frame unit = bent(TangentSpace::world, 0, true), raw = bent(TangentSpace::world, 0, true, false);
    EXPECT_GT(difference(unit, raw), 1e-5);
    EXPECT_LT(difference(unit, raw), 1e-2);
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

TEST(NormalMapRemarks, AHeightMapThatIsANormalMapIsNamed) {
    const auto remarks = [](const Pixels& heights) {
        Context context({.threads = 1});
        raster::make_engine()->prepare(square_with(heights), context);
        return context.report().entries();
    };
    const auto as_normals = remarks(rgb_pixels(16, 16, [](int x, int) {
        return x % 2 == 0 ? std::array<int, 3>{160, 128, 251} : std::array<int, 3>{96, 128, 251};
    }));
    ASSERT_EQ(as_normals.size(), 1u);
    EXPECT_EQ(as_normals[0].message, "the height map looks like a normal map; --texture-normal takes it as one");
    EXPECT_TRUE(remarks(rgb_pixels(16, 16, [](int x, int) {
                    return std::array<int, 3>{16 * x, 16 * x, 16 * x};
                })).empty());
}

TEST(NormalMapRemarks, SuspiciousMapsAreNamedOnce) {
    const auto remarks = [](const Pixels& pixels, bool green_down) {
        Scene scene = square_with(constant(0));
        scene.materials[0].normal_texture = add_texture(scene, picture(pixels));
        scene.materials[0].green_down = green_down;
        Context context({.threads = 1});
        raster::make_engine()->prepare(scene, context);
        std::string all;
        for (const ReportEntry& e : context.report().entries()) all += name_of(e.remark) + (": " + e.message) + "\n";
        return all;
    };
    // Slopes p(x + y), q(x + y): the same mixed derivative, with one sign or the other.
    const auto slanted = [](int sign) {
        return rgb_pixels(64, 64, [sign](int x, int y) {
            const int lean = 20 * (((x + y) / 4) % 4);
            return std::array<int, 3>{100 + lean, 128 + sign * (lean - 28), 230};
        });
    };
    EXPECT_EQ(remarks(slanted(-1), false), "");
    EXPECT_EQ(remarks(slanted(1), false),
              "warning: the normal map looks green-down; --normal-map-green down turns it\n");
    EXPECT_EQ(remarks(slanted(1), true), "");
    const Pixels below = rgb_pixels(16, 16, [](int x, int) {
        return std::array<int, 3>{128, 128, x == 0 ? 100 : 255};
    });
    EXPECT_EQ(remarks(below, false),
              "warning: 16 of 256 texels of the normal map (6.2 %) point into the surface: blue is below one half\n");
    Pixels tagged = slanted(-1);
    tagged.is_tagged_srgb = true;
    EXPECT_EQ(remarks(tagged, false),
              "note: the normal map is tagged sRGB; it is read as plain numbers, as all normal maps are\n");
}
