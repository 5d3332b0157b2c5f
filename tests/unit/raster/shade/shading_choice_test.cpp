// SPDX-License-Identifier: Apache-2.0
// Which draws are shaded how: by the settings, by rules for objects and materials, by the size of triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int side = 96;

RenderSettings settings(Shading shading) {
    RenderSettings s{.width = side, .height = side, .background = {0, 0, 0, 0}};
    s.shading = shading;
    return s;
}

Frame draw(const Scene& scene, const RenderSettings& s, RenderStats* stats = nullptr) {
    Camera camera;
    camera.vertical_fov_rad = radians(40);
    camera.z_near = 0.5;
    camera.z_far = 50;
    camera.to_world = translation(dvec3{0, 0, 6});
    return test::draw(scene, camera, s, 2, stats);
}

/// A unit sphere with its exact normals.
Mesh sphere(int rows, std::uint32_t material) {
    Mesh mesh;
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    const int columns = 2 * rows;
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c) {
            const double b = pi * r / rows, a = 2 * pi * c / columns;
            positions.push_back(
                {float(std::sin(b) * std::sin(a)), float(std::cos(b)), float(std::sin(b) * std::cos(a))});
        }
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const auto i = std::uint32_t(r * (columns + 1) + c), below = i + std::uint32_t(columns) + 1;
            indices.insert(indices.end(), {i, below, below + 1, i, below + 1, i + 1});
        }
    mesh.normals = positions;
    mesh.positions = positions;
    mesh.indices = indices;
    mesh.material = material;
    return mesh;
}

Scene lit_scene() {
    Scene scene;
    Material shiny = matte({0.7f, 0.5f, 0.3f});
    shiny.name = "shiny";
    shiny.classical.specular = {0.6f, 0.6f, 0.6f};
    scene.materials = {shiny, shiny};
    scene.materials[1].name = "other";
    Light spot;
    spot.type = LightType::spot;
    spot.position = {1, 1, 4};
    spot.direction = {-0.25, -0.25, -1};
    spot.cutoff_rad = 0.15f;
    scene.lights = {directional({-1, -1, -1}, {0.6f, 0.6f, 0.6f}), spot};
    return scene;
}

Scene sphere_scene(int rows) {
    Scene scene = lit_scene();
    add_object(scene, sphere(rows, 0));
    return scene;
}

}  // namespace

TEST(AutomaticShading, IsGouraudOnFineMeshesAndPhongOnCoarseOnes) {
    RenderStats fine, coarse;
    const Scene small = sphere_scene(96), large = sphere_scene(12);
    EXPECT_TRUE(same_bits(draw(small, settings(Shading::automatic), &fine), draw(small, settings(Shading::gouraud))));
    EXPECT_TRUE(same_bits(draw(large, settings(Shading::automatic), &coarse), draw(large, settings(Shading::phong))));
    EXPECT_NE(fine.lighting_evaluations, fine.pixels_shaded);
    EXPECT_EQ(coarse.lighting_evaluations, coarse.pixels_shaded);
}

TEST(AutomaticShading, DiffersFromPhongByNoMoreThanLightingChangesWithinTheLengthOfAnEdge) {
    const Scene scene = sphere_scene(96);  // with a highlight and the rim of a spot light
    const Frame automatic = draw(scene, settings(Shading::automatic)), phong = draw(scene, settings(Shading::phong));
    EXPECT_FALSE(same_bits(automatic, phong));
    const int reach = int(automatic_gouraud_px) + 1;  // corners, from pixel center to pixel center
    double most = 0;
    for (int y = reach; y < side - reach; ++y)
        for (int x = reach; x < side - reach; ++x) {
            float low = 1e9f, high = -1e9f;
            bool is_inside = true;
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx) {
                    const vec4 c = phong.color[std::size_t((y + dy) * side + x + dx)];
                    is_inside = is_inside && c.w > 0;
                    low = std::min(low, c.y);
                    high = std::max(high, c.y);
                }
            const float mine = automatic.color[std::size_t(y * side + x)].y;
            if (!is_inside) continue;
            EXPECT_GE(mine, low - 1e-3f) << x << ", " << y;
            EXPECT_LE(mine, high + 1e-3f) << x << ", " << y;
            most = std::max(most, double(std::fabs(mine - phong.color[std::size_t(y * side + x)].y)));
        }
    EXPECT_GT(most, 0.05) << "the spot light's rim has to tell the two apart, or this test says nothing";
}

TEST(AutomaticShading, ChoosesForEachMeshAndTheSameInEveryWindow) {
    Scene scene = lit_scene();
    add_object(scene, sphere(96, 0), translation(dvec3{-0.9, 0, 0}) * scaling(dvec3{0.7, 0.7, 0.7}));
    add_object(scene, sphere(10, 0), translation(dvec3{0.9, 0, 0}) * scaling(dvec3{0.7, 0.7, 0.7}));
    const Frame whole = draw(scene, settings(Shading::automatic)), gouraud = draw(scene, settings(Shading::gouraud)),
                phong = draw(scene, settings(Shading::phong));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto p = std::size_t(y * side + x);
            ASSERT_EQ(whole.color[p], x < side / 2 ? gouraud.color[p] : phong.color[p]) << x << ", " << y;
        }
    RenderSettings part = settings(Shading::automatic);
    part.window = {50, 20, 30, 40};
    const Frame window = draw(scene, part);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 30; ++x)
            ASSERT_EQ(window.color[std::size_t(y * 30 + x)], whole.color[std::size_t((y + 20) * side + x + 50)]);
}

TEST(AutomaticShading, IsPhongWhereANormalMapActsOrTheEyePlaneIsPassed) {
    Scene scene = sphere_scene(96);
    Mesh& mesh = scene.meshes[0];
    mesh.texcoords.emplace_back(std::vector<vec2>(mesh.positions.size(), vec2{0.5f, 0.5f}));
    mesh.tangents = std::vector<vec4>(mesh.positions.size(), vec4{1, 0, 0, 1});
    scene.materials[0].normal_texture = add_texture(scene, picture(rgb_pixels(2, 2, [](int, int) {
                                                        return std::array<int, 3>{128, 128, 255};
                                                    })));
    EXPECT_TRUE(same_bits(draw(scene, settings(Shading::automatic)), draw(scene, settings(Shading::phong))));
    RenderSettings plain = settings(Shading::automatic);
    plain.bump = Bump::none;
    RenderStats stats;
    draw(scene, plain, &stats);
    EXPECT_NE(stats.lighting_evaluations, stats.pixels_shaded);
    scene.materials[0].bump = Bump::normal;  // its own wish goes before the picture's
    EXPECT_TRUE(same_bits(draw(scene, plain), draw(scene, settings(Shading::phong))));
    draw(scene, plain, &stats);
    EXPECT_EQ(stats.lighting_evaluations, stats.pixels_shaded);
    Scene around = lit_scene();
    add_object(around, sphere(96, 0), scaling(dvec3{8, 8, 8}));  // the eye is in it
    draw(around, settings(Shading::automatic), &stats);
    EXPECT_EQ(stats.lighting_evaluations, stats.pixels_shaded);
}

TEST(ShadingRules, GiveObjectsAndMaterialsTheirOwnShading) {
    Scene scene = lit_scene();
    const auto place = [](double x) { return translation(dvec3{x, 0, 0}) * scaling(dvec3{0.5, 0.5, 0.5}); };
    add_object(scene, sphere(8, 0), place(-1.3));
    add_object(scene, sphere(8, 1), place(0));
    add_object(scene, sphere(8, 0), place(1.3));
    scene.nodes[2].name = "right";
    RenderSettings s = settings(Shading::phong);
    s.shading_rules = {{ShadingRule::Of::material, "other", Shading::flat},
                       {ShadingRule::Of::object, "right", Shading::unlit},
                       {ShadingRule::Of::object, "nobody", Shading::gouraud}};
    RenderStats stats;
    const Frame mixed = draw(scene, s, &stats);
    const Frame of[] = {draw(scene, settings(Shading::phong)), draw(scene, settings(Shading::flat)),
                        draw(scene, settings(Shading::unlit))};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto p = std::size_t(y * side + x);
            ASSERT_EQ(mixed.color[p], of[3 * x / side].color[p]) << x << ", " << y;
        }
    RenderStats phong, flat;
    draw(scene, settings(Shading::phong), &phong);
    draw(scene, settings(Shading::flat), &flat);
    EXPECT_LT(stats.lighting_evaluations, phong.lighting_evaluations);
    EXPECT_GT(stats.lighting_evaluations, flat.lighting_evaluations / 3);
}

TEST(ShadingRules, ReachWhatHangsFromAnObjectAndTheLastOneThatFitsCounts) {
    Scene scene = sphere_scene(8);
    Node parent;
    parent.name = "model";
    scene.nodes.insert(scene.nodes.begin(), parent);
    scene.nodes[1].parent = 0;
    RenderSettings s = settings(Shading::phong);
    s.shading_rules = {{ShadingRule::Of::object, "model", Shading::flat}};
    EXPECT_TRUE(same_bits(draw(scene, s), draw(scene, settings(Shading::flat))));
    s.shading_rules.push_back({ShadingRule::Of::material, "shiny", Shading::gouraud});
    EXPECT_TRUE(same_bits(draw(scene, s), draw(scene, settings(Shading::gouraud))));
}

TEST(OwnShading, OfANodeReachesWhatHangsFromItAndAMaterialsGoesBeforeIt) {
    Scene scene = sphere_scene(8);
    scene.nodes.insert(scene.nodes.begin(), Node{});
    scene.nodes[1].parent = 0;
    scene.nodes[0].shading = Shading::flat;
    const auto is_drawn_like = [&](Shading expected, const RenderSettings& s) {
        return same_bits(draw(scene, s), draw(sphere_scene(8), settings(expected)));
    };
    EXPECT_TRUE(is_drawn_like(Shading::flat, settings(Shading::phong)));
    scene.nodes[1].shading = Shading::unlit;
    EXPECT_TRUE(is_drawn_like(Shading::unlit, settings(Shading::phong)));
    scene.materials[0].shading = Shading::gouraud;
    EXPECT_TRUE(is_drawn_like(Shading::gouraud, settings(Shading::phong)));
}

TEST(OwnShading, GivesWayToRulesByNameAndToSettingsThatAreForTheWhole) {
    Scene scene = sphere_scene(8);
    scene.nodes[0].name = "ball";
    scene.nodes[0].shading = Shading::flat;
    scene.materials[0].shading = Shading::unlit;
    RenderSettings s = settings(Shading::phong);
    s.shading_rules = {{ShadingRule::Of::object, "ball", Shading::gouraud}};
    EXPECT_TRUE(same_bits(draw(scene, s), draw(sphere_scene(8), settings(Shading::gouraud))));
    s.shading_rules.clear();
    s.material_shading = false;
    EXPECT_TRUE(same_bits(draw(scene, s), draw(sphere_scene(8), settings(Shading::phong))));
}

TEST(ShadingRules, OfAnObjectAndOfWhatItHangsFromTheLaterCounts) {
    Scene scene = sphere_scene(8);
    for (const char* name : {"model", "part"}) {
        Node above;
        above.name = name;
        scene.nodes.insert(scene.nodes.begin(), above);
    }
    for (std::uint32_t n = 1; n < 3; ++n) scene.nodes[n].parent = n - 1;
    const ShadingRule model{ShadingRule::Of::object, "model", Shading::unlit},
        part{ShadingRule::Of::object, "part", Shading::flat},
        material{ShadingRule::Of::material, "shiny", Shading::gouraud};
    RenderSettings s = settings(Shading::phong);
    for (const auto& [rules, last] : {std::pair{std::vector{part, model}, Shading::unlit},
                                      {std::vector{model, part}, Shading::flat},
                                      {std::vector{material, model, part}, Shading::flat},
                                      {std::vector{material, part, model}, Shading::unlit},
                                      {std::vector{part, model, material}, Shading::gouraud}}) {
        s.shading_rules = rules;
        EXPECT_TRUE(same_bits(draw(scene, s), draw(scene, settings(last)))) << int(last);
    }
}
