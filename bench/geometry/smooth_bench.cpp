// SPDX-License-Identifier: Apache-2.0
// Seam-free normals and tangents of a displaced sphere cut into objects, next to baselines: a plain loop, the
// publication's brute force, Assimp's generators. per_triangle is the figure to compare.
//   RAKELIGHT_BENCH_LARGE=1 smooth_bench --benchmark_filter='T:10000000/K:16/'     10M and 50M triangles are made only
//   when asked for
#include <benchmark/benchmark.h>

#include <compare>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>

#include "tools/bench/bench_baselines.h"
#ifdef RL_HAVE_ASSIMP
#include "geometry/assimp_generators.h"
#endif

namespace {

using namespace rakelight;

struct Case {
    std::uint64_t triangles;
    std::uint32_t objects;
    bool shuffled;
    auto operator<=>(const Case&) const = default;
};

constexpr std::uint64_t large = 1'000'001;

// Repetitions are interleaved, so models are kept; of large ones only the last: 50 million triangles are two gigabytes.
const BenchModel& model_of(const Case& c) {
    static std::map<Case, BenchModel> made;
    if (const auto at = made.find(c); at != made.end()) return at->second;
    if (c.triangles >= large) std::erase_if(made, [](const auto& m) { return m.first.triangles >= large; });
    return made[c] = make_bench_sphere(c.triangles, c.objects, c.shuffled);
}

struct Buffers {
    std::vector<std::vector<vec3>> normals;
    std::vector<std::vector<vec4>> tangents;
    std::vector<AttributeBuffers> spans;
    explicit Buffers(const BenchModel& model) : normals(model.parts.size()), tangents(model.parts.size()) {
        for (std::size_t p = 0; p < model.parts.size(); ++p) {
            normals[p].resize(model.parts[p].positions.size());
            tangents[p].resize(model.parts[p].positions.size());
            spans.push_back({normals[p], tangents[p]});
        }
    }
};

void report(benchmark::State& state, const BenchModel& model) {
    state.counters["per_triangle"] = benchmark::Counter(
        double(model.triangles()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["triangles"] = double(model.triangles());
}

std::string name_of(const std::string& what, const Case& c) {
    return what + "/T:" + std::to_string(c.triangles) + "/K:" + std::to_string(c.objects) +
           (c.shuffled ? "/shuffled" : "/coherent");
}

benchmark::internal::Benchmark* add_untimed(const std::string& name, std::function<void(benchmark::State&)> body) {
    return benchmark::RegisterBenchmark(name.c_str(), std::move(body))
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
}
void add(const std::string& name, std::function<void(benchmark::State&)> body) {
    add_untimed(name, std::move(body))->UseRealTime();
}

template <class Loop>
void add_loop(const std::string& what, const Case& c, const Loop& loop) {
    add(name_of(what, c), [=](benchmark::State& state) {
        const BenchModel& model = model_of(c);
        Buffers out(model);
        for (auto _ : state) {
            loop(model, out.spans);
            benchmark::ClobberMemory();
        }
        report(state, model);
    });
}

// Into buffers and a workspace used before.
void add_smooth(const std::string& what, const Case& c, AttributeOptions options, double weld_edges = 0) {
    for (const int threads : {1, 2})
        add(name_of(what, c) + "/threads:" + std::to_string(threads), [=](benchmark::State& state) mutable {
            const BenchModel& model = model_of(c);
            options.weld_distance = weld_edges * model.grid_step;
            Buffers out(model);
            const auto meshes = model.meshes(options.tangents);
            AttributeWorkspace workspace;
            Context context({.threads = threads, .max_memory = 1ull << 37});
            for (auto _ : state)
                benchmark::DoNotOptimize(compute_attributes_into(meshes, options, out.spans, workspace, context));
            report(state, model);
        });
}

// The steps apart, normals only.
void add_steps(const Case& c, AttributeOptions options) {
    options.tangents = false;
    using Step = void (*)(const AttributePlan&, std::span<const AttributeMesh>, const AttributeOptions&, Context&);
    const auto step = [&](const char* what, Step body) {
        add(name_of(what, c), [=](benchmark::State& state) {
            const BenchModel& model = model_of(c);
            const auto meshes = model.meshes(false);
            Context context({.threads = 2, .max_memory = 1ull << 37});
            const AttributePlan plan = group(meshes, options, context);
            for (auto _ : state) body(plan, meshes, options, context);
            report(state, model);
        });
    };
    step("crease_60_group_and_accumulate",
         [](const AttributePlan&, std::span<const AttributeMesh> meshes, const AttributeOptions& o, Context& context) {
             accumulate(group(meshes, o, context), meshes, context);
         });
    step("crease_60_accumulate", [](const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                                    const AttributeOptions&, Context& context) { accumulate(plan, meshes, context); });
    step("crease_60_regroup", [](const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                                 const AttributeOptions& o, Context& context) { regroup(plan, meshes, o, context); });
}

void add_assimp([[maybe_unused]] const Case& c) {
#ifdef RL_HAVE_ASSIMP
    for (const bool tangents : {false, true})
        add_untimed(name_of(tangents ? "assimp_CalcTangentSpace" : "assimp_GenSmoothNormals", c),
                    [=](benchmark::State& state) {
                        const BenchModel& model = model_of(c);
                        for (auto _ : state) {
                            const bench::AssimpSeconds seconds = bench::assimp_generators(model);
                            state.SetIterationTime(tangents ? seconds.tangents : seconds.normals);
                        }
                        report(state, model);
                    })
            ->UseManualTime()
            ->Iterations(1);
#endif
}

void add_all(const Case& c) {
    AttributeOptions uniform;
    uniform.weight = CornerWeight::uniform;
    uniform.crease_angle_rad = pi;
    uniform.tangents = false;
    AttributeOptions with_tangents = uniform, creased = uniform, by_angle = uniform;
    with_tangents.tangents = true;
    creased.crease_angle_rad = radians(60);
    by_angle.weight = CornerWeight::angle;
    add_loop("plain_loop", c, plain_loop);
    add_smooth("normals", c, uniform);
    add_smooth("normals_tangents", c, with_tangents);
    add_smooth("normals_weight_angle", c, by_angle);
    add_smooth("crease_60_normals", c, creased);
    creased.tangents = true;
    add_smooth("crease_60_normals_tangents", c, creased);
    add_smooth("tolerance_normals", c, uniform, 0.1);
    add_steps(c, creased);
    if (!c.shuffled) add_assimp(c);
    if (c.triangles <= 50'000)
        add_loop("brute_force", c, [](const BenchModel& model, auto out) { brute_force(model, out, Context()); });
}

}  // namespace

int main(int argc, char** argv) {
    const bool with_large = std::getenv("RAKELIGHT_BENCH_LARGE") != nullptr;
    for (const std::uint64_t triangles : {10'000, 50'000, 100'000, 1'000'000, 10'000'000, 50'000'000})
        for (const std::uint32_t objects : {1, 16, 256})
            for (const bool shuffled : {false, true})
                if (triangles < large || with_large) add_all({triangles, objects, shuffled});
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
