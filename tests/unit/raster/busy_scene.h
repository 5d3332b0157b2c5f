// SPDX-License-Identifier: Apache-2.0
// A scene with a bit of everything that the soft engine draws.
#pragma once
#include <random>

#include "support/scene_builder.h"

namespace rakelight::test {

/// Squares in every attitude, some through the eye plane: classical with textures, metallic-roughness with all its
/// maps, masked, blended, culled and unlit; five kinds of lights.
inline Scene busy_scene() {
    Scene scene;
    const auto checks = [](int x, int y) {
        return std::array<int, 3>{(x ^ y) & 4 ? 255 : 40, x * 8 % 256, 128 + y * 3 % 127};
    };
    Sampler mixed;
    mixed.magnify = Filter::nearest;
    const TextureUse picture_use = add_texture(scene, picture(rgb_pixels(32, 32, checks)));
    const TextureUse nearest = add_texture(scene, picture(rgb_pixels(16, 64, checks)), mixed);
    Material shiny = matte({0.8f, 0.6f, 0.4f});
    shiny.classical.specular = {0.5f, 0.5f, 0.5f};
    shiny.base_color_texture = shiny.normal_texture = picture_use;
    shiny.classical.specular_texture = nearest;
    Material metal;
    metal.metallic_roughness.roughness = 0.6f;
    metal.metallic_roughness.texture = metal.emission_texture = metal.occlusion_texture = picture_use;
    metal.normal_texture = nearest;
    metal.emission = {0.2f, 0.1f, 0};
    Material masked = matte({0.2f, 0.9f, 0.3f}), glass = matte({0.9f, 0.2f, 0.3f}), plain;
    masked.alpha_mode = AlphaMode::mask;
    masked.opacity_texture = picture_use;
    glass.alpha_mode = AlphaMode::blend;
    glass.base_color.w = 0.4f;
    plain.model = MaterialModel::unlit;
    scene.materials = {shiny, metal, masked, glass, plain};
    std::mt19937 random(5);
    std::uniform_real_distribution<float> at(-3, 3);
    for (std::uint32_t n = 0; n < 60; ++n) {
        Mesh mesh = square_mesh(n % 5);
        std::vector<vec3> positions;
        for (int k = 0; k < 4; ++k) positions.push_back({at(random), at(random), at(random) + 1});
        mesh.positions = positions;
        add_object(scene, std::move(mesh), scaling(dvec3{n % 2 ? -1.0 : 1.0, 1, 1}));
    }
    Light point, spot, lamp, ambient;
    point.position = {1, 2, 3};
    point.linear = 0.1f;
    spot.type = LightType::spot;
    spot.position = {-2, 0, 4};
    spot.cutoff_rad = 0.7;
    spot.exponent = 4;
    lamp.type = LightType::spot;
    lamp.units = LightUnits::photometric;
    lamp.position = {0, 3, 3};
    lamp.direction = {0, -1, -1};
    lamp.intensity = 20;
    ambient.type = LightType::ambient;
    ambient.ambient = {0.1f, 0.1f, 0.2f};
    scene.lights = {directional({1, -1, -2}, {0.5f, 0.5f, 0.6f}), point, spot, lamp, ambient};
    return scene;
}

/// Stands within it: some squares lie behind the eye.
inline Camera busy_view() {
    Camera camera;
    camera.vertical_fov_rad = 1;
    camera.z_near = 0.5;
    camera.z_far = 50;
    camera.to_world = translation(dvec3{0.2, 0.1, 4});
    return camera;
}

/// The busy scene with everything that only the full kernel draws.
inline Scene rich_scene() {
    Scene scene = busy_scene();
    const TextureUse map = scene.materials[0].base_color_texture;
    scene.materials[0].height_texture = map;
    MetallicRoughnessParameters& p = scene.materials[1].metallic_roughness;
    p.clearcoat = 0.7f, p.clearcoat_roughness = 0.2f, p.sheen_color = {0.3f, 0.2f, 0.4f}, p.sheen_roughness = 0.5f;
    p.anisotropy = 0.6f;
    p.transmission = 0.4f, p.thickness = 0.2f, p.attenuation_distance = 0.5f, p.attenuation_color = {0.5f, 0.8f, 0.9f};
    p.dispersion = 2, p.iridescence = 0.6f;
    for (TextureUse* use :
         {&p.clearcoat_texture, &p.clearcoat_roughness_texture, &p.clearcoat_normal_texture, &p.sheen_color_texture,
          &p.sheen_roughness_texture, &p.anisotropy_texture, &p.specular_texture, &p.specular_color_texture,
          &p.transmission_texture, &p.thickness_texture, &p.iridescence_texture, &p.iridescence_thickness_texture})
        *use = map;
    scene.fog.kind = FogKind::exponential;
    scene.environment.emplace();
    return scene;
}

}  // namespace rakelight::test
