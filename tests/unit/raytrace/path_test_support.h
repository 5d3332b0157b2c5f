// SPDX-License-Identifier: Apache-2.0
// Pictures by paths, for tests: of one pixel or of few, with the error that their variance says.
#pragma once
#include <cmath>
#include <vector>

#include "engines/raytrace/raytrace_engine.h"
#include "math/linear.h"
#include "support/scene_builder.h"

namespace rakelight::raytrace {

inline Frame picture_by_paths(Scene scene, const Camera& camera, RenderSettings settings, int threads = 2) {
    settings.method = RayMethod::path;
    Context context({.threads = threads});
    const auto engine = make_engine();
    engine->prepare(std::move(scene), context);
    Frame frame;
    engine->render(camera, settings, frame, context);
    return frame;
}

/// What one ray brings.
struct Estimate {
    vec3 mean;
    double error = 0;  ///< standard error of the luminance
};

/// 16 pixels that see all but the same.
inline Estimate estimate_at(const Scene& scene, dvec3 from, dvec3 to, RenderSettings settings) {
    Camera camera;
    camera.to_world =
        look_at(from, to, std::fabs(to.y - from.y) > 0.9 * length(to - from) ? dvec3{0, 0, 1} : dvec3{0, 1, 0});
    camera.vertical_fov_rad = 1e-4, camera.z_near = 1e-4, camera.z_far = 1e4;
    settings.width = settings.height = 4;
    settings.channels = channel_variance;
    const Frame frame = picture_by_paths(scene, camera, settings);
    Estimate out;
    double variance = 0;
    for (std::size_t i = 0; i < 16; ++i) {
        out.mean = out.mean + frame.color[i].xyz() * (1.0f / 16);
        variance += double(frame.variance[i]);
    }
    out.error = std::sqrt(variance) / 16;
    return out;
}

/// A scene without any light: a black one, lest it get others.
inline Scene dark_scene() {
    Scene scene;
    scene.lights = {{.type = LightType::ambient, .ambient = {0, 0, 0}}};
    return scene;
}

inline ImageHandle even_sky() {
    return test::picture(test::rgb_pixels(16, 8, [](int, int) { return std::array{255, 255, 255}; }), "even sky");
}

/// Radiance 1 from everywhere.
inline Scene furnace() {
    Scene scene;
    scene.environment = Environment{.image = even_sky()};
    return scene;
}

inline Mesh sphere_by_formula(std::uint32_t material) {
    Mesh mesh = test::square_mesh(material);  // stands for it where triangles are asked for
    mesh.shape = ExactShape{.kind = ExactShape::Kind::sphere, .radius = 1};
    return mesh;
}

/// -1..1, its faces outward.
inline Mesh box_mesh(std::uint32_t material) {
    Mesh mesh;
    mesh.material = material;
    std::vector<vec3> positions, normals;
    std::vector<std::uint32_t> indices;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const auto first = std::uint32_t(positions.size());
            vec3 n{}, u{};
            n[axis] = side, u[(axis + 1) % 3] = 1;
            const vec3 v = cross(n, u);
            for (const auto& [a, b] : {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}})
                positions.push_back(n + u * a + v * b), normals.push_back(n);
            for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + i);
        }
    mesh.positions = Block<vec3>(std::move(positions)), mesh.normals = Block<vec3>(std::move(normals));
    mesh.indices = Block<std::uint32_t>(std::move(indices));
    return mesh;
}

inline Material classical(float k_d, float k_s, float exponent) {
    Material m = test::matte({k_d, k_d, k_d});
    m.classical.specular = {k_s, k_s, k_s}, m.classical.shininess = exponent;
    return m;
}
inline Material metal(float f0, float roughness) {
    Material m;
    m.base_color = {f0, f0, f0, 1};
    m.metallic_roughness = {.metallic = 1, .roughness = roughness};
    return m;
}

inline Material shining(vec3 color) {
    Material m;
    m.base_color = {0, 0, 0, 1};
    m.metallic_roughness = {.metallic = 0, .roughness = 1, .specular = 0};
    m.emission = color;
    return m;
}

}  // namespace rakelight::raytrace
