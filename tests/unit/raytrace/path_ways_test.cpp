// SPDX-License-Identifier: Apache-2.0
// Light that is asked and light that is met by chance are the same light, whatever lies between the surface and what shines.
#include <gtest/gtest.h>

#include <functional>

#include "path_test_support.h"

namespace rakelight::raytrace {
namespace {

/// A gray floor in z = 0, a lamp at z = 2 that shines down, and a pane between.
Scene under_pane(const Material& pane) {
    Scene scene = dark_scene();
    scene.materials = {test::matte({0.5f, 0.5f, 0.5f}), shining({6, 6, 6}), pane};
    test::add_object(scene, test::square_mesh(0, 3));
    test::add_object(scene, test::square_mesh(1, 0.5f), translation(dvec3{0, 0, 2}) * scaling(dvec3{1, -1, -1}));
    test::add_object(scene, test::square_mesh(2, 2), translation(dvec3{0, 0, 1}));
    return scene;
}
Material thin_glass(float roughness) {
    Material m;
    m.metallic_roughness = {.metallic = 0, .roughness = roughness, .transmission = 1};
    m.double_sided = true;
    return m;
}
Material classical_filter(float alpha) {
    Material m = test::matte({0.4f, 0.4f, 0.4f});
    m.classical.transmission = {0.9f, 0.5f, 0.2f};
    m.base_color.w = alpha, m.alpha_mode = alpha < 1 ? AlphaMode::blend : AlphaMode::opaque;
    m.double_sided = true;
    return m;
}
Material smoke() {
    Material m = test::matte({0, 0, 0});
    m.base_color.w = 0.3f, m.alpha_mode = AlphaMode::blend;
    return m;
}
/// The floor and the lamp in one absorbing body.
Scene in_body() {
    Material body = thin_glass(0);
    body.metallic_roughness.thickness = 1, body.metallic_roughness.ior = 1.0f;
    body.metallic_roughness.attenuation_distance = 1, body.metallic_roughness.attenuation_color = {0.5f, 0.3f, 0.1f};
    Scene scene = under_pane(body);
    scene.meshes.pop_back(), scene.nodes.pop_back();
    test::add_object(scene, box_mesh(2), scaling(dvec3{4, 4, 4}));
    return scene;
}
Scene in_fog() {
    Scene scene = under_pane(smoke());
    scene.fog = Fog{.kind = FogKind::exponential, .color = {0, 0, 0}, .density = 0.6f};
    return scene;
}

struct WaysCase {
    const char* name;
    std::function<Scene()> scene;
    Lighting lighting = Lighting::automatic;
};

class Ways : public testing::TestWithParam<WaysCase> {};

TEST_P(Ways, BringTheSameLight) {
    Estimate by[3];
    for (int k = 0; k < 3; ++k)
        by[k] = estimate_at(GetParam().scene(), {0, -2, 0.7}, {0.2, 0.1, 0},
                            {.lighting = GetParam().lighting,
                             .samples = 8192,
                             .max_depth = 3,
                             .paths = {.light_sampling = LightSampling(k)}});
    for (int k = 1; k < 3; ++k)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(by[k].mean[c], by[0].mean[c], 4 * std::hypot(by[k].error, by[0].error)) << k << " " << c;
    EXPECT_GT(by[0].mean.x, 0.01f);
    for (const Estimate& e : by) EXPECT_LT(e.error, 0.025 * double(e.mean.y)) << "too noisy to say anything";
}

INSTANTIATE_TEST_SUITE_P(
    Between, Ways,
    testing::Values(WaysCase{"clear_pane", [] { return under_pane(thin_glass(0)); }},
                    WaysCase{"rough_pane", [] { return under_pane(thin_glass(0.5f)); }},
                    WaysCase{"half_transmissive",
                             [] {
                                 Material m = thin_glass(0);
                                 m.metallic_roughness.transmission = 0.5f;
                                 return under_pane(m);
                             }},
                    WaysCase{"classical_filter", [] { return under_pane(classical_filter(1)); }, Lighting::phong},
                    WaysCase{"opened_filter", [] { return under_pane(classical_filter(0.6f)); }, Lighting::phong},
                    WaysCase{"blended", [] { return under_pane(smoke()); }}, WaysCase{"body", in_body},
                    WaysCase{"fog", in_fog},
                    WaysCase{"unlit_lamp",
                             [] {
                                 Scene scene = under_pane(smoke());
                                 scene.materials[1].shading = Shading::unlit;
                                 scene.materials[1].base_color = {0.7f, 0.7f, 0.7f, 1};
                                 return scene;
                             }}),
    [](const auto& at) { return std::string(at.param.name); });

TEST(Paths, SurfacesCloseBeforeALampShadeIt) {
    Scene scene = under_pane(thin_glass(0));
    Material black = test::matte({0, 0, 0});
    black.double_sided = true;
    scene.materials[2] = black;
    scene.nodes[2].local.matrix = translation(dvec3{0, 0, 1.9999});
    for (const auto sampling : {LightSampling::both, LightSampling::lights, LightSampling::materials})
        EXPECT_EQ(estimate_at(scene, {0, -2, 0.7}, {0.2, 0.1, 0},
                              {.samples = 256, .max_depth = 1, .paths = {.light_sampling = sampling}})
                      .mean,
                  vec3{});
}

TEST(Paths, PanesAreNotSurfacesOfTheDepth) {
    // What lies behind a clear pane is lit at the same depths as without it.
    const auto seen = [](const Scene& scene, int depth) {
        return estimate_at(scene, {0, -2, 3.5}, {0.2, 0.1, 0}, {.samples = 2048, .max_depth = depth}).mean.y;
    };
    Scene scene = under_pane(classical_filter(1));
    scene.materials[2] = test::matte({0, 0, 0});
    scene.materials[2].classical.transmission = {1, 1, 1};
    scene.materials[2].double_sided = true;
    scene.nodes[1].local.matrix = translation(dvec3{0, 0, 5}) * scaling(dvec3{1, -1, -1});
    Scene bare = scene;
    bare.meshes.pop_back(), bare.nodes.pop_back();
    for (const int depth : {0, 1}) EXPECT_NEAR(seen(scene, depth), seen(bare, depth), 2e-3) << depth;
}

TEST(Paths, WhatIsSentOnIsNeverMoreThanArrives) {
    Material constant = classical(0.8f, 0.8f, 20), fresnel = constant;
    constant.classical.mirror = Mirror::constant, fresnel.classical.mirror = Mirror::fresnel;
    Material filter = classical(0.8f, 0, 1);
    filter.classical.transmission = {1, 1, 1};
    Material shaded = thin_glass(0.5f);
    shaded.metallic_roughness.transmission = 0.5f;
    Material clear = shaded;
    clear.metallic_roughness.roughness = 0, clear.metallic_roughness.specular = 0;  // Schlick's F at n.v and at v.h
    constant.name = "constant", fresnel.name = "fresnel", filter.name = "filter", shaded.name = "rough",
    clear.name = "clear";
    for (Material m : {constant, fresnel, filter, shaded, clear}) {
        Scene scene = furnace();
        scene.materials = {m};
        test::add_object(scene, sphere_by_formula(0));
        for (const double x : {0.0, 0.6, 0.95}) {
            const Estimate seen =
                estimate_at(scene, {x, 0, 3}, {x, 0, 0},
                            {.lighting = m.model == MaterialModel::classical ? Lighting::phong : Lighting::pbr,
                             .samples = 4096,
                             .max_depth = 32});
            EXPECT_LE(seen.mean.y, 1 + 3 * seen.error) << m.name << " " << x;
            EXPECT_GE(seen.mean.y, 0.85) << m.name << " " << x;
        }
    }
}

TEST(Paths, OcclusionMapsDoNothing) {
    Scene scene = furnace();
    Material m = thin_glass(0.5f);
    m.metallic_roughness.transmission = 0.5f;
    scene.materials = {m};
    test::add_object(scene, test::square_mesh(0));
    const RenderSettings s{.samples = 256, .paths = {.light_sampling = LightSampling::materials}};
    const Estimate without = estimate_at(scene, {0, 0, 3}, {0, 0, 0}, s);
    scene.materials[0].occlusion_texture = test::add_texture(scene, test::picture(test::rgb_pixels(4, 4, [](int, int) {
                                                                 return std::array{0, 0, 0};
                                                             })));
    EXPECT_EQ(estimate_at(scene, {0, 0, 3}, {0, 0, 0}, s).mean, without.mean);
}

/// The remarks of a small picture, a line each.
std::string remarks_of(Scene scene) {
    Context context;
    const auto engine = make_engine();
    engine->prepare(std::move(scene), context);
    Frame frame;
    const RenderSettings s{.width = 4, .height = 4, .samples = 1, .method = RayMethod::path};
    engine->render(Camera{}, s, frame, context);
    std::string text;
    for (const ReportEntry& entry : context.report().entries()) text += entry.message + "\n";
    return text;
}

TEST(Paths, WhatIsLeftOutIsSaid) {
    Scene scene = furnace();
    scene.materials = {test::matte({0.5f, 0.5f, 0.5f})};
    test::add_object(scene, test::square_mesh(0));
    EXPECT_EQ(remarks_of(scene), "");
    Scene ambient = scene, occluded = scene, bright = scene, dark = dark_scene();
    ambient.lights = {{.type = LightType::ambient, .ambient = {0.1f, 0.1f, 0.1f}}};
    EXPECT_NE(remarks_of(ambient).find("ambient light is left out"), std::string::npos);
    occluded.materials[0].occlusion_texture =
        test::add_texture(occluded, test::picture(test::rgb_pixels(4, 4, [](int, int) {
                              return std::array{9, 9, 9};
                          })));
    EXPECT_NE(remarks_of(occluded).find("occlusion maps are left out"), std::string::npos);
    bright.materials[0] = test::matte({1.5f, 0.5f, 0.5f});
    EXPECT_NE(remarks_of(bright).find("divided by their sum"), std::string::npos);
    dark.materials = scene.materials;
    test::add_object(dark, test::square_mesh(0));
    EXPECT_NE(remarks_of(dark).find("there is no source of light"), std::string::npos);
}

TEST(Paths, ALittleTransmissionLeavesTheHighlightAsItIs) {
    Scene scene = dark_scene();
    Material m = metal(0.8f, 0.4f);
    m.metallic_roughness.anisotropy = 0.8f;
    scene.materials = {m};
    test::add_object(scene, test::square_mesh(0));
    scene.environment = Environment{.image = test::picture(test::rgb_pixels(64, 32, [](int x, int y) {
                                        const int c = y < 12 && x % 32 < 8 ? 255 : 0;
                                        return std::array{c, c, c};
                                    }))};
    scene.lights.clear();
    const RenderSettings s{.lighting = Lighting::pbr, .samples = 4096};
    for (const dvec3 from : {dvec3{2, 0, 1}, dvec3{0, 2, 1}}) {
        scene.materials[0].metallic_roughness.transmission = 0;
        const Estimate without = estimate_at(scene, from, {0, 0, 0}, s);
        scene.materials[0].metallic_roughness.transmission = 0.002f;
        const Estimate with = estimate_at(scene, from, {0, 0, 0}, s);
        EXPECT_NEAR(with.mean.y, without.mean.y, 0.004 + 3 * std::hypot(with.error, without.error));
    }
}

TEST(Paths, DirectLightOnSmoothMeshesIsThatOfWhitted) {
    // Coarse triangles with smooth normals: light passes the triangles' own horizons.
    Scene scene;
    scene.materials = {test::matte({0.8f, 0.8f, 0.8f})};
    Mesh ball = box_mesh(0);
    std::vector<vec3> normals;
    for (const vec3 p : ball.positions) normals.push_back(p * (1 / std::sqrt(3.0f)));
    ball.normals = Block<vec3>(std::move(normals));
    test::add_object(scene, ball);
    scene.lights = {test::directional({-1, 0.1, 0.3})};
    Camera camera;
    camera.to_world = look_at({2, 1, 4}, {0, 0, 0}, {0, 1, 0});
    camera.vertical_fov_rad = 0.6, camera.z_near = 1e-2, camera.z_far = 100;
    RenderSettings s{
        .width = 24, .height = 24, .lighting = Lighting::lambert, .shadows = true, .samples = 1, .max_depth = 0};
    const Frame paths = picture_by_paths(scene, camera, [&] {
        RenderSettings many = s;
        many.samples = 64;
        return many;
    }());
    s.samples = 8;
    Context context({.threads = 1});
    const auto engine = make_engine();
    engine->prepare(scene, context);
    Frame whitted;
    engine->render(camera, s, whitted, context);
    int dark = 0, compared = 0;
    for (std::size_t i = 0; i < paths.color.size(); ++i) {
        if (whitted.color[i].w < 1 || paths.color[i].w < 1) continue;
        ++compared;
        if (whitted.color[i].y > 0.1f && paths.color[i].y < 0.5f * whitted.color[i].y) ++dark;
    }
    EXPECT_GT(compared, 100);
    EXPECT_EQ(dark, 0);
}

TEST(Paths, NoiseIsNotKnownBeforeLightHasCome) {
    // A lamp so small that chance alone does not find it in few samples.
    Scene scene = dark_scene();
    scene.materials = {test::matte({1, 1, 1}), shining({1e6f, 1e6f, 1e6f})};
    test::add_object(scene, test::square_mesh(0, 3));
    test::add_object(scene, test::square_mesh(1, 1e-3f), translation(dvec3{0, 0, 2}) * scaling(dvec3{1, -1, -1}));
    Camera camera;
    camera.to_world = look_at({0, -2, 1}, {0, 0, 0}, {0, 0, 1});
    camera.vertical_fov_rad = 0.1, camera.z_near = 1e-3, camera.z_far = 100;
    RenderSettings s{.width = 4,
                     .height = 4,
                     .samples = 64,
                     .method = RayMethod::path,
                     .paths = {.light_sampling = LightSampling::materials, .noise = 0.5}};
    Context context({.threads = 1});
    const auto engine = make_engine();
    engine->prepare(scene, context);
    Frame frame;
    EXPECT_EQ(engine->render(camera, s, frame, context).rays.samples, 64);
    s.paths.light_sampling = LightSampling::both, s.paths.noise = 10;
    EXPECT_EQ(engine->render(camera, s, frame, context).rays.samples, 16);
}

}  // namespace
}  // namespace rakelight::raytrace
