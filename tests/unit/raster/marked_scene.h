// SPDX-License-Identifier: Apache-2.0
// Scenes of lines and points at known pixels.
#pragma once
#include "unit/raster/drawn.h"

namespace rakelight::test {

/// [px] of the pictures that flat_camera() makes with settings().
inline constexpr int side = 64;

inline RenderSettings settings() { return {.width = side, .height = side, .background = {0, 0, 0, 1}}; }

/// flat_camera() shows -1..1 on 64 pixels: the place of a pixel coordinate.
inline float at(double px) { return float(px / 32 - 1); }
inline vec3 place(double px, double py, float z = 0) { return {at(px), -at(py), z}; }

/// Lines or points through these places, in pairs or one by one.
inline void add_marks(Scene& scene, Topology topology, std::vector<vec3> places, vec4 color = {1, 1, 1, 1},
                      std::vector<vec4> colors = {}) {
    Mesh mesh;
    mesh.topology = topology;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < places.size(); ++i) indices.push_back(i);
    mesh.positions = std::move(places);
    mesh.indices = indices;
    if (!colors.empty()) mesh.colors = std::move(colors);
    mesh.material = add_unlit(scene, color, color.w < 1 ? AlphaMode::blend : AlphaMode::opaque);
    add_object(scene, std::move(mesh));
}

inline Camera eye() {
    Camera camera;
    camera.vertical_fov_rad = radians(50);
    camera.near = 0.1;
    camera.far = 100;
    camera.to_world = translation(dvec3{0.1, 0.2, 2.2});
    return camera;
}

}  // namespace rakelight::test
