// SPDX-License-Identifier: Apache-2.0
#include "tools/bench/bench_scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/functions.h"
#include "math/linear.h"
#include "tools/bench/bench_shapes.h"
#include "tools/bench/bench_textures.h"

namespace rakelight {
namespace {

constexpr double half_view = radians(20), aspect = 16.0 / 9.0, nearest = 8, farthest = 14;

/// Random numbers by splitmix64 (Steele, Lea & Flood 2014): those of <random>'s distributions differ between libraries.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    double unit() { return double(bits() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }

private:
    std::uint64_t state_;
};

/// A turn that favors no direction (Shoemake 1992, "Uniform random rotations").
dquat any_rotation(Random& random) {
    const double s = random.unit(), a = 2 * pi * random.unit(), b = 2 * pi * random.unit();
    const double p = std::sqrt(1 - s), q = std::sqrt(s);
    return {p * math::sin(a), p * math::cos(a), q * math::sin(b), q * math::cos(b)};
}

double fraction(double x) { return x - double(std::int64_t(x)); }

/// Places on the picture by the sequence of Roberts 2018 (powers of the plastic number): even, but no grid.
Transform placement(std::uint32_t number, std::uint32_t objects, Random& random) {
    const double x = 2 * fraction(0.5 + (number + 1) * 0.7548776662466927) - 1;
    const double y = 2 * fraction(0.5 + (number + 1) * 0.5698402909980532) - 1;
    const double depth = random.between(nearest, farthest);
    const double height = depth * math::sin(half_view) / math::cos(half_view);
    Transform t;
    t.translation = {0.94 * x * aspect * height, 0.92 * y * height, -depth};
    const double size = random.between(0.124, 0.177) * height * std::sqrt(100.0 / objects);
    t.scale = {size, size, size};
    t.rotation = any_rotation(random);
    return t;
}

Material material(Random& random) {
    Material m;
    m.model = MaterialModel::classical;
    const double red = random.between(0.35, 1), green = random.between(0.35, 1), blue = random.between(0.35, 1);
    m.base_color = {float(red), float(green), float(blue), 1};
    m.classical.ambient = {m.base_color.x, m.base_color.y, m.base_color.z};
    m.classical.specular = {0.35f, 0.35f, 0.35f};
    m.classical.shininess = 48;
    m.base_color_texture.texture = 0;
    m.normal_texture.texture = 1;
    return m;
}

std::vector<Light> large_lights(std::uint32_t count) {
    std::vector<Light> lights;
    constexpr dvec3 places[bench_lights_max] = {{-6, 5, -2}, {7, 3, -3}, {0, -6, -4},  {-8, -2, -6},
                                                {8, -5, -8}, {3, 7, -9}, {-4, 8, -12}, {0, 1, 0}};
    constexpr vec3 colors[bench_lights_max] = {{1, 0.93f, 0.82f}, {0.7f, 0.82f, 1}, {1, 0.6f, 0.5f}, {0.6f, 1, 0.7f},
                                               {0.9f, 0.8f, 1},   {1, 1, 0.7f},     {0.5f, 0.8f, 1}, {1, 1, 1}};
    for (std::uint32_t i = 0; i < count; ++i) {
        Light light;
        light.name = "light " + std::to_string(i + 1);
        light.position = places[i];
        light.diffuse = light.specular = colors[i] * (4.0f / float(count));
        light.ambient = light.diffuse * 0.08f;
        light.constant = 0.5f;
        light.linear = 0.05f;
        light.quadratic = 0.02f;
        lights.push_back(light);
    }
    return lights;
}

/// Evenly in the space of the objects, of all colors.
std::vector<Light> small_lights(std::uint32_t count) {
    Random random(2);
    std::vector<Light> lights;
    for (std::uint32_t i = 0; i < count; ++i) {
        Light light;
        light.name = "light " + std::to_string(i + 1);
        light.units = LightUnits::photometric;
        light.position = placement(i, count, random).translation;
        const double red = random.between(0.2, 1), green = random.between(0.2, 1), blue = random.between(0.2, 1);
        light.color = {float(red), float(green), float(blue)};
        light.intensity = 0.5f;
        light.range = bench_small_range;
        lights.push_back(light);
    }
    return lights;
}

}  // namespace

std::vector<Light> make_bench_lights(std::uint32_t lights) {
    return lights <= bench_lights_max ? large_lights(lights) : small_lights(lights);
}

Scene make_bench_scene(std::uint64_t triangles, std::uint32_t objects, std::uint32_t lights, Context& context) {
    Scene scene;
    scene.source = "builtin:bench";
    scene.textures = make_bench_wall();
    std::vector<std::uint32_t> order(objects);
    std::iota(order.begin(), order.end(), 0u);
    Random random(1);
    for (std::uint32_t i = objects - 1; i > 0; --i) std::swap(order[i], order[random.bits() % (i + 1)]);
    std::vector<double> variants;
    for (const std::uint32_t number : order) {
        const std::string name = "object " + std::to_string(number);
        Node node;
        node.name = name;
        node.local = placement(number, objects, random);
        node.meshes = {std::uint32_t(scene.nodes.size())};
        scene.nodes.push_back(std::move(node));
        scene.materials.push_back(material(random));
        scene.materials.back().name = name;
        variants.push_back(random.unit());
    }
    scene.meshes.resize(objects);
    context.parallel_for(objects, [&](std::size_t i) {
        const std::uint64_t share = triangles * (i + 1) / objects - triangles * i / objects;
        scene.meshes[i] = make_bench_shape(BenchShape(order[i] % 3), share, variants[i], context);
        scene.meshes[i].name = scene.nodes[i].name;
        scene.meshes[i].material = std::uint32_t(i);
    });
    scene.lights = make_bench_lights(lights);
    Camera camera;
    camera.name = "camera";
    camera.vertical_fov_rad = 2 * half_view;
    camera.z_near = 1;
    camera.z_far = 100;
    scene.cameras.push_back(camera);
    return scene;
}

}  // namespace rakelight
