// SPDX-License-Identifier: Apache-2.0
// Transparent triangles that cross at random: the soft engine sorts them pixel by pixel, rays meet them one after the
// other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "engines/raster/raster_engine.h"
#include "engines/raytrace/raytrace_engine.h"
#include "math/linear.h"
#include "shading/sample_positions.h"
#include "support/scene_builder.h"

namespace rakelight::raytrace {
namespace {

constexpr int width = 48, height = 36;

Camera view() {
    Camera camera;
    camera.to_world = translation(dvec3{0, 0, 3});
    camera.vertical_fov_rad = radians(45);
    camera.z_near = 0.1, camera.z_far = 100;
    return camera;
}

/// 4 to 15 triangles, one in five of them opaque.
Scene random_scene(unsigned seed) {
    Scene scene;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> part(0, 1);
    const auto anywhere = [&] {
        return vec3{3 * part(random) - 1.5f, 2.4f * part(random) - 1.2f, 2.4f * part(random) - 1.2f};
    };
    const int count = 4 + int(random() % 12);
    for (int n = 0; n < count; ++n) {
        Material m;
        m.model = MaterialModel::unlit;
        m.double_sided = true;
        m.alpha_mode = random() % 5 == 0 ? AlphaMode::opaque : AlphaMode::blend;
        m.base_color = {part(random), part(random), part(random), 0.2f + 0.6f * part(random)};
        scene.materials.push_back(m);
        Mesh mesh;
        mesh.material = std::uint32_t(n);
        mesh.positions = std::vector<vec3>{anywhere(), anywhere(), anywhere()};
        mesh.indices = std::vector<std::uint32_t>{0, 1, 2};
        test::add_object(scene, std::move(mesh));
    }
    return scene;
}

/// The triangles that the ray through a place of the picture meets, by distance.
std::vector<std::size_t> met_at(const Scene& scene, double px, double py) {
    const double scale = std::tan(radians(22.5)) / (height / 2.0);
    const dvec3 o{0, 0, 3}, d{(px - width / 2.0) * scale, (height / 2.0 - py) * scale, -1};
    std::vector<std::pair<double, std::size_t>> met;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const auto corner = [&](std::size_t k) { return cast<double>(scene.meshes[i].positions[k]); };
        const dvec3 e1 = corner(1) - corner(0), e2 = corner(2) - corner(0), s = o - corner(0);
        const dvec3 p = cross(d, e2), q = cross(s, e1);
        const double det = dot(e1, p), u = dot(s, p) / det, v = dot(d, q) / det, t = dot(e2, q) / det;
        if (u >= 0 && v >= 0 && u + v <= 1 && t > 0.1) met.emplace_back(t, i);
    }
    std::sort(met.begin(), met.end());
    std::vector<std::size_t> order;
    for (const auto& [t, i] : met) order.push_back(i);
    return order;
}

/// [pixels] All lies in front of the eye.
dvec2 projected(vec3 p) {
    const double scale = height / 2.0 / (std::tan(radians(22.5)) * (3 - double(p.z)));
    return {width / 2.0 + double(p.x) * scale, height / 2.0 - double(p.y) * scale};
}

/// [pixels] From the edges of a triangle: of one that is thinner than a step, none is met beside a sample.
double edge_distance(const Mesh& mesh, dvec2 place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const dvec2 a = projected(mesh.positions[k]), edge = projected(mesh.positions[(k + 1) % 3]) - a;
        const double length2 = edge.x * edge.x + edge.y * edge.y;
        const dvec2 to = place - a;
        const double t = length2 > 0 ? std::clamp((to.x * edge.x + to.y * edge.y) / length2, 0.0, 1.0) : 0;
        nearest = std::min(nearest, std::hypot(to.x - t * edge.x, to.y - t * edge.y));
    }
    return nearest;
}

/// Close beside a sample of the pixel are an edge, other triangles or another order: rounding decides.
bool is_at_edge(const Scene& scene, std::size_t pixel, int samples) {
    constexpr double step = 0.02;
    for (const shading::SamplePosition p : shading::sample_positions(samples)) {
        const double px = double(pixel % width) + 0.5 + p.x / 16.0, py = double(pixel / width) + 0.5 + p.y / 16.0;
        for (const Mesh& mesh : scene.meshes)
            if (edge_distance(mesh, {px, py}) < step) return true;
        const std::vector<std::size_t> here = met_at(scene, px, py);
        for (const dvec2 d : {dvec2{-step, -step}, {step, -step}, {-step, step}, {step, step}})
            if (met_at(scene, px + d.x, py + d.y) != here) return true;
    }
    return false;
}

Frame drawn(Engine& engine, const Scene& scene, int samples) {
    Context context({.threads = 2});
    engine.prepare(scene, context);
    Frame frame;
    engine.render(view(), {.width = width, .height = height, .samples = samples, .background = {1, 1, 1, 1}}, frame,
                  context);
    return frame;
}

double display(float linear) {
    const double v = std::clamp(double(linear), 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

double difference(vec4 a, vec4 b) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::fabs(display(a[c]) - display(b[c])));
    return most;
}

void expect_equal_pictures(unsigned seed, int samples) {
    const Scene scene = random_scene(seed);
    const Frame soft = drawn(*raster::make_engine(), scene, samples), trace = drawn(*make_engine(), scene, samples);
    std::size_t judged = 0;
    for (std::size_t i = 0; i < soft.color.size(); ++i) {
        if (is_at_edge(scene, i, samples)) continue;
        ++judged;
        ASSERT_LE(difference(soft.color[i], trace.color[i]), 1 / 255.0)
            << "seed " << seed << ", pixel " << i % width << ", " << i / width << ", " << samples << " samples";
    }
    EXPECT_GT(judged, soft.color.size() / 2) << seed;
}

TEST(CrossingSurfaces, OfTwoHundredRandomScenesAreInOneOrderInSoftAndTrace) {
    for (unsigned seed = 0; seed < 200; ++seed) expect_equal_pictures(seed, 1);
}

TEST(CrossingSurfaces, AreInOneOrderAtSamplesToo) {
    for (unsigned seed = 0; seed < 40; ++seed) expect_equal_pictures(seed, 4);
}

}  // namespace
}  // namespace rakelight::raytrace
