// SPDX-License-Identifier: Apache-2.0
// Pictures of lines and points for tests: by trace and by soft, from cameras whose pixels are known.
#pragma once
#include <vector>

#include "engines/raster/raster_engine.h"
#include "engines/raytrace/raytrace_engine.h"
#include "math/linear.h"
#include "support/scene_builder.h"

namespace rakelight::raytrace {

inline constexpr int side = 64;

inline Frame drawn(Engine& engine, const Scene& scene, const Camera& camera, const RenderSettings& settings,
                   int threads = 1) {
    Context context({.threads = threads});
    engine.prepare(scene, context);
    Frame frame;
    engine.render(camera, settings, frame, context);
    return frame;
}

inline Frame traced(const Scene& scene, const Camera& camera, const RenderSettings& settings, int threads = 1) {
    return drawn(*make_engine(), scene, camera, settings, threads);
}

inline Frame soft(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
    return drawn(*raster::make_engine(), scene, camera, settings);
}

/// From z = 5, parallel: 64 pixels show -1 to 1.
inline Camera flat() {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.half_height = 1, camera.z_near = 1, camera.z_far = 10;
    camera.to_world = translation(dvec3{0, 0, 5});
    return camera;
}

inline Camera oblique(bool is_parallel = false) {
    Camera camera;
    camera.to_world = look_at({1, 0.8, 3}, {0, 0, 0}, {0, 1, 0});
    camera.vertical_fov_rad = radians(45);
    camera.z_near = 0.1, camera.z_far = 50;
    if (is_parallel) camera.projection = Projection::orthographic, camera.half_height = 1.2;
    return camera;
}

inline vec3 place(double px, double py, float z = 0) { return {float(px / 32 - 1), float(1 - py / 32), z}; }

/// Of lines, before black.
inline RenderSettings line_settings(float width, int samples = 1) {
    RenderSettings settings{.width = side, .height = side, .background = {0, 0, 0, 1}};
    settings.samples = samples;
    settings.line_width = width;
    return settings;
}

/// Not lit. @param color  its opacity less than 1: blended
inline std::uint32_t add_unlit(Scene& scene, vec4 color) {
    Material& material = scene.materials.emplace_back(test::matte());
    material.model = MaterialModel::unlit;
    material.base_color = color;
    material.double_sided = true;
    if (color.w < 1) material.alpha_mode = AlphaMode::blend;
    return std::uint32_t(scene.materials.size() - 1);
}

/// Lines by pairs of places, or points. @param vertex_colors  [places], or none
inline void add_marks(Scene& scene, Topology topology, const std::vector<vec3>& places, vec4 color,
                      const std::vector<vec4>& vertex_colors = {}) {
    Mesh mesh;
    mesh.topology = topology;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < places.size(); ++i) indices.push_back(i);
    mesh.positions = places, mesh.indices = indices;
    if (!vertex_colors.empty()) mesh.colors = vertex_colors;
    mesh.material = add_unlit(scene, color);
    test::add_object(scene, std::move(mesh));
}

inline void add_lines(Scene& scene, const std::vector<vec3>& ends, const std::vector<vec4>& colors = {},
                      float opacity = 1) {
    add_marks(scene, Topology::lines, ends, {1, 1, 1, opacity}, colors);
}

}  // namespace rakelight::raytrace
