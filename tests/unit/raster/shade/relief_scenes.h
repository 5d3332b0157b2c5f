// SPDX-License-Identifier: Apache-2.0
// A square of the plane z = 0, two meters wide, with height and normal maps, and what is shown of it.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "unit/raster/drawn.h"

namespace rakelight::test {

inline constexpr int size = 128;

/// A picture of linear floats, value(u, v) at the texels' centers; u and v 0..1, v down.
template <class Value>
inline Pixels field(int width, int height, const Value& value) {
    Pixels p;
    p.width = width, p.height = height;
    p.channels = 3;
    p.component = Component::f32;
    p.is_linear = true;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const vec3 v = value((float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height));
            const auto* const bytes = reinterpret_cast<const std::byte*>(&v);
            p.bytes.insert(p.bytes.end(), bytes, bytes + sizeof v);
        }
    return p;
}
template <class Value>
inline Pixels field(int texels, const Value& value) {
    return field(texels, texels, value);
}
inline Pixels constant(float h) {
    return field(4, [h](float, float) { return vec3{h, h, h}; });
}
inline Pixels ramp_along_u() {
    return field(64, [](float u, float) { return vec3{u, u, u}; });
}
inline Pixels ramp_along_v() {
    return field(64, [](float, float v) { return vec3{v, v, v}; });
}
inline Pixels step_at_middle() {
    return field(256, [](float u, float) { return u < 0.5f ? vec3{0.2f, 0.2f, 0.2f} : vec3{0.8f, 0.8f, 0.8f}; });
}
/// u in red, v in green.
inline Pixels coordinates() {
    return field(64, [](float u, float v) { return vec3{u, v, 0.5f}; });
}
/// Waves in both directions, as heights.
inline Pixels waves() {
    return field(128, [](float u, float v) {
        const float a = std::fabs(u * 6 - std::floor(u * 6) - 0.5f) * 2,
                    b = std::fabs(v * 6 - std::floor(v * 6) - 0.5f) * 2;
        const float h = 0.1f + 0.8f * a * (1 - a) * 4 * b;
        return vec3{h, h, h};
    });
}
/// Codes of a tangent-space normal map, green up: tilts that change over the square.
inline Pixels normal_codes(bool green_down = false) {
    return rgb_pixels(64, 64, [green_down](int x, int y) {
        const int g = 90 + 70 * (y % 16) / 15;
        return std::array<int, 3>{80 + 100 * (x % 16) / 15, green_down ? 255 - g : g, 230};
    });
}

inline constexpr Sampler one_level{
    .wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge, .mip = MipFilter::none};

struct Wanted {
    Bump bump = Bump::height;
    Relief relief{.depth = 0.1f};
};

inline Scene square_with(const Pixels& heights, double z = 0) {
    Scene scene;
    Material m = matte();
    m.double_sided = true;
    m.base_color_texture = add_texture(scene, picture(coordinates()), one_level);
    m.height_texture = add_texture(scene, picture(heights), one_level);
    scene.materials = {m};
    add_object(scene, square_mesh(0), translation(dvec3{0, 0, z}));
    scene.lights = {directional({0, 0, -1})};
    return scene;
}

inline Camera looking_from(dvec3 eye) {
    Camera camera;
    camera.vertical_fov_rad = 0.6;
    camera.z_near = 0.1;
    camera.z_far = 100;
    camera.to_world = look_at(eye, dvec3{0, 0, 0}, dvec3{0, 1, 0});
    return camera;
}

inline RenderSettings settings_of(const Wanted& wanted, Shading shading = Shading::phong) {
    RenderSettings s{.width = size, .height = size, .channels = channel_normal | channel_object, .shading = shading};
    s.bump = wanted.bump;
    s.relief = wanted.relief;
    return s;
}

/// Own colors: where the base color map is read.
inline Frame show(const Scene& scene, const Wanted& wanted, const Camera& camera) {
    return draw(scene, camera, settings_of(wanted, Shading::unlit));
}

inline vec3 normal_of(const Scene& scene, const Wanted& wanted, const Camera& camera = flat_camera()) {
    const Frame f = draw(scene, camera, settings_of(wanted));
    return f.normal[std::size_t(size / 2 * size + size / 2)];
}

inline void expect_near(vec3 got, vec3 expected, float tolerance) {
    EXPECT_NEAR(got.x, expected.x, tolerance);
    EXPECT_NEAR(got.y, expected.y, tolerance);
    EXPECT_NEAR(got.z, expected.z, tolerance);
}

inline double difference(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum += std::fabs(double(a.color[i][c]) - double(b.color[i][c]));
    return sum / double(3 * a.color.size());
}
inline double largest_difference(const Frame& a, const Frame& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::fabs(double(a.color[i][c]) - double(b.color[i][c])));
    return most;
}

}  // namespace rakelight::test
