// SPDX-License-Identifier: Apache-2.0
// What the tests of the engine gl draw, and how they compare it with the soft engine.
#pragma once
#include <array>
#include <cmath>

#include "engines/raster/raster_engine.h"
#include "support/scene_builder.h"
#include "unit/opengl/opengl_test.h"

namespace rakelight::test {

inline RenderSettings small() {
    RenderSettings s;
    s.width = 64, s.height = 48;
    return s;
}

inline Camera oblique() {
    Camera camera;
    camera.vertical_fov_rad = 0.8;
    camera.to_world = look_at({1.2, 1.5, 3}, {0, 0, 0}, {0, 1, 0});
    return camera;
}

/// Two squares that cross, one behind the other, textured and lit.
inline Scene two_squares() {
    Scene scene;
    Material m = matte({0.8f, 0.5f, 0.2f});
    m.base_color_texture = add_texture(scene, picture(rgb_pixels(8, 8, [](int x, int y) {
                                           return std::array{200, 30 * x, 30 * y};
                                       })));
    scene.materials = {m, matte({0.2f, 0.6f, 0.9f})};
    add_object(scene, square_mesh(0));
    add_object(scene, square_mesh(1), translation(dvec3{0.4, 0.3, 0.3}));
    scene.lights = {directional({-1, -1, -2})};
    scene.lights[0].ambient = {0.1f, 0.1f, 0.1f};
    return scene;
}

inline Frame drawn(Engine& engine, const Scene& scene, const RenderSettings& settings, Context& context,
                   const Camera& camera = oblique()) {
    engine.prepare(scene, context);
    Frame frame;
    engine.render(camera, settings, frame, context);
    return frame;
}

inline Frame by_soft(const Scene& scene, const RenderSettings& settings, Context& context,
                     const Camera& camera = oblique()) {
    return drawn(*raster::make_engine(), scene, settings, context, camera);
}

inline double rmse(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            const double d = double(a.color[i][c]) - double(b.color[i][c]);
            sum += d * d;
        }
    return std::sqrt(sum / (4 * double(a.color.size())));
}

}  // namespace rakelight::test
