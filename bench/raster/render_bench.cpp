// SPDX-License-Identifier: Apache-2.0
// Pictures of 1920 x 1080 by the soft engine: a bumpy ball in 100 objects with color and normal map under two point lights.
// The baseline is the same picture by the scalar flavor of the kernels, in the same run. per_pixel counts the pixels of the
// picture, per_triangle those of the model. The tiles are consumed by a sink that keeps nothing.
//   render_bench --benchmark_repetitions=10 --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true
#include <benchmark/benchmark.h>
#include <rakelight/engines/engine.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/render/render.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include "math/linear.h"

namespace {

using namespace rakelight;

constexpr int width = 1920, height = 1080;

class ConsumingSink final : public Sink {
public:
    void begin(int, int, Window, std::uint32_t) override {}
    void tile(const Tile& tile) override { benchmark::DoNotOptimize(tile.color.data()); }
    void end_pass(int) override { benchmark::ClobberMemory(); }
};

/// A texture made in code: three bytes per texel, color(x, y).
template <class Color>
TextureUse add_texture(Scene& scene, int size, const Color& color) {
    Pixels pixels;
    pixels.width = pixels.height = size;
    pixels.channels = 3;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (const int c : color(x, y)) pixels.bytes.push_back(std::byte(c));
    auto image = std::make_shared<EncodedImage>();
    image->name = "made in code";
    image->decode = [pixels](const EncodedImage&, Context&) { return pixels; };
    scene.textures.push_back({"texture", image, {}});
    TextureUse use;
    use.texture = std::uint32_t(scene.textures.size() - 1);
    return use;
}

Material bumpy_material(Scene& scene) {
    constexpr int size = 1024;
    Material m;
    m.name = "bumpy";
    m.model = MaterialModel::classical;
    m.classical.specular = {0.3f, 0.3f, 0.3f};
    m.base_color_texture = add_texture(scene, size, [](int x, int y) {
        return std::array{128 + x % 128, 128 + y % 128, 160};
    });
    m.normal_texture = add_texture(scene, size, [](int x, int y) {
        const double dx = 0.4 * std::sin(x * 0.2), dy = 0.4 * std::cos(y * 0.2), z = std::sqrt(1 - dx * dx - dy * dy);
        return std::array{int(127.5 * (1 + dx)), int(127.5 * (1 + dy)), int(127.5 * (1 + z))};
    });
    return m;
}

/// Patch (row, column) of ten by ten of a ball without poles, as an object of its own of 2 * side * side triangles.
Mesh patch(int row, int column, int side) {
    std::vector<vec3> positions;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> indices;
    for (int r = 0; r <= side; ++r)
        for (int c = 0; c <= side; ++c) {
            const double u = (column + double(c) / side) / 10, v = (row + double(r) / side) / 10;
            const double a = 2 * pi * u, b = pi * (0.02 + 0.96 * v),
                         size = 1 + 0.02 * std::sin(40 * u * pi) * std::sin(30 * v * pi);
            positions.push_back({float(size * std::sin(b) * std::sin(a)), float(size * std::cos(b)),
                                 float(size * std::sin(b) * std::cos(a))});
            texcoords.push_back({float(4 * u), float(2 * v)});
        }
    for (int r = 0; r < side; ++r)
        for (int c = 0; c < side; ++c) {
            const auto i = std::uint32_t(r * (side + 1) + c), below = i + std::uint32_t(side) + 1;
            indices.insert(indices.end(), {i, below, below + 1, i, below + 1, i + 1});
        }
    Mesh mesh;
    mesh.positions = std::move(positions);
    mesh.texcoords.emplace_back(std::move(texcoords));
    mesh.indices = std::move(indices);
    mesh.material = 0;
    return mesh;
}

Light lamp(dvec3 position, vec3 color) {
    Light light;
    light.position = position;
    light.diffuse = light.specular = color;
    light.quadratic = 0.05f;
    return light;
}

const Scene& ball(std::int64_t triangles, Context& context) {
    static std::map<std::int64_t, Scene> made;
    Scene& scene = made[triangles];
    if (!scene.meshes.empty()) return scene;
    scene.materials.push_back(bumpy_material(scene));
    const int side = int(std::lround(std::sqrt(double(triangles) / 200)));
    for (int row = 0; row < 10; ++row)
        for (int column = 0; column < 10; ++column) {
            scene.meshes.push_back(patch(row, column, side));
            Node node;
            node.name = "patch " + std::to_string(scene.nodes.size());
            node.meshes = {std::uint32_t(scene.meshes.size() - 1)};
            scene.nodes.push_back(std::move(node));
        }
    scene.lights = {lamp({3, 3, 4}, {0.9f, 0.85f, 0.8f}), lamp({-4, 1, 2}, {0.3f, 0.4f, 0.6f})};
    PrepareOptions options;
    options.normals = NormalSource::model;
    scene = prepare_scene(scene, options, context);
    return scene;
}

Camera camera() {
    Camera c;
    c.to_world = look_at(dvec3{0.5, 0.8, 3.0}, dvec3{0, 0, 0}, dvec3{0, 1, 0});
    return c;
}

// range: triangles, threads; isa: a word of RAKELIGHT_ISA, empty for the best that the processor has
void picture(benchmark::State& state, const std::string& isa) {
    Context context({.threads = int(state.range(1)), .max_memory = 1ull << 34});
    const Scene& scene = ball(state.range(0), context);
    isa.empty() ? ::unsetenv("RAKELIGHT_ISA") : ::setenv("RAKELIGHT_ISA", isa.c_str(), 1);
    const auto engine = make_engine("soft");
    engine->prepare(scene, context);
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    ConsumingSink sink;
    RenderStats stats;
    for (auto _ : state) stats = engine->render(camera(), settings, sink, context);
    if (stats.pixels_covered < std::uint64_t(width) * height / 4) state.SkipWithError("the ball is not in the picture");
    const auto each = [](double count) {
        return benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    };
    state.counters["per_pixel"] = each(double(width) * height);
    state.counters["per_triangle"] = each(double(stats.triangles_in));
    state.counters["shaded"] = double(stats.pixels_shaded);
}

// What an edit costs: prepare() by a new engine, mip chains included.
void prepare(benchmark::State& state) {
    Context context({.threads = int(state.range(1)), .max_memory = 1ull << 34});
    const Scene& scene = ball(state.range(0), context);
    for (auto _ : state) {
        const auto engine = make_engine("soft");
        engine->prepare(scene, context);
        benchmark::DoNotOptimize(engine.get());
    }
}

void sizes(benchmark::internal::Benchmark* b) {
    b->ArgNames({"triangles", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
    for (const std::int64_t triangles : {10'000, 100'000, 1'000'000}) b->Args({triangles, 2});
    b->Args({100'000, 1});
}

BENCHMARK_CAPTURE(picture, scalar_baseline, "scalar")->Apply(sizes);
BENCHMARK_CAPTURE(picture, best_isa, "")->Apply(sizes);
BENCHMARK(prepare)
    ->ArgNames({"triangles", "threads"})
    ->Args({100'000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
