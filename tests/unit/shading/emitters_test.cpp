// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/emitters.h"

#include <gtest/gtest.h>

#include "support/scene_builder.h"
#include "unit/shading/fake_textures.h"
#include "unit/shading/fixed_random.h"

namespace rakelight::shading {
namespace {

using test::add_object;
using test::chi_square_deviation;
using test::FixedRandom;
using test::square_mesh;

Material glowing(float strength, bool double_sided = false) {
    Material m;
    m.emission = {strength, strength, strength};
    m.double_sided = double_sided;
    return m;
}

struct Made {
    Context context;
    TextureCache textures;
    test::FakePacker packer;
    DrawList list;
    std::uint64_t before = 0;  ///< charged without the emitters
    Emitters emitters;
    explicit Made(Scene scene, FrontFace front = FrontFace::counter_clockwise, int threads = 1)
        : context({.threads = threads}), list(make_draw_list(std::move(scene), textures, packer, context)) {
        before = context.memory().charged();
        emitters = Emitters(list, textures, front, context);
    }
    std::uint64_t charged() { return context.memory().charged() - before; }
    float pdf(std::uint32_t draw, std::uint32_t triangle = 0) const { return emitters.pdf_area(draw, triangle); }
    EmitterSample sample(FixedRandom& random, dvec3 origin = {}) const {
        const double choice = random();
        const vec2 u{float(random()), float(random())};
        return emitters.sample(choice, u, origin);
    }
};

dmat4 at(dvec3 place, dvec3 scale = {1, 1, 1}) { return translation(place) * scaling(scale); }

/// Two triangles each of draw 0: radiance 1, draw 1: radiance 3 from both sides and half the width, draw 2: dark.
Scene three_squares() {
    Scene scene;
    scene.materials = {glowing(1), glowing(3, true), Material()};
    add_object(scene, square_mesh(0));
    add_object(scene, square_mesh(1, 0.5f), translation(dvec3{5, 0, 0}));
    add_object(scene, square_mesh(2), translation(dvec3{0, 5, 0}));
    return scene;
}

TEST(Emitters, AreChosenByTheirPower) {
    const Made made(three_squares());
    // Areas 4 and 1, of which the second shines three times as bright from both sides: 4 to 6.
    EXPECT_NEAR(made.emitters.power(), pi * 10, 1e-9);
    EXPECT_FLOAT_EQ(made.pdf(0, 0), 0.4f / 4);
    EXPECT_FLOAT_EQ(made.pdf(0, 1), 0.4f / 4);
    EXPECT_FLOAT_EQ(made.pdf(1, 0), 0.6f / 1);
    EXPECT_EQ(made.pdf(2, 0), 0);
    EXPECT_EQ(made.pdf(3, 0), 0) << "no such draw";
    EXPECT_FALSE(made.emitters.shines_back(0));
    EXPECT_TRUE(made.emitters.shines_back(1));
    FixedRandom random(1);
    constexpr int samples = 100000;
    std::vector<double> counts(4);
    for (int i = 0; i < samples; ++i) {
        const EmitterSample s = made.sample(random);
        ASSERT_LT(s.draw, 2u);
        ASSERT_EQ(s.pdf_area, made.pdf(s.draw, s.triangle));
        ASSERT_EQ(s.shines_back, s.draw == 1);
        ++counts[s.draw * 2 + s.triangle];
    }
    EXPECT_LT(chi_square_deviation(counts, {0.2 * samples, 0.2 * samples, 0.3 * samples, 0.3 * samples}), 4);
}

TEST(Emitters, PointsAreUniformOnTheirTriangleAboutTheOrigin) {
    Scene scene;
    scene.materials = {glowing(1)};
    Mesh mesh = square_mesh(0);
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2};  // (-1, -1), (1, -1), (1, 1)
    add_object(scene, mesh, at({1e7, 2e7, 3e7}));
    const Made made(std::move(scene));
    FixedRandom random(2);
    constexpr int samples = 100000, n = 4;
    std::vector<double> counts(n * n), expected(n * n);
    for (int i = 0; i < samples; ++i) {
        const EmitterSample s = made.sample(random, {1e7 - 1, 2e7 - 1, 3e7});
        const double x = double(s.position.x), y = double(s.position.y);  // 0..2, y below x
        ASSERT_TRUE(x >= 0 && x <= 2 && y >= 0 && y <= x + 1e-6) << x << " " << y;
        ASSERT_EQ(s.position.z, 0);
        ASSERT_NEAR(s.weight[0] + s.weight[1] + s.weight[2], 1, 1e-6);
        ASSERT_NEAR(2 * (s.weight[1] + s.weight[2]), x, 1e-6);
        ASSERT_NEAR(2 * s.weight[2], y, 1e-6);
        ++counts[std::min(std::size_t(y / 2 * n), std::size_t(n - 1)) * n +
                 std::min(std::size_t(x / 2 * n), std::size_t(n - 1))];
    }
    for (std::size_t y = 0; y < n; ++y)
        for (std::size_t x = y; x < n; ++x) expected[y * n + x] = samples * (x == y ? 1.0 : 2.0) / (n * n);
    EXPECT_LT(chi_square_deviation(counts, expected), 4);
}

TEST(Emitters, NormalsLookToTheFrontOfMirroredPlacementsToo) {
    const struct {
        dvec3 scale;
        FrontFace front;
        float z;
    } cases[] = {{{1, 1, 1}, FrontFace::counter_clockwise, 1},   {{-1, 1, 1}, FrontFace::counter_clockwise, 1},
                 {{1, 1, -1}, FrontFace::counter_clockwise, -1}, {{2, -3, -1}, FrontFace::counter_clockwise, -1},
                 {{1, 1, 1}, FrontFace::clockwise, -1},          {{-1, 1, 1}, FrontFace::clockwise, -1}};
    for (const auto& c : cases) {
        Scene scene;
        scene.materials = {glowing(1)};
        add_object(scene, square_mesh(0), at({}, c.scale));
        const Made made(std::move(scene), c.front);
        EXPECT_EQ(made.emitters.sample(0.5, {0.5f, 0.5f}, {}).normal, (vec3{0, 0, c.z}))
            << c.scale.x << c.scale.y << c.scale.z;
        EXPECT_NEAR(double(made.pdf(0)), 1 / (4 * std::abs(c.scale.x * c.scale.y)), 1e-7);
    }
}

TEST(Emitters, EveryPlacementOfAMeshCountsByItsOwnArea) {
    Scene scene;
    scene.materials = {glowing(2)};
    add_object(scene, square_mesh(0));
    for (const double scale : {2.0, 3.0}) {
        Node node;
        node.local.matrix = at({10 * scale, 0, 0}, {scale, 1, 1});
        node.meshes = {0};
        scene.nodes.push_back(node);
    }
    const Made made(std::move(scene));
    EXPECT_NEAR(made.emitters.power(), pi * 2 * (4 + 8 + 12), 1e-9);
    double all = 0;
    for (std::uint32_t draw = 0; draw < 3; ++draw)
        for (std::uint32_t triangle = 0; triangle < 2; ++triangle)
            all += double(made.pdf(draw, triangle)) * 2 * (draw + 1);
    EXPECT_NEAR(all, 1, 1e-6);
    EXPECT_EQ(made.pdf(0), made.pdf(2)) << "as bright, so as dense";
    const EmitterSample last = made.emitters.sample(0.999, {0.5f, 0.5f}, {});
    EXPECT_NEAR(last.position.x, 30, 3);
    EXPECT_EQ(last.draw, 2u);
}

TEST(Emitters, WhatHasNoAreaOrNoPlaceIsNeverChosen) {
    Scene scene;
    scene.materials = {glowing(1)};
    Mesh mesh = square_mesh(0);
    const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
    mesh.positions = std::vector<vec3>{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {nan, 0, 0}, {infinity, 0, 0}, {3, -1, 0}};
    mesh.normals = {}, mesh.tangents = {}, mesh.texcoords = {};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 3, 0, 0, 1, 0, 1, 2, 0, 1, 4, 0, 1, 5};
    add_object(scene, mesh);
    const Made made(std::move(scene));
    EXPECT_NEAR(made.emitters.power(), pi * 2, 1e-9);
    for (const std::uint32_t triangle : {0u, 1u, 3u, 4u}) EXPECT_EQ(made.pdf(0, triangle), 0) << triangle;
    EXPECT_FLOAT_EQ(made.pdf(0, 2), 0.5f);
    FixedRandom random(3);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(made.sample(random).triangle, 2u);
}

TEST(Emitters, UnlitMaterialsAndDarkOnesTakeNoMemory) {
    Scene scene = three_squares();
    for (Material& m : scene.materials) m.model = MaterialModel::unlit;
    Made unlit(std::move(scene));
    EXPECT_TRUE(unlit.emitters.empty());
    EXPECT_EQ(unlit.emitters.power(), 0);
    EXPECT_EQ(unlit.pdf(0), 0);
    EXPECT_EQ(unlit.emitters.sample(0.5, {0.5f, 0.5f}, {}).draw, no_index);
    EXPECT_EQ(unlit.charged(), 0u);
    Scene flat;
    flat.materials = {glowing(1)};
    add_object(flat, square_mesh(0), at({}, {1, 0, 1}));
    Made made(std::move(flat));
    EXPECT_TRUE(made.emitters.empty()) << "all of them have no area";
    EXPECT_EQ(made.charged(), 0u);
    EXPECT_EQ(made.pdf(0), 0);
}

TEST(Emitters, ClassicalMaterialsShineFromBothSides) {
    Scene scene;
    Material m = test::matte();
    m.emission = {1, 1, 1};
    scene.materials = {m};
    add_object(scene, square_mesh(0));
    const Made made(std::move(scene));
    EXPECT_TRUE(made.emitters.shines_back(0));
    EXPECT_NEAR(made.emitters.power(), pi * 8, 1e-9);
}

/// Two squares in two halves of a picture: the left one code `left`, the right one white.
Scene textured(int left) {
    Scene scene;
    Material m = glowing(2);
    const auto halves = [left](int x, int) {
        const int c = x < 32 ? left : 255;
        return std::array{c, c, c};
    };
    m.emission_texture = test::add_texture(scene, test::picture(test::rgb_pixels(64, 64, halves)));
    scene.materials = {m};
    for (const float from : {0.1f, 0.6f}) {
        Mesh mesh = square_mesh(0);
        const float to = from + 0.3f;
        mesh.texcoords[0] = std::vector<vec2>{{from, 0.9f}, {to, 0.9f}, {to, 0.1f}, {from, 0.1f}};
        add_object(scene, mesh);
    }
    return scene;
}

TEST(Emitters, TexturesSayHowMuchOfTheEmissionATriangleHas) {
    const Made made(textured(188));  // 188 is about half of white's light
    EXPECT_NEAR(double(made.pdf(0) / made.pdf(1)), 0.5029, 1e-3);
    EXPECT_NEAR(made.emitters.power(), pi * 2 * 4 * 1.5029, 0.05);
    const Made dim(textured(3));
    EXPECT_GT(dim.pdf(0, 0), 0);
    EXPECT_GT(dim.pdf(0, 1), 0);
}

TEST(Emitters, TrianglesInTheBlackOfATextureAreNotChosen) {
    const Made made(textured(0));
    EXPECT_EQ(made.pdf(0, 0), 0);
    EXPECT_EQ(made.pdf(0, 1), 0);
    EXPECT_FLOAT_EQ(made.pdf(1, 0), 0.25f);
    Scene turned = textured(0);
    turned.materials[0].emission_texture.transform.offset = {0.5f, 0};
    const Made other(std::move(turned));
    EXPECT_FLOAT_EQ(other.pdf(0, 0), 0.25f) << "the transform of the slot counts";
    EXPECT_EQ(other.pdf(1, 0), 0);
    Scene bare = textured(0);
    bare.meshes[1].texcoords.clear();
    EXPECT_TRUE(Made(std::move(bare)).emitters.empty()) << "without coordinates all of it is the texel at 0, 0";
}

TEST(Emitters, ColorsOfFactorAndTextureAreMultiplied) {
    Scene scene = textured(255);
    scene.materials[0].emission = {0, 1, 0};
    EXPECT_NEAR(Made(scene).emitters.power(), pi * 8 * 0.7152, 1e-6);
    const auto red = [](int, int) { return std::array{255, 0, 0}; };
    scene.textures[0].image = test::picture(test::rgb_pixels(4, 4, red));
    EXPECT_TRUE(Made(std::move(scene)).emitters.empty()) << "a red picture through green";
}

TEST(Emitters, ATextureThatWasKeptWithoutItsMeansIsLookedAtAgain) {
    Scene scene = textured(0);
    Scene plain = scene;
    plain.materials[0].emission_texture = {};
    plain.materials[0].base_color_texture = scene.materials[0].emission_texture;
    Context context({.threads = 1});
    TextureCache textures;
    const test::FakePacker packer;
    const DrawList before = make_draw_list(std::move(plain), textures, packer, context);
    const DrawList list = make_draw_list(std::move(scene), textures, packer, context);
    EXPECT_EQ(Emitters(list, textures, FrontFace::counter_clockwise, context).pdf_area(0, 0), 0);
}

Mesh many_triangles(std::uint32_t count) {
    Mesh mesh;
    FixedRandom random(5);
    std::vector<vec3> positions(std::size_t(count) * 3);
    for (vec3& p : positions) p = {float(random()), float(random()), float(random())};
    std::vector<std::uint32_t> indices(positions.size());
    for (std::uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
    mesh.positions = std::move(positions);
    mesh.indices = std::move(indices);
    mesh.material = 0;
    return mesh;
}

Scene two_crowds() {
    Scene scene;
    scene.materials = {glowing(1)};
    add_object(scene, many_triangles(30001));
    add_object(scene, many_triangles(20000), at({}, {2, 1, 1}));
    return scene;
}

TEST(Emitters, AreTheSameForAnyNumberOfThreads) {
    const Made one(two_crowds()), four(two_crowds(), FrontFace::counter_clockwise, 4);
    EXPECT_EQ(one.emitters.power(), four.emitters.power());
    for (std::uint32_t draw = 0; draw < 2; ++draw)
        for (std::uint32_t i = 0; i < 20000; ++i) ASSERT_EQ(one.pdf(draw, i), four.pdf(draw, i)) << i;
    FixedRandom first(6), second(6);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(one.sample(first).position, four.sample(second).position);
}

TEST(Emitters, DensitiesOfAllTrianglesSumToOneOverTheirAreas) {
    const Made made(two_crowds());
    double all = 0;
    for (std::uint32_t draw = 0; draw < 2; ++draw) {
        const Mesh& mesh = made.list.scene.meshes[draw];
        for (std::uint32_t i = 0; i < mesh.triangle_count(); ++i) {
            dvec3 p[3];
            for (std::size_t k = 0; k < 3; ++k)
                p[k] = transform_point(made.list.draws[draw].to_world, cast<double>(mesh.positions[3 * i + k]));
            const dvec3 normal = cross(p[1] - p[0], p[2] - p[0]);
            all += double(made.pdf(draw, i)) * std::sqrt(dot(normal, normal)) / 2;
        }
    }
    EXPECT_NEAR(all, 1, 1e-6);
}

TEST(Emitters, ChargeWhatTheyKeepAndAskForNoMoreThanThereIs) {
    Made made(two_crowds());
    EXPECT_GT(made.charged(), 50001u * 12);
    EXPECT_LE(made.charged(), 50001u * 24);
    made.emitters = Emitters();
    EXPECT_EQ(made.charged(), 0u);
    Context small({.threads = 1, .max_memory = 1000000});
    EXPECT_THROW(Emitters(made.list, made.textures, FrontFace::counter_clockwise, small), Error);
    EXPECT_EQ(small.memory().charged(), 0u);
}

/// What it is for: irradiance 1 m before the middle of a square of side 2 whose radiance is 1 is pi times the form factor
/// (Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-3: four times that of a corner).
TEST(Emitters, LightByDensityIsTheIrradianceOfASquare) {
    Scene scene;
    scene.materials = {glowing(1)};
    add_object(scene, square_mesh(0));
    const Made made(std::move(scene));
    const double slope = 1 / std::sqrt(2.0), exact = 4 * slope * std::atan(slope);
    FixedRandom random(9);
    constexpr int samples = 200000;
    double sum = 0;
    for (int i = 0; i < samples; ++i) {
        const EmitterSample s = made.sample(random, {0, 0, 1});
        const dvec3 to = cast<double>(s.position);
        const double square = dot(to, to), at_point = -to.z / std::sqrt(square);
        const double at_light = -dot(to, cast<double>(s.normal)) / std::sqrt(square);
        sum += at_point * at_light / (square * double(s.pdf_area));
    }
    EXPECT_NEAR(sum / samples, exact, 0.01 * exact);
}

}  // namespace
}  // namespace rakelight::shading
