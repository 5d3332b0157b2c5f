// SPDX-License-Identifier: Apache-2.0
// Normal maps through the engine: how they are decoded, which light they act on, in which space they are lit.
#include <gtest/gtest.h>

#include <cmath>

#include "math/isa.h"
#include "math/linear.h"
#include "unit/raster/shade/relief_scenes.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

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

/// The shading normal in the middle of a square whose normals and tangents turn by 2 a from its left to its right side.
vec3 normal_between(float a, bool normalize, vec3 mapped) {
    Scene scene = square_with(constant(0));
    const auto code = [](float m) { return int(std::lround((m + 1) * 127.5f)); };
    scene.materials[0].normal_texture =
        add_texture(scene, picture(rgb_pixels(2, 2, [&](int, int) {
                        return std::array<int, 3>{code(mapped.x), code(mapped.y), code(mapped.z)};
                    })));
    Mesh& mesh = scene.meshes[0];
    const vec3 left{-std::sin(a), 0, std::cos(a)}, right{std::sin(a), 0, std::cos(a)};
    const vec4 left_t{std::cos(a), 0, std::sin(a), 1}, right_t{std::cos(a), 0, -std::sin(a), 1};
    mesh.normals = std::vector<vec3>{left, right, right, left};
    mesh.tangents = std::vector<vec4>{left_t, right_t, right_t, left_t};
    RenderSettings s = settings_of({Bump::normal});
    s.orthogonalize = normalize;
    s.normalize_frames = normalize;
    const Frame f = draw(scene, flat_camera(), s);
    return f.normal[std::size_t(size / 2 * size + size / 2)];
}

}  // namespace

TEST(NormalMaps, GreenDownMapsAreFlipped) {
    Scene up = square_with(constant(0)), down = up;
    up.materials[0].normal_texture = add_texture(up, picture(normal_codes(false)));
    down.materials[0].normal_texture = add_texture(down, picture(normal_codes(true)));
    down.materials[0].green_down = true;
    const Frame a = draw(up, flat_camera(), settings_of({Bump::normal})),
                b = draw(down, flat_camera(), settings_of({Bump::normal}));
    for (std::size_t i = 0; i < a.normal.size(); ++i) expect_near(a.normal[i], b.normal[i], 2e-5f);
}

TEST(NormalMaps, CenteredDecodingTakes128AsZero) {
    Scene scene = square_with(constant(0));
    scene.materials[0].normal_texture = add_texture(scene, picture(rgb_pixels(2, 2, [](int, int) {
                                                        return std::array<int, 3>{128, 128, 255};
                                                    })));
    EXPECT_GT(normal_of(scene, {Bump::normal}).x, 0.003f);
    scene.materials[0].centered_normals = true;
    expect_near(normal_of(scene, {Bump::normal}), {0, 0, 1}, 3e-5f);
}

TEST(NormalMaps, BumpTermsAskedForActAlone) {
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

/// A map acts in (tangent, bitangent, normal) as they are: with a bitangent of its own that leans by `lean` on the tangent.
TEST(NormalMaps, ActAlongABitangentOfItsOwn) {
    const vec3 mapped{0.3f, 0.5f, 0.8f};
    const auto code = [](float m) { return int(std::lround((m + 1) * 127.5f)); };
    const auto of_code = [&](float m) { return double(code(m)) / 127.5 - 1; };
    for (const double lean : {0.0, 0.4, -0.7}) {
        Scene scene = square_with(constant(0));
        scene.materials[0].normal_texture =
            add_texture(scene, picture(rgb_pixels(2, 2, [&](int, int) {
                            return std::array<int, 3>{code(mapped.x), code(mapped.y), code(mapped.z)};
                        })));
        const vec3 crossed = normal_of(scene, {Bump::normal});
        const dvec3 b = {std::sin(lean), std::cos(lean), 0};
        scene.meshes[0].bitangents = std::vector<vec3>(4, cast<float>(b));
        const vec3 seen = normal_of(scene, {Bump::normal});
        const dvec3 sum =
            dvec3{1, 0, 0} * of_code(mapped.x) + b * of_code(mapped.y) + dvec3{0, 0, 1} * of_code(mapped.z);
        expect_near(seen, cast<float>(normalize_or(sum, dvec3{})), 3e-5f);
        // What the orthogonal frame makes of it differs by m_y (b - cross(n, t)), before both are made unit.
        const dvec3 other = sum - (b - dvec3{0, 1, 0}) * of_code(mapped.y);
        expect_near(crossed, cast<float>(normalize_or(other, dvec3{})), 3e-5f);
        if (lean != 0) {
            EXPECT_GT(std::fabs(double(seen.x) - double(crossed.x)), 0.1);
        }
    }
}

TEST(NormalMaps, BitangentsOfTheirOwnGiveTheSameBitsInEveryInstructionSet) {
    Scene scene = bent_scene(0.3);
    std::vector<vec3> bitangents;
    for (std::size_t v = 0; v < scene.meshes[0].positions.size(); ++v)
        bitangents.push_back(cast<float>(normalize_or(dvec3{0.1 * double(v), 1, -0.05 * double(v)}, dvec3{})));
    scene.meshes[0].bitangents = bitangents;
    for (const TangentSpace space : {TangentSpace::world, TangentSpace::pixel, TangentSpace::vertex}) {
        RenderSettings s{.width = size, .height = size};
        s.bump = Bump::normal, s.tangent_space = space;
        setenv("RAKELIGHT_ISA", "scalar", 1);
        const Frame expected = draw(scene, looking_from({0.5, 0.4, 3.2}), s);
        for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512}) {
            if (!is_available(isa)) continue;
            setenv("RAKELIGHT_ISA", name(isa), 1);
            EXPECT_TRUE(same_bits(expected, draw(scene, looking_from({0.5, 0.4, 3.2}), s, 3))) << name(isa);
        }
        unsetenv("RAKELIGHT_ISA");
    }
}

TEST(TangentSpaceLighting, PerPixelIsThePictureOfTheWorld) {
    EXPECT_LT(largest_difference(bent(TangentSpace::pixel, 0, true), bent(TangentSpace::world, 0, true)), 5e-6);
    EXPECT_LT(largest_difference(bent(TangentSpace::pixel, 0.5, true), bent(TangentSpace::world, 0.5, true)), 5e-6);
}

TEST(TangentSpaceLighting, PerPixelIsAnotherPictureWhereFramesAreSkewed) {
    // The inverse of a frame that is not orthonormal keeps no angles, which `world` needs.
    EXPECT_GT(difference(bent(TangentSpace::pixel, 0.5, false), bent(TangentSpace::world, 0.5, false)), 1e-3);
    EXPECT_LT(largest_difference(bent(TangentSpace::pixel, 0, false), bent(TangentSpace::world, 0, false)), 5e-6);
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
    // In the middle n and t are shorter by c = cos a, cross(n, t) by c^2: the sum is (c mx, c^2 my, c mz).
    constexpr float a = 0.6f;
    const vec3 m{-0.4f, 0.6f, 0.8f};
    const auto decoded = [](float v) { return float(std::lround((v + 1) * 127.5f)) / 127.5f - 1; };
    const dvec3 d{decoded(m.x), decoded(m.y), decoded(m.z)};
    const dvec3 raw = normalize_or(dvec3{d.x, d.y * std::cos(a), d.z}, {}), unit = normalize_or(d, {});
    expect_near(normal_between(a, false, m), {float(raw.x), float(raw.y), float(raw.z)}, 6e-3f);
    expect_near(normal_between(a, true, m), {float(unit.x), float(unit.y), float(unit.z)}, 6e-3f);
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
    EXPECT_EQ(as_normals[0].message, "the height map looks like a normal map; 'texture-normal' takes it as one");
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
              "warning: the normal map looks green-down; 'normal-map-green' down turns it\n");
    EXPECT_EQ(remarks(slanted(1), true), "");
    const Pixels below = rgb_pixels(16, 16, [](int x, int) {
        return std::array<int, 3>{128, 128, x == 0 ? 100 : 255};
    });
    EXPECT_EQ(remarks(below, false),
              "warning: 16 of 256 texels of the normal map (6.2 %) point into the surface: blue is below one half\n");
    const Pixels heights = rgb_pixels(16, 16, [](int x, int) { return std::array<int, 3>{9 * x, 9 * x, 9 * x}; });
    EXPECT_EQ(remarks(heights, false),  // and not that most of it points into the surface
              "warning: the normal map looks like a height map: it is gray; 'height-map' takes it as one\n");
    Pixels tagged = slanted(-1);
    tagged.is_tagged_srgb = true;
    EXPECT_EQ(remarks(tagged, false),
              "warning: the normal map is tagged sRGB; it is read as plain numbers, as all normal maps are\n");
}
