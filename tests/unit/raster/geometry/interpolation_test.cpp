// SPDX-License-Identifier: Apache-2.0
// Attributes between a triangle's corners: correct in perspective, or linear on the screen.
#include <gtest/gtest.h>

#include <cmath>

#include "engines/raster/raster_engine.h"
#include "support/scene_builder.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int side = 96;

/// An unlit triangle whose vertex colors are its own barycentrics.
Scene triangle(vec3 a, vec3 b, vec3 c) {
    Scene scene;
    Material m;
    m.model = MaterialModel::unlit;
    m.double_sided = true;
    scene.materials = {m};
    Mesh mesh;
    mesh.positions = std::vector<vec3>{a, b, c};
    mesh.normals = std::vector<vec3>(3, vec3{0, 1, 0});
    mesh.colors = std::vector<vec4>{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2};
    mesh.material = 0;
    add_object(scene, std::move(mesh));
    return scene;
}

Frame draw(const Scene& scene, AttributeInterpolation interpolation, bool parallel = false, Window window = {}) {
    Context context({.threads = 2});
    auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Camera camera;
    camera.vertical_fov_rad = pi / 2;  // at distance w the picture is 2 w high
    camera.z_near = 0.5;
    camera.z_far = 100;
    if (parallel) {
        camera.projection = Projection::orthographic;
        camera.half_height = 2;
    }
    RenderSettings s{.width = side, .height = side, .window = window, .background = {0, 0, 0, 0}};
    s.interpolation = interpolation;
    Frame frame;
    engine->render(camera, s, frame, context);
    return frame;
}

dvec2 on_screen(dvec3 p) { return {(p.x / -p.z * 0.5 + 0.5) * side, (0.5 - p.y / -p.z * 0.5) * side}; }

dvec3 barycentrics(dvec2 p, dvec2 a, dvec2 b, dvec2 c) {
    const auto area = [](dvec2 u, dvec2 v, dvec2 w) { return (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x); };
    const double whole = area(a, b, c);
    return {area(p, b, c) / whole, area(a, p, c) / whole, area(a, b, p) / whole};
}

}  // namespace

TEST(Interpolation, IsLinearOnTheScreenOrDividedByDepth) {
    const vec3 a{-1.5f, -1, -2}, b{1.5f, -1, -2}, c{0, 3, -9};
    const dvec3 corners[] = {cast<double>(a), cast<double>(b), cast<double>(c)};
    const dvec2 places[] = {on_screen(corners[0]), on_screen(corners[1]), on_screen(corners[2])};
    const Scene scene = triangle(a, b, c);
    const Frame screen = draw(scene, AttributeInterpolation::screen),
                perspective = draw(scene, AttributeInterpolation::perspective);
    int seen = 0;
    double most = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const vec4 s = screen.color[std::size_t(y * side + x)], p = perspective.color[std::size_t(y * side + x)];
            EXPECT_EQ(s.w, p.w);
            const dvec3 linear = barycentrics({x + 0.5, y + 0.5}, places[0], places[1], places[2]);
            if (p.w == 0 || std::min({linear.x, linear.y, linear.z}) < 0.01)
                continue;  // at the edges they stay in the triangle
            const dvec3 per_w = {linear.x / 2, linear.y / 2, linear.z / 9};
            const double sum = per_w.x + per_w.y + per_w.z;
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(double(s.xyz()[k]), linear[k], 2e-3);
                EXPECT_NEAR(double(p.xyz()[k]), per_w[k] / sum, 2e-3);
            }
            most = std::max(most, std::fabs(double(s.z - p.z)));
            ++seen;
        }
    EXPECT_GT(seen, 500);
    EXPECT_GT(most, 0.3);
}

TEST(Interpolation, IsTheSameInParallelViews) {
    const Scene scene = triangle({-1.5f, -1, -2}, {1.5f, -1, -2}, {0, 1.5f, -9});
    EXPECT_EQ(draw(scene, AttributeInterpolation::screen, true).color,
              draw(scene, AttributeInterpolation::perspective, true).color);
}

TEST(Interpolation, OnTheScreenIsRightAtTheCornersThatClippingMakes) {
    // A floor through the eye plane: cut at the near plane, 0.5 m before the eye.
    const vec3 a{-3, -0.4f, 2}, b{3, -0.4f, 2}, c{0, -0.4f, -12};
    const Scene scene = triangle(a, b, c);
    const Frame screen = draw(scene, AttributeInterpolation::screen),
                perspective = draw(scene, AttributeInterpolation::perspective);
    int seen = 0;
    for (std::size_t i = 0; i < screen.color.size(); ++i) {
        const vec4 s = screen.color[i], p = perspective.color[i];
        EXPECT_EQ(s.w, p.w);
        if (s.w == 0) continue;
        EXPECT_NEAR(s.x + s.y + s.z, 1, 1e-4f);
        ++seen;
    }
    EXPECT_GT(seen, 500);
    const auto bottom = std::size_t((side - 1) * side + side / 2), tip = std::size_t((side / 2 + 2) * side + side / 2);
    EXPECT_NEAR(screen.color[bottom].z, perspective.color[bottom].z, 0.02f) << "near the cut";
    EXPECT_GT(perspective.color[tip].z, 0.5f);
    const Frame window = draw(scene, AttributeInterpolation::screen, false, {30, 50, 40, 40});
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            ASSERT_EQ(window.color[std::size_t(y * 40 + x)], screen.color[std::size_t((y + 50) * side + x + 30)]);
}
