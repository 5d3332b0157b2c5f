// SPDX-License-Identifier: Apache-2.0
// Solutions of rooms whose light is known.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include <rakelight/radiosity/radiosity.h>
#include <rakelight/scene/validate.h>

#include "image/maps/environment.h"
#include "radiosity/cut.h"
#include "radiosity/form_factor.h"
#include "radiosity/visibility.h"
#include "support/thrown_error.h"
#include "unit/bake/bake_scenes.h"
#include "unit/radiosity/box_scene.h"

namespace rakelight::radiosity {
namespace {

struct Solved {
    Scene scene;
    RadiosityReport report;
    std::string remarks;
};

Solved solve(Scene scene, const RadiositySettings& settings = {.elements = 1500, .unshot = 0.001}, int threads = 2) {
    Context context({.threads = threads});
    Solved out;
    out.scene = with_radiosity(std::move(scene), settings, out.report, context);
    validate(out.scene);
    for (const ReportEntry& entry : context.report().entries()) out.remarks += entry.message + "\n";
    return out;
}

/// What a vertex sends out.
vec3 radiance(const Scene& scene, const Mesh& mesh, std::size_t vertex) {
    return mesh.colors[vertex].xyz() * scene.materials[mesh.material].base_color.xyz();
}

TEST(Radiosity, AFurnaceGivesEmissionOverOneMinusAlbedo) {
    const Material glowing = diffuse({0.5f, 0.2f, 0}, {1, 1, 1});
    const Solved s = solve(room(glowing, glowing));
    for (const Mesh& mesh : s.scene.meshes)
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const vec3 r = radiance(s.scene, mesh, v);
            EXPECT_NEAR(r.x, 2, 0.03);
            EXPECT_NEAR(r.y, 1.25, 0.02);
            EXPECT_EQ(r.z, 1);
        }
}

TEST(Radiosity, PowerIsKept) {
    const Solved closed = solve(room(diffuse({0.7f, 0.6f, 0.5f}), diffuse({0.2f, 0.2f, 0.2f}, {5, 4, 3})));
    const RadiosityReport& r = closed.report;
    EXPECT_NEAR(r.emitted, pi * 4 * (0.2126 * 5 + 0.7152 * 4 + 0.0722 * 3), 1e-5);
    EXPECT_NEAR(r.absorbed + r.unshot + r.escaped, r.emitted, 1e-9 * r.emitted);
    EXPECT_NEAR(r.escaped, 0, 0.01 * r.emitted);
    EXPECT_LE(r.unshot, 0.001 * r.emitted);
    EXPECT_GT(r.shots, r.patches / 2);
}

TEST(Radiosity, FormFactorsOfAClosedRoomAddUpToOneAndAreReciprocal) {
    const Scene scene = room(diffuse({0.5f, 0.5f, 0.5f}), diffuse({0.5f, 0.5f, 0.5f}));
    Context context({.threads = 2});
    const std::vector<Part> parts = lit_parts(scene);
    const ColorMaps colors(scene, {true, true}, context);
    const CutScene cut{scene, parts, colors};
    const PatchLevel level = cut_to_patches(cut, placed_meshes(scene, parts, context), 200, 2000, context);
    const raytrace::SurfaceRays rays(scene, context);
    const FormFactors factors(level.elements, level.patches, rays, 1e-5);
    const auto count = std::uint32_t(level.patches.list.size());
    ASSERT_GT(count, 60u);
    const auto factor = [&](std::uint32_t from, std::uint32_t to) {
        return factors(receiver_of(level.elements.list[level.patches.of(level.patches.list[from])[0]]), to, 1);
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        double sum = 0;
        for (std::uint32_t j = 0; j < count; ++j) {
            const double there = factor(i, j);
            sum += there;
            const Patch &a = level.patches.list[i], &b = level.patches.list[j];
            if (length(a.center - b.center) <= 5 * (a.reach + b.reach)) continue;
            EXPECT_NEAR(there * a.area, factor(j, i) * b.area, 0.06 * there * a.area);
        }
        EXPECT_NEAR(sum, 1, 0.01);
    }
}

TEST(Radiosity, OfADistantPatchAcrossTheHorizonThePartAboveItCounts) {
    Scene scene;
    scene.materials = {diffuse({1, 1, 1})};
    test::add_object(scene, test::square_mesh(0));
    Context context({.threads = 1});
    const std::vector<Part> parts = lit_parts(scene);
    const ColorMaps colors(scene, {true}, context);
    const CutScene cut{scene, parts, colors};
    const Elements elements = cut.elements_of(placed_meshes(scene, parts, context), context);
    const Patches patches = make_patches(elements, 0.01);
    ASSERT_EQ(patches.list.size(), 2u);
    const raytrace::SurfaceRays rays(scene, context);
    const FormFactors factors(elements, patches, rays, 1e-5);
    for (const double x : {1.0, -1.0}) {
        const Receiver receiver{{0, 0, 30}, {x, 0, 0}, {0, 0, -1}};
        for (std::uint32_t p = 0; p < 2; ++p) {  // the center of one of the two lies below
            const Element& e = elements.list[patches.of(patches.list[p])[0]];
            EXPECT_GT(factors(receiver, p, 1), 0);
            EXPECT_EQ(factors(receiver, p, 1), form_factor_of_triangle(receiver.at, receiver.normal, e.corner));
        }
    }
}

TEST(Radiosity, ALightGivesIrradianceByItsCosineAndTheBaseColorStays) {
    Scene scene;
    scene.materials = {diffuse({0.5f, 0.25f, 1})};
    test::add_object(scene, test::square_mesh(0));
    scene.lights = {test::directional({0, 0.6, -0.8}, {1, 2, 0.5f})};
    const Solved s = solve(scene);
    EXPECT_TRUE(s.scene.lights.empty());
    EXPECT_EQ(s.scene.materials[0].model, MaterialModel::unlit);
    EXPECT_EQ(s.scene.materials[0].base_color, (vec4{0.5f, 0.25f, 1, 1}));
    ASSERT_EQ(s.scene.meshes.size(), 1u);
    for (const vec4& c : s.scene.meshes[0].colors) {
        EXPECT_NEAR(c.x, 0.8, 1e-6);
        EXPECT_NEAR(c.y, 1.6, 1e-6);
        EXPECT_NEAR(c.z, 0.4, 1e-6);
        EXPECT_EQ(c.w, 1);
    }
    // reflected, it meets nothing: by luminance 0.4 of what came
    EXPECT_NEAR(s.report.escaped / s.report.emitted, 0.4 / (0.2126 * 0.8 + 0.7152 * 1.6 + 0.0722 * 0.4), 1e-6);
}

TEST(Radiosity, BothSidesOfATwoSidedPlateHaveLightOfTheirOwn) {
    Scene scene;
    scene.materials = {diffuse({1, 1, 1})};
    scene.materials[0].double_sided = true;
    test::add_object(scene, test::square_mesh(0));
    scene.lights = {test::directional({0, 0, -1}, {1, 0, 0}), test::directional({0, 0, 1}, {0, 0, 1})};
    const Solved s = solve(scene, {.elements = 100});
    ASSERT_EQ(s.scene.meshes.size(), 2u);
    EXPECT_EQ(s.scene.nodes[0].meshes, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_FALSE(s.scene.materials[0].double_sided);
    for (const vec4& c : s.scene.meshes[0].colors) EXPECT_EQ(c, (vec4{1, 0, 0, 1}));
    for (const vec4& c : s.scene.meshes[1].colors) EXPECT_EQ(c, (vec4{0, 0, 1, 1}));
    const auto turn = [](const Mesh& m) {
        const vec3 a = m.positions[m.indices[0]];
        return cross(m.positions[m.indices[1]] - a, m.positions[m.indices[2]] - a).z;
    };
    EXPECT_GT(turn(s.scene.meshes[0]), 0);
    EXPECT_LT(turn(s.scene.meshes[1]), 0);
}

TEST(Radiosity, TheBackOfAOneSidedPlateIsBlackAndHoldsLightUp) {
    Scene scene;
    scene.materials = {diffuse({1, 1, 1})};
    test::add_object(scene, test::square_mesh(0));                                        // faces +Z, lit from -Z
    test::add_object(scene, test::square_mesh(0), placed_square({0, 0, 1}, {0, 0, -1}));  // behind it, faces -Z
    scene.lights = {test::directional({0, 0, 1})};
    const Solved s = solve(scene, {.elements = 100});
    for (const Mesh& mesh : s.scene.meshes)
        for (const vec4& c : mesh.colors) EXPECT_EQ(c.xyz(), vec3{});
}

TEST(Radiosity, AMirroredPlacementFacesAsItIsSeen) {
    Scene scene;
    scene.materials = {diffuse({1, 1, 1})};
    test::add_object(scene, test::square_mesh(0), scaling(dvec3{-1, 1, 1}));
    scene.lights = {test::directional({0, 0, -1})};
    const Solved s = solve(scene, {.elements = 100});
    for (const vec4& c : s.scene.meshes[0].colors) EXPECT_EQ(c.xyz(), (vec3{1, 1, 1}));
}

TEST(Radiosity, InstancesGetLightOfTheirOwn) {
    Scene scene;
    scene.materials = {diffuse({1, 1, 1})};
    test::add_object(scene, test::square_mesh(0));
    Node turned = scene.nodes[0];
    turned.local.matrix = placed_square({5, 0, 0}, {0, 0, -1});
    scene.nodes.push_back(turned);
    scene.lights = {test::directional({0, 0, -1})};
    const Solved s = solve(scene, {.elements = 100});
    ASSERT_EQ(s.scene.meshes.size(), 2u);
    EXPECT_NE(s.scene.nodes[0].meshes, s.scene.nodes[1].meshes);
    EXPECT_EQ(s.scene.meshes[s.scene.nodes[0].meshes[0]].colors[0].x, 1);
    EXPECT_EQ(s.scene.meshes[s.scene.nodes[1].meshes[0]].colors[0].x, 0);
}

TEST(Radiosity, TexturesAreAveragedForTheExchangeAndStayInThePicture) {
    // left half black: the walls reflect half of what they get
    Material walls = diffuse({1, 1, 1}), plain = diffuse({0.5f, 0.5f, 0.5f});
    walls.base_color_texture.texture = 0;
    const Material lamp = diffuse({0, 0, 0}, {1, 1, 1});
    Scene scene = room(walls, lamp);
    const Pixels stripes = test::rgb_pixels(64, 64, [](int x, int) {
        const int c = x % 2 == 0 ? 255 : 0;
        return std::array{c, c, c};
    });
    scene.textures = {{.image = test::picture(stripes, "stripes")}};
    const Solved striped = solve(scene), gray = solve(room(plain, lamp));
    EXPECT_TRUE(striped.scene.materials[0].base_color_texture);
    EXPECT_NEAR(striped.report.absorbed, gray.report.absorbed, 0.01 * gray.report.absorbed);
    const auto mean = [](const Scene& of) {
        double sum = 0;
        for (const vec4& c : of.meshes[3].colors) sum += double(c.x);  // the floor
        return sum / double(of.meshes[3].colors.size());
    };
    EXPECT_NEAR(mean(striped.scene), mean(gray.scene), 0.02 * mean(gray.scene));
}

TEST(Radiosity, LightIsSmoothOverTheBorderOfObjectsAndSharpAtCreases) {
    Scene scene;
    scene.materials = {diffuse({0.5f, 0.5f, 0.5f})};
    test::add_object(scene, test::square_mesh(0));
    test::add_object(scene, test::square_mesh(0), translation(dvec3{2, 0, 0}));
    test::add_object(scene, test::square_mesh(0), placed_square({-1, 0, 1}, {1, 0, 0}));
    Light lamp;
    lamp.position = {1.5, 0.3, 1};
    lamp.quadratic = 1;
    scene.lights = {lamp};
    const Solved s = solve(scene, {.elements = 600});
    int smooth = 0, sharp = 0;
    const auto world = [&](std::size_t m, std::size_t v) {
        return transform_point(*scene.nodes[m].local.matrix, cast<double>(s.scene.meshes[m].positions[v]));
    };
    for (const std::size_t other : {1u, 2u})
        for (std::size_t v = 0; v < s.scene.meshes[0].positions.size(); ++v)
            for (std::size_t w = 0; w < s.scene.meshes[other].positions.size(); ++w) {
                if (length(world(0, v) - world(other, w)) > 1e-6) continue;
                const vec4 a = s.scene.meshes[0].colors[v], b = s.scene.meshes[other].colors[w];
                EXPECT_EQ(a == b, other == 1);
                ++(other == 1 ? smooth : sharp);
            }
    EXPECT_GE(smooth, 5);
    EXPECT_GE(sharp, 5);
}

TEST(Radiosity, AnEvenSkyGivesItsRadianceWhereNothingHidesIt) {
    Scene scene;
    scene.materials = {diffuse({0.5f, 0.5f, 0.5f})};
    test::add_object(scene, test::square_mesh(0));
    const Pixels even = test::rgb_pixels(16, 8, [](int, int) { return std::array{255, 255, 255}; });
    scene.environment = Environment{.image = test::picture(even, "even sky"), .intensity = 2};
    const Solved s = solve(scene, {.elements = 100});
    for (const vec4& c : s.scene.meshes[0].colors) EXPECT_NEAR(c.x, 2, 1e-5);
    EXPECT_FALSE(s.scene.environment->is_light);
    EXPECT_TRUE(s.scene.environment->is_background);
    // a wall as high as wide at its side hides some of it from the floor
    test::add_object(scene, test::square_mesh(0), placed_square({1, 0, 1}, {-1, 0, 0}));
    scene.materials[0].base_color = {0, 0, 0, 1};
    double least = 10, most = 0;
    const Solved hidden = solve(scene, {.elements = 400});
    for (const vec4& c : hidden.scene.meshes[0].colors)
        least = std::min(least, double(c.x)), most = std::max(most, double(c.x));
    EXPECT_LT(least, 1.4);
    EXPECT_GT(most, 1.8);
}

/// A square that faces +Z, of 2 x 2 texels that are black on the left and white on the right, under a directional light that gives 1.
Scene halves(Material m, TextureUse Material::*use) {
    Scene scene;
    const Pixels picture = test::rgb_pixels(64, 64, [](int x, int) {
        return x < 32 ? std::array{0, 0, 0} : std::array{255, 255, 255};
    });
    if (use) m.*use = test::add_texture(scene, test::picture(picture));
    scene.materials = {m};
    test::add_object(scene, test::square_mesh(0));
    scene.lights = {test::directional({0, 0, -1})};
    return scene;
}

TEST(Radiosity, WhereAnEmissionTextureIsBlackASurfaceShowsWhatItReflects) {
    const Solved dark =
        solve(halves(diffuse({0.4f, 0.4f, 0.4f}, {5, 5, 5}), &Material::emission_texture), {.elements = 500});
    bool is_left = false, is_right = false;
    ASSERT_EQ(dark.scene.nodes[0].meshes.size(), 2u);
    ASSERT_EQ(dark.scene.materials.size(), 2u);
    for (const std::uint32_t m : dark.scene.nodes[0].meshes) {
        const Mesh& mesh = dark.scene.meshes[m];
        for (const std::uint32_t v : mesh.indices) {
            const bool emits = bool(dark.scene.materials[mesh.material].base_color_texture);
            (emits ? is_right : is_left) = true;
            EXPECT_NEAR(radiance(dark.scene, mesh, v).x, emits ? 5 : 0.4f, 1e-4);
            EXPECT_LT(emits ? 0 : mesh.positions[v].x, 0.3f);  // of the black half, or a little beyond
        }
    }
    EXPECT_TRUE(is_left && is_right);
}

TEST(Radiosity, MetalOfATextureIsDarkWhereItIs) {
    Scene scene = halves(diffuse({0.4f, 0.4f, 0.4f}), nullptr);
    const Pixels metal = test::rgb_pixels(64, 64, [](int x, int) { return std::array{0, 255, x < 32 ? 255 : 0}; });
    scene.materials[0].metallic_roughness.texture = test::add_texture(scene, test::picture(metal));
    scene.materials[0].metallic_roughness.metallic = 1;
    const Solved s = solve(std::move(scene), {.elements = 2000});
    const Mesh& mesh = s.scene.meshes[0];
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const float x = mesh.positions[v].x;
        if (std::fabs(x) < 0.3f || std::fabs(x) > 0.7f) continue;  // elements reach so far; the texture repeats
        EXPECT_NEAR(radiance(s.scene, mesh, v).x, x < 0 ? 0 : 0.4f, 2e-4) << x;
    }
}

TEST(Radiosity, ASunInTheSkyIsNotMissed) {
    Scene scene;
    scene.materials = {diffuse({0.5f, 0.5f, 0.5f})};
    test::add_object(scene, test::square_mesh(0));
    Pixels sky{.width = 256, .height = 128, .channels = 3, .component = Component::f32};
    std::vector<float> texels(3 * 256 * 128, 0.1f);
    double sun = 0;  // irradiance / pi of four texels on a surface that faces +Z
    for (const int y : {40, 41})
        for (const int x : {10, 11}) {
            for (int k = 0; k < 3; ++k) texels[std::size_t(3 * (256 * y + x) + k)] = 1000;
            const dvec3 d = equirectangular_direction((x + 0.5) / 256, (y + 0.5) / 128);
            sun += 999.9 * std::max(0.0, d.z) * (2 * pi / 256) *
                   (std::cos(pi * y / 128) - std::cos(pi * (y + 1) / 128)) / pi;
        }
    sky.bytes.resize(texels.size() * 4);
    std::memcpy(sky.bytes.data(), texels.data(), sky.bytes.size());
    scene.environment = Environment{.image = test::picture(std::move(sky), "sky")};
    const Solved s = solve(scene, {.elements = 100});
    ASSERT_GT(sun, 0.4);
    for (const vec4& c : s.scene.meshes[0].colors) EXPECT_NEAR(c.x, 0.1 + sun, 0.02 * sun);
}

TEST(Radiosity, ASphereSendsOutAllOfItsLight) {
    constexpr double radius = 0.1;
    Scene scene = room(diffuse({0, 0, 0}), diffuse({0, 0, 0}));
    scene.materials.push_back(diffuse({0, 0, 0}, {1, 1, 1}));
    Mesh lamp = test::plain_sphere(24, 48, radius);
    lamp.material = 2;
    test::add_object(scene, std::move(lamp));
    Context context({.threads = 2});
    RadiosityReport report;
    const Scene lit = with_radiosity(scene, {.elements = 20000}, report, context, LitColors::irradiance);
    EXPECT_NEAR(report.emitted, pi * 4 * pi * radius * radius, 0.005);
    EXPECT_NEAR(report.absorbed, report.emitted, 0.01 * report.emitted);
    int count = 0;
    for (std::size_t m = 0; m < 6; ++m)
        for (std::size_t v = 0; v < lit.meshes[m].positions.size(); ++v) {
            const vec3 p = lit.meshes[m].positions[v];
            const double squared = 1 + double(p.x) * double(p.x) + double(p.y) * double(p.y);
            if (squared > 2) continue;
            EXPECT_NEAR(lit.meshes[m].colors[v].x, radius * radius / (squared * std::sqrt(squared)), 0.0003);
            ++count;
        }
    EXPECT_GT(count, 100);
}

TEST(Radiosity, ManySmallPartsSharePatches) {
    Scene scene;
    scene.materials = {diffuse({0.5f, 0.5f, 0.5f})};
    for (int i = 0; i < 3000; ++i)
        test::add_object(scene, test::square_mesh(0, 0.2f),
                         translation(dvec3{0.5 * (i % 60), 0.5 * (i / 60), 0.1 * (i % 7)}));
    scene.lights = {test::directional({0, 0, -1})};
    const Solved s = solve(std::move(scene), {.elements = 20000, .unshot = 0.05});
    EXPECT_LE(s.report.patches, 2000u);
    EXPECT_GT(s.report.patches, 200u);
    double sum = 0;
    for (const Mesh& mesh : s.scene.meshes) sum += double(radiance(s.scene, mesh, 0).x);
    EXPECT_NEAR(sum / 3000, 0.5, 0.01);
}

TEST(Radiosity, UnlitMaterialsStayAndHoldLightUp) {
    Scene scene;
    scene.materials = {diffuse({1, 1, 1}), diffuse({0.3f, 0.4f, 0.5f})};
    scene.materials[1].model = MaterialModel::unlit;
    test::add_object(scene, test::square_mesh(0));
    test::add_object(scene, test::square_mesh(1), translation(dvec3{0, 0, 1}));
    scene.lights = {test::directional({0, 0, -1})};
    const Solved s = solve(scene, {.elements = 100});
    EXPECT_EQ(s.scene.materials[1], scene.materials[1]);
    EXPECT_EQ(s.scene.meshes[1], scene.meshes[1]);
    for (const vec4& c : s.scene.meshes[0].colors) EXPECT_EQ(c.xyz(), vec3{});
}

TEST(Radiosity, WhatIsLeftOutIsSaid) {
    Scene scene = room(diffuse({0.5f, 0.5f, 0.5f}), diffuse({0, 0, 0}, {1, 1, 1}));
    scene.materials[0].metallic_roughness.metallic = 0.5f;
    scene.lights = {{.type = LightType::ambient}};
    scene.animations.push_back({.name = "walk"});
    const Solved s = solve(scene);
    EXPECT_TRUE(s.scene.animations.empty());
    const std::string& remarks = s.remarks;
    EXPECT_NE(remarks.find("of one moment"), std::string::npos) << remarks;
    EXPECT_NE(remarks.find("1 material of metal"), std::string::npos) << remarks;
    EXPECT_NE(remarks.find("ambient light is left out"), std::string::npos) << remarks;
}

TEST(Radiosity, TheSameBitsForAnyNumberOfThreads) {
    Scene scene = room(diffuse({0.7f, 0.6f, 0.5f}), diffuse({0.2f, 0.2f, 0.2f}, {5, 4, 3}));
    test::add_object(scene, test::square_mesh(0, 0.3f), translation(dvec3{0.2, -0.3, 0.1}));
    const Solved one = solve(scene, {.elements = 1500}, 1), four = solve(scene, {.elements = 1500}, 4);
    EXPECT_EQ(one.report.absorbed, four.report.absorbed);
    ASSERT_EQ(one.scene.meshes.size(), four.scene.meshes.size());
    for (std::size_t m = 0; m < one.scene.meshes.size(); ++m) {
        const Mesh &a = one.scene.meshes[m], &b = four.scene.meshes[m];
        EXPECT_TRUE(std::equal(a.colors.begin(), a.colors.end(), b.colors.begin(), b.colors.end()));
        EXPECT_TRUE(std::equal(a.indices.begin(), a.indices.end(), b.indices.begin(), b.indices.end()));
    }
}

TEST(Radiosity, KeepsWithinTheElements) {
    const Scene scene = room(diffuse({0.7f, 0.6f, 0.5f}), diffuse({0.2f, 0.2f, 0.2f}, {5, 4, 3}));
    for (const int elements : {12, 100, 1000}) {
        const Solved s = solve(scene, {.elements = elements});
        EXPECT_LE(s.report.elements, std::uint32_t(elements));
        EXPECT_GE(s.report.elements, std::uint32_t(elements / 8));
    }
    const Solved more = solve(scene, {.elements = 11});  // the scene's own triangles stay
    EXPECT_LE(more.report.elements, 18u);
    EXPECT_NE(more.remarks.find("up to 18 elements, since the scene has 12 triangles"), std::string::npos)
        << more.remarks;
    for (const int wrong : {0, max_radiosity_elements + 1})
        EXPECT_EQ(test::error_of([&] { solve(scene, {.elements = wrong}); }).code(), ErrorCode::usage);
}

TEST(Radiosity, MoreTrianglesThanElementsMayBeIsOneLine) {
    Scene scene;
    scene.materials = {diffuse({1, 1, 1})};
    Mesh mesh = test::square_mesh(0);
    std::vector<std::uint32_t> indices;
    for (int i = 0; i <= max_radiosity_elements; ++i) indices.insert(indices.end(), {0u, 1u, 2u});
    mesh.indices = std::move(indices);
    test::add_object(scene, std::move(mesh));
    const Error error = test::error_of([&] { solve(scene); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_NE(std::string(error.what()).find("this one has 200001"), std::string::npos) << error.what();
}

TEST(Radiosity, ShadowBordersAreCutFiner) {
    Scene scene;
    scene.materials = {diffuse({1, 1, 1})};
    test::add_object(scene, test::square_mesh(0, 4));
    test::add_object(scene, test::square_mesh(0), translation(dvec3{0, 0, 1}));
    scene.lights = {test::directional({0, 0, -1})};
    const Solved s = solve(scene, {.elements = 4000});
    EXPECT_GT(s.report.rounds, 1);
    // triangles at the border of the shadow (side 2) and far from it
    double near = 1e9, far = 1e9;
    const Mesh& floor = s.scene.meshes[0];
    for (std::size_t i = 0; i < floor.indices.size(); i += 3) {
        const vec3 a = floor.positions[floor.indices[i]], b = floor.positions[floor.indices[i + 1]];
        const double size = double(length(a - b));
        const float out = std::max(std::fabs(a.x), std::fabs(a.y));
        double& least = std::fabs(out - 1) < 0.3f ? near : far;
        if (std::fabs(out - 1) < 0.3f || out > 2) least = std::min(least, size);
    }
    EXPECT_LT(near, 0.5 * far);
}

TEST(Radiosity, NothingThatIsLitStaysAsItIs) {
    Scene scene;
    scene.materials = {diffuse({1, 1, 1})};
    scene.materials[0].model = MaterialModel::unlit;
    test::add_object(scene, test::square_mesh(0));
    const Solved s = solve(scene);
    EXPECT_EQ(s.scene.meshes, scene.meshes);
    EXPECT_EQ(s.report.elements, 0u);
}

}  // namespace
}  // namespace rakelight::radiosity
