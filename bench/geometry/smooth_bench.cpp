// SPDX-License-Identifier: Apache-2.0
// Seam-free normals and tangents of a displaced sphere cut into objects, beside the plain loop that everybody writes: one
// thread, face normals summed per vertex, objects apart (so with seams). per_triangle is the figure to compare; run with
//   smooth_bench --benchmark_repetitions=10 --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true
#include <benchmark/benchmark.h>
#include <rakelight/attributes.h>

#include <cmath>
#include <map>
#include <memory>
#include <random>

#include "math/linear.h"

namespace {

using namespace rakelight;

struct Part {
    std::vector<vec3> positions;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> indices;
};

// Rows of a UV sphere go to `objects` parts; each vertex is moved along its normal by up to a quarter of the grid's step, the
// same in all parts. Poles are left out, so no face is degenerate.
std::vector<Part> make_model(std::uint32_t triangles, std::uint32_t objects) {
    const std::uint32_t rows = std::uint32_t(std::sqrt(triangles / 4.0)), columns = 2 * rows;
    std::vector<vec3> ring((std::size_t(rows) + 1) * (columns + 1));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> height(0, 0.25 * pi / rows);
    for (std::uint32_t r = 0; r <= rows; ++r)
        for (std::uint32_t c = 0; c <= columns; ++c) {
            const double a = 2 * pi * (c % columns) / columns, b = pi * (r + 1) / (rows + 2), size = 1 + height(random);
            ring[std::size_t(r) * (columns + 1) + c] =
                c == columns ? ring[std::size_t(r) * (columns + 1)]
                             : vec3{float(size * std::sin(b) * std::cos(a)), float(-size * std::cos(b)), float(-size * std::sin(b) * std::sin(a))};
        }
    std::vector<Part> parts(objects);
    for (std::uint32_t k = 0; k < objects; ++k) {
        const std::uint32_t first = rows * k / objects, last = rows * (k + 1) / objects;
        for (std::uint32_t r = first; r <= last; ++r)
            for (std::uint32_t c = 0; c <= columns; ++c) {
                parts[k].positions.push_back(ring[std::size_t(r) * (columns + 1) + c]);
                parts[k].texcoords.push_back({float(c) / float(columns), float(r) / float(rows)});
            }
        for (std::uint32_t r = 0; r < last - first; ++r)
            for (std::uint32_t c = 0; c < columns; ++c) {
                const std::uint32_t a = r * (columns + 1) + c, d = a + columns + 1;
                parts[k].indices.insert(parts[k].indices.end(), {a, a + 1, d + 1, a, d + 1, d});
            }
    }
    return parts;
}

const std::vector<Part>& model(std::int64_t triangles, std::int64_t objects) {
    static std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Part>> made;
    auto& parts = made[{triangles, objects}];
    if (parts.empty()) parts = make_model(std::uint32_t(triangles), std::uint32_t(objects));
    return parts;
}

void report(benchmark::State& state, const std::vector<Part>& parts) {
    double triangles = 0;
    for (const Part& p : parts) triangles += double(p.indices.size() / 3);
    state.counters["per_triangle"] =
        benchmark::Counter(triangles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["triangles"] = triangles;
}

// range: triangles, objects, threads, crease [deg], tangents, weight
void smooth(benchmark::State& state) {
    const auto& parts = model(state.range(0), state.range(1));
    std::vector<AttributeMesh> meshes;
    for (const Part& p : parts) {
        AttributeMesh& m = meshes.emplace_back();
        m.object = std::uint32_t(meshes.size());
        m.positions = p.positions;
        m.indices = p.indices;
        if (state.range(4) != 0) m.texcoords = p.texcoords;
    }
    AttributeOptions options;
    options.crease_angle_rad = radians(double(state.range(3)));
    options.weight = CornerWeight(state.range(5));
    Context context({.threads = int(state.range(2)), .max_memory = 1ull << 36});
    for (auto _ : state) benchmark::DoNotOptimize(compute_attributes(meshes, options, context));
    report(state, parts);
}

// range: triangles, objects. Into buffers used before.
void plain_loop(benchmark::State& state) {
    const auto& parts = model(state.range(0), state.range(1));
    std::vector<std::vector<vec3>> normals;
    for (const Part& p : parts) normals.emplace_back(p.positions.size());
    for (auto _ : state) {
        for (std::size_t k = 0; k < parts.size(); ++k) {
            const Part& part = parts[k];
            std::vector<vec3>& out = normals[k];
            std::fill(out.begin(), out.end(), vec3{});
            for (std::size_t i = 0; i < part.indices.size(); i += 3) {
                const vec3 a = part.positions[part.indices[i]];
                vec3 n = cross(part.positions[part.indices[i + 1]] - a, part.positions[part.indices[i + 2]] - a);
                n = n * (1 / length(n));
                for (std::size_t c = 0; c < 3; ++c) out[part.indices[i + c]] += n;
            }
            for (vec3& n : out) n = n * (1 / length(n));
        }
        benchmark::DoNotOptimize(normals.data());
        benchmark::ClobberMemory();
    }
    report(state, parts);
}

constexpr int uniform = int(CornerWeight::uniform), angle = int(CornerWeight::angle);
BENCHMARK(plain_loop)->Args({100'000, 16})->Args({1'000'000, 16})->Args({10'000'000, 16})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(smooth)
    ->ArgNames({"triangles", "objects", "threads", "crease", "tangents", "weight"})
    ->Args({100'000, 16, 2, 180, 0, uniform})
    ->Args({1'000'000, 16, 2, 180, 0, uniform})
    ->Args({1'000'000, 16, 1, 180, 0, uniform})
    ->Args({1'000'000, 1, 2, 180, 0, uniform})
    ->Args({1'000'000, 16, 2, 180, 0, angle})
    ->Args({1'000'000, 16, 2, 180, 1, uniform})
    ->Args({1'000'000, 16, 2, 60, 0, uniform})
    ->Args({1'000'000, 16, 2, 60, 1, angle})
    ->Args({10'000'000, 16, 2, 180, 0, uniform})
    ->Args({10'000'000, 16, 2, 180, 1, uniform})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
