// SPDX-License-Identifier: Apache-2.0
// Paths of light against closed forms: polygons as lights, lights without an area, glass; what they promise of noise and bits.
#include <gtest/gtest.h>

#include <numbers>

#include "path_test_support.h"

namespace rakelight::raytrace {
namespace {

/// Lambert 1760: irradiance of a polygon of radiance 1 on a surface at the origin with the normal +Z.
double irradiance_of(const std::vector<dvec3>& corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec3 a = normalize_or(corners[i], {}), b = normalize_or(corners[(i + 1) % corners.size()], {});
        sum += std::acos(dot(a, b)) * normalize_or(cross(a, b), {}).z;
    }
    return std::fabs(sum) / 2;
}

/// A white floor in z = 0 and a triangle above that shines down.
Scene lit_by_triangle(const std::vector<dvec3>& corners) {
    Scene scene = dark_scene();
    scene.materials = {test::matte({1, 1, 1}), shining({2, 1, 0.5f})};
    test::add_object(scene, test::square_mesh(0, 0.1f));
    Mesh light;
    light.material = 1;
    std::vector<vec3> places;
    for (const dvec3& c : corners) places.push_back(cast<float>(c));
    light.positions = Block<vec3>(std::move(places));
    light.indices = Block<std::uint32_t>(std::vector<std::uint32_t>{0, 1, 2});
    test::add_object(scene, light);
    return scene;
}

TEST(Paths, ATriangleLightsAsLambertsFormulaSays) {
    const std::vector<dvec3> corners{
        {-1, 0.5, 1}, {0.5, 2, 1.5}, {1.5, -1, 0.7}};  // seen from below: clockwise from above
    const double wanted = irradiance_of(corners) / std::numbers::pi;
    const dvec3 up = cross(corners[1] - corners[0], corners[2] - corners[0]);
    ASSERT_LT(up.z, 0);
    for (const auto sampling : {LightSampling::both, LightSampling::lights, LightSampling::materials}) {
        const Estimate seen =
            estimate_at(lit_by_triangle(corners), {0, -2, 0.3}, {0, 0, 0},
                        {.lighting = Lighting::lambert, .samples = 4096, .paths = {.light_sampling = sampling}});
        EXPECT_NEAR(seen.mean.y, wanted, 4 * seen.error + 1e-4) << int(sampling);
        EXPECT_LT(seen.error, 0.01 * wanted) << int(sampling);
    }
}

TEST(Paths, ATriangleOfOneSideShinesFromItsFrontAlone) {
    const std::vector<dvec3> corners{{-1, 0.5, 1}, {1.5, -1, 0.7}, {0.5, 2, 1.5}};  // its back is below
    Scene scene = lit_by_triangle(corners);
    const RenderSettings settings{.lighting = Lighting::lambert, .samples = 64};
    EXPECT_EQ(estimate_at(scene, {0, -2, 0.3}, {0, 0, 0}, settings).mean, vec3{});
    scene.materials[1].double_sided = true;
    EXPECT_GT(estimate_at(scene, {0, -2, 0.3}, {0, 0, 0}, settings).mean.x, 0.1f);
}

TEST(Paths, WaysToFindLightHaveTheSameMean) {
    // A glossy floor under a small and a large triangle and an environment: each way is the worse one somewhere.
    Scene scene = lit_by_triangle({{-0.2, 0.5, 1}, {0.1, 0.9, 1.2}, {0.2, 0.3, 0.9}});
    scene.lights.clear();
    scene.environment = Environment{.image = even_sky(), .intensity = 0.25f};
    for (const float roughness : {0.15f, 0.5f}) {
        scene.materials[0] = metal(0.9f, roughness);
        Estimate by[3];
        for (int k = 0; k < 3; ++k)
            by[k] = estimate_at(
                scene, {0, -0.7, 1}, {0, 0, 0},
                {.lighting = Lighting::pbr, .samples = 8192, .paths = {.light_sampling = LightSampling(k)}});
        for (int k = 1; k < 3; ++k)
            EXPECT_NEAR(by[k].mean.y, by[0].mean.y, 4 * std::hypot(by[k].error, by[0].error)) << roughness << " " << k;
        EXPECT_LE(by[0].error, 1.2 * std::min(by[1].error, by[2].error)) << roughness;
    }
}

TEST(Paths, DirectLightIsThatOfWhitted) {
    Scene scene;
    scene.materials = {classical(0.4f, 0.5f, 30), metal(0.8f, 0.4f)};
    scene.materials[0].classical.is_normalized = true;
    test::add_object(scene, test::square_mesh(0, 1));
    test::add_object(scene, test::square_mesh(1, 0.25f), translation(dvec3{0.3, 0, 0.4}));
    Light point;
    point.type = LightType::point, point.position = {-0.5, 0.5, 1.5}, point.linear = 0.5f;
    point.diffuse = {1, 0.5f, 0.25f}, point.specular = {0.25f, 0.5f, 1};
    scene.lights = {point, test::directional({0.3, 0.2, -1})};
    for (const Lighting lighting : {Lighting::lambert, Lighting::phong, Lighting::blinn_phong, Lighting::oren_nayar,
                                    Lighting::ward, Lighting::pbr})
        for (const dvec3 to : {dvec3{-0.5, -0.3, 0}, dvec3{0.3, 0.1, 0.4}, dvec3{0.1, -0.2, 0}}) {
            const RenderSettings settings{.lighting = lighting,
                                          .specular_form = SpecularForm::normalized,
                                          .shadows = true,
                                          .samples = 1,
                                          .max_depth = 0};
            Camera camera;
            camera.to_world = look_at({0.2, -2, 1.5}, to, {0, 0, 1});
            camera.vertical_fov_rad = 1e-5, camera.z_near = 1e-3, camera.z_far = 100;
            Context context({.threads = 1});
            const auto engine = make_engine();
            engine->prepare(scene, context);
            Frame whitted, paths;
            RenderSettings one = settings;
            one.width = one.height = 1;
            engine->render(camera, one, whitted, context);
            one.method = RayMethod::path;
            engine->render(camera, one, paths, context);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(paths.color[0][c], whitted.color[0][c], 1e-4f * (1 + whitted.color[0][c])) << int(lighting);
        }
}

TEST(Paths, WhatShinesLightsWholeWithoutReflections) {
    Scene scene = furnace();
    scene.materials = {metal(1, 0.3f)};
    test::add_object(scene, sphere_by_formula(0));
    for (const int depth : {0, 1, 8}) {
        const Estimate seen = estimate_at(scene, {1, 0, 3}, {0.2, 0, 0.98},
                                          {.lighting = Lighting::pbr, .samples = 1024, .max_depth = depth});
        EXPECT_NEAR(seen.mean.y, 0.985, 0.02 + 3 * seen.error) << depth;
    }
}

/// Many lights are asked one by one, or a few that are picked.
TEST(Paths, PickedLightsHaveTheMeanOfAll) {
    Scene scene;
    scene.materials = {classical(0.5f, 0.3f, 10)};
    test::add_object(scene, test::square_mesh(0, 3));
    for (int i = 0; i < 40; ++i) {
        Light light;
        light.type = LightType::point, light.position = {std::cos(i), std::sin(i), 0.5 + 0.05 * i};
        light.diffuse = light.specular = {0.02f * float(i), 0.1f, 0.3f};
        light.quadratic = 1;
        scene.lights.push_back(light);
    }
    vec3 wanted{};
    for (const Light& light : scene.lights) {
        Scene one = scene;
        one.lights = {light};
        wanted = wanted + estimate_at(one, {0, -2, 1}, {0.2, 0, 0}, {.lighting = Lighting::phong, .samples = 1}).mean;
    }
    const Estimate seen = estimate_at(scene, {0, -2, 1}, {0.2, 0, 0}, {.lighting = Lighting::phong, .samples = 4096});
    EXPECT_NEAR(seen.mean.y, wanted.y, 4 * seen.error + 1e-3);
    EXPECT_NEAR(seen.mean.x / wanted.x, 1, 0.02);
}

TEST(Paths, GlassInAnEvenSurroundingIsNotSeen) {
    for (const float roughness : {0.0f, 0.4f})
        for (const float thickness : {0.0f, 1.0f}) {
            Scene scene = furnace();
            Material glass;
            glass.metallic_roughness = {
                .metallic = 0, .roughness = roughness, .transmission = 1, .thickness = thickness};
            scene.materials = {glass};
            test::add_object(scene, sphere_by_formula(0));
            for (const double x : {0.0, 0.5, 0.9}) {
                const Estimate seen = estimate_at(scene, {x, 0, 3}, {x, 0, 0}, {.samples = 1024, .max_depth = 64});
                EXPECT_LE(seen.mean.y, 1 + 4 * seen.error + 1e-4) << roughness << " " << thickness << " " << x;
                // Light between the facets is lost where they are rough.
                EXPECT_GE(seen.mean.y, (roughness > 0 ? 0.78 : 0.999) - 4 * seen.error)
                    << roughness << " " << thickness << " " << x;
            }
        }
}

/// Under a light from one side a prism throws red less far than blue; in an even surrounding it is not seen at all.
TEST(Paths, DispersionPartsColorsAndKeepsTheirSum) {
    Scene scene = furnace();
    Material glass;
    glass.metallic_roughness = {.metallic = 0, .roughness = 0, .transmission = 1, .thickness = 1, .dispersion = 5};
    scene.materials = {glass};
    test::add_object(scene, sphere_by_formula(0));
    const Estimate even = estimate_at(scene, {0.6, 0, 3}, {0.6, 0, 0}, {.samples = 4096, .max_depth = 32});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(even.mean[c], 1, 0.03) << c;
    // The sky is a step from black to white: rays through the edge of the sphere meet it at another place for each color.
    scene.environment->image = test::picture(test::rgb_pixels(512, 256, [](int x, int) {
        return x > 200 ? std::array{255, 255, 255} : std::array{0, 0, 0};
    }));
    const auto seen = [&](double x) {
        return estimate_at(scene, {x, 0, 30}, {x, 0, 0}, {.samples = 64, .max_depth = 32}).mean;
    };
    double most = 0;
    for (double x = 0.6; x < 0.95; x += 0.005) {
        const vec3 c = seen(x);
        most = std::max(most, std::fabs(double(c.x) - double(c.z)));
    }
    EXPECT_GT(most, 0.3);
    scene.materials[0].metallic_roughness.dispersion = 0;
    const vec3 plain = seen(0.3);
    EXPECT_EQ(plain.x, plain.z);
}

/// A square that is lit from all around and bent by a constant normal map.
Scene bent_square(std::array<int, 3> texel, vec3 color) {
    Scene scene = furnace();
    Material m = test::matte(color);
    m.normal_texture = test::add_texture(scene, test::picture(test::rgb_pixels(4, 4, [&](int, int) { return texel; })));
    scene.materials = {m};
    test::add_object(scene, test::square_mesh(0, 1));
    return scene;
}

TEST(Paths, NormalMapsKeepEnergyAndHaveNoBlackFringes) {
    for (const int x : {180, 230, 250}) {
        const double slope = (x / 255.0 - 0.5) * 2, z = std::sqrt(std::max(1 - slope * slope, 0.0));
        Scene scene = bent_square({x, 128, int(127.5 + 127.5 * z)}, {1, 1, 1});
        // Of a hemisphere about the bent normal this share of Lambert's light comes from above the surface.
        const double open = 0.5 * (1 + z);
        for (const double angle : {-80.0, -40.0, 0.0, 40.0, 80.0}) {
            const double a = angle * std::numbers::pi / 180;
            const dvec3 from{3 * std::sin(a), 0, 3 * std::cos(a)};
            const RenderSettings matte{.lighting = Lighting::lambert, .samples = 1024, .max_depth = 0};
            scene.materials[0].model = MaterialModel::classical;
            const Estimate seen = estimate_at(scene, from, {0, 0, 0}, matte);
            EXPECT_LE(seen.mean.y, 1 + 4 * seen.error) << x << " " << angle;
            EXPECT_GE(seen.mean.y, open - 0.02) << x << " " << angle;
            // A mirror of metal shows the sky, even where its normal turns from the eye.
            Scene shiny = scene;
            shiny.materials[0].model = MaterialModel::metallic_roughness;
            shiny.materials[0].metallic_roughness = {.metallic = 1, .roughness = 0.1f};
            const Estimate mirror =
                estimate_at(shiny, from, {0, 0, 0}, {.lighting = Lighting::pbr, .samples = 256, .max_depth = 0});
            EXPECT_GE(mirror.mean.y, 0.7) << x << " " << angle;
            EXPECT_LE(mirror.mean.y, 1.001 + 4 * mirror.error) << x << " " << angle;
        }
    }
}

TEST(Paths, NormalMapsLetNoLightThroughASurface) {
    Scene scene = bent_square({250, 128, 140}, {1, 1, 1});
    scene.environment.reset();
    scene.lights = {test::directional({0.5, 0, 1})};  // from behind
    EXPECT_EQ(estimate_at(scene, {-1, 0, 2}, {0, 0, 0}, {.lighting = Lighting::lambert, .samples = 64}).mean, vec3{});
}

/// A room with a lamp, a mirror, glass and a bumpy wall.
Scene mixed_scene() {
    Scene scene = dark_scene();
    Material glass;
    glass.metallic_roughness = {.metallic = 0, .roughness = 0.1f, .transmission = 0.8f, .thickness = 1};
    Material wall = test::matte({0.7f, 0.6f, 0.5f});
    wall.double_sided = true;
    scene.materials = {wall, shining({5, 4, 3}), glass, metal(0.9f, 0.2f)};
    scene.materials[1].double_sided = true;
    test::add_object(scene, box_mesh(0));
    test::add_object(scene, test::square_mesh(1, 0.3f), translation(dvec3{0.2, 0.3, -0.7}));
    test::add_object(scene, sphere_by_formula(2), translation(dvec3{-0.3, -0.4, 0}) * scaling(dvec3{0.3, 0.3, 0.3}));
    test::add_object(scene, sphere_by_formula(3), translation(dvec3{0.5, -0.5, -0.2}) * scaling(dvec3{0.3, 0.3, 0.3}));
    return scene;
}
Camera in_the_room() {
    Camera camera;
    camera.to_world = look_at({0, 0, 0.95}, {0, -0.1, 0}, {0, 1, 0});
    camera.vertical_fov_rad = 1.4, camera.z_near = 1e-3, camera.z_far = 100;
    return camera;
}

TEST(Paths, BitsDoNotDependOnThreadsWindowsOrPasses) {
    const RenderSettings settings{
        .width = 72, .height = 50, .channels = channels_of_paths | channel_normal, .samples = 5};
    const Frame whole = picture_by_paths(mixed_scene(), in_the_room(), settings, 1);
    const Frame again = picture_by_paths(mixed_scene(), in_the_room(), settings, 3);
    EXPECT_EQ(whole.color, again.color);
    EXPECT_EQ(whole.variance, again.variance);
    RenderSettings part = settings;
    part.window = {13, 7, 40, 33};
    const Frame window = picture_by_paths(mixed_scene(), in_the_room(), part, 2);
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 40; ++x) {
            const std::size_t i = std::size_t(y * 40 + x), k = std::size_t((y + 7) * 72 + x + 13);
            ASSERT_EQ(window.color[i], whole.color[k]) << x << " " << y;
            ASSERT_EQ(window.direct[i], whole.direct[k]) << x << " " << y;
        }
    RenderSettings other = settings;
    other.paths.seed = 7;
    EXPECT_NE(picture_by_paths(mixed_scene(), in_the_room(), other).color, whole.color);
}

TEST(Paths, DirectAndIndirectLightAreTheColor) {
    const Frame f = picture_by_paths(mixed_scene(), in_the_room(),
                                     {.width = 32, .height = 32, .channels = channels_of_paths, .samples = 4});
    for (std::size_t i = 0; i < f.color.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(f.direct[i][c] + f.indirect[i][c], f.color[i][c], 1e-5f * (1 + f.color[i][c]));
            EXPECT_GE(f.albedo[i][c], 0);
            EXPECT_LE(f.albedo[i][c], 1.05f);
        }
}

double mean_of(const std::vector<float>& v) {
    double sum = 0;
    for (const float x : v) sum += double(x);
    return sum / double(v.size());
}

TEST(Paths, VarianceFallsWithTheSamples) {
    RenderSettings s{.width = 40, .height = 40, .channels = channel_variance, .samples = 64};
    Scene scene = mixed_scene();
    scene.materials[2] = scene.materials[0];  // fireflies of the glass would make it uneven
    const double few = mean_of(picture_by_paths(scene, in_the_room(), s).variance);
    s.samples = 512;
    const double many = mean_of(picture_by_paths(scene, in_the_room(), s).variance);
    EXPECT_NEAR(few / many, 8, 0.6);
}

TEST(Paths, TheErrorIsThatOfTheVarianceOrLess) {
    // Against another seed's long picture: scrambled Sobol points do better than random ones, never worse.
    RenderSettings s{.width = 40, .height = 40, .channels = channel_variance, .samples = 64};
    Scene scene = mixed_scene();
    scene.materials[2] = scene.materials[0];
    const Frame few = picture_by_paths(scene, in_the_room(), s);
    s.samples = 2048, s.paths.seed = 3;
    const Frame many = picture_by_paths(scene, in_the_room(), s);
    double squares = 0;
    for (std::size_t i = 0; i < few.color.size(); ++i) {
        const vec3 d = few.color[i].xyz() - many.color[i].xyz();
        const double luminance = 0.2126 * d.x + 0.7152 * d.y + 0.0722 * d.z;
        squares += luminance * luminance;
    }
    const double error = squares / double(few.color.size()), said = mean_of(few.variance);
    EXPECT_LT(error, 1.1 * said);
    EXPECT_GT(error, 0.1 * said);
}

TEST(Paths, ClampingDarkensIndirectLightAlone) {
    RenderSettings s{.width = 32, .height = 32, .channels = channel_direct | channel_indirect, .samples = 16};
    const Frame free = picture_by_paths(mixed_scene(), in_the_room(), s);
    s.paths.clamp = 0.2;
    const Frame clamped = picture_by_paths(mixed_scene(), in_the_room(), s);
    EXPECT_EQ(free.direct, clamped.direct);
    double before = 0, after = 0;
    for (std::size_t i = 0; i < free.color.size(); ++i) before += free.indirect[i].y, after += clamped.indirect[i].y;
    EXPECT_LT(after, 0.98 * before);
}

TEST(Paths, SurfacesOfHalfAlphaCoverHalf) {
    Scene scene = dark_scene();
    Material m = shining({1, 0.5f, 0.25f});
    m.alpha_mode = AlphaMode::blend, m.base_color.w = 0.25f;
    scene.materials = {m};
    test::add_object(scene, test::square_mesh(0, 1));
    RenderSettings s{.samples = 1024, .background = {0, 0, 0, 0}};
    Camera camera = test::flat_camera();
    camera.half_height = 0.5;
    s.width = s.height = 8;
    const Frame f = picture_by_paths(scene, camera, s);
    for (const vec4& c : f.color) {
        EXPECT_NEAR(c.w, 0.25f, 0.02f);
        EXPECT_NEAR(c.x, 1, 1e-4f);
    }
}

}  // namespace
}  // namespace rakelight::raytrace
