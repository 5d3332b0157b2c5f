// SPDX-License-Identifier: Apache-2.0
// Scenes of lines and points at known pixels.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>

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
    camera.z_near = 0.1;
    camera.z_far = 100;
    camera.to_world = translation(dvec3{0.1, 0.2, 2.2});
    return camera;
}

/// Of pictures of 150 x 140 pixels.
inline void expect_same_bits_everywhere(const Scene& scene, RenderSettings s) {
    const Frame whole = draw(scene, eye(), s);
    EXPECT_TRUE(same_bits(whole, draw(scene, eye(), s, 4)));
    setenv("RAKELIGHT_ISA", "scalar", 1);
    EXPECT_TRUE(same_bits(whole, draw(scene, eye(), s)));
    unsetenv("RAKELIGHT_ISA");
    s.window = {37, 41, 70, 51};
    const Frame part = draw(scene, eye(), s, 2);
    for (int y = 0; y < 51; ++y)
        for (int x = 0; x < 70; ++x) ASSERT_EQ(pixel(part, x, y), pixel(whole, x + 37, y + 41)) << x << ", " << y;
}

}  // namespace rakelight::test
