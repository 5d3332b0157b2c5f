// SPDX-License-Identifier: Apache-2.0
// Attributes against the plain loop. What one repetition measures is interleaved over all rows, so that a neighbor's
// load falls on all of them.
#include <rakelight/bench.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <ctime>
#include <functional>
#include <memory>

#include "geometry/fast_memory.h"
#include "math/isa.h"
#include "math/linear.h"
#include "tools/bench_memory.h"
#include "tools/bench_model.h"

namespace rakelight {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Outputs {
    std::vector<geometry::LargeArray<vec3>> normals;
    std::vector<geometry::LargeArray<vec4>> tangents;
    std::vector<AttributeBuffers> spans;

    Outputs(const BenchModel& model, bool with_tangents) : normals(model.parts.size()), tangents(model.parts.size()) {
        for (std::size_t p = 0; p < model.parts.size(); ++p) {
            const std::size_t count = model.parts[p].positions.size();
            normals[p].reserve(count);
            if (with_tangents) tangents[p].reserve(count);
            spans.push_back({{normals[p].data(), count}, {tangents[p].data(), with_tangents ? count : 0}});
        }
    }
    std::uint64_t bytes() const {
        std::uint64_t sum = 0;
        for (const auto& array : normals) sum += array.bytes();
        for (const auto& array : tangents) sum += array.bytes();
        return sum;
    }
};

// What everybody writes.
void plain_loop(const BenchModel& model, const std::vector<AttributeBuffers>& out) {
    for (std::size_t k = 0; k < model.parts.size(); ++k) {
        const BenchPart& part = model.parts[k];
        vec3* const normals = out[k].normals.data();
        std::fill_n(normals, part.positions.size(), vec3{});
        const vec3* const positions = part.positions.data();
        const std::uint32_t* const indices = part.indices.data();
        const std::size_t corners = part.indices.size();
        for (std::size_t i = 0; i < corners; i += 3) {
            const vec3 a = positions[indices[i]];
            vec3 n = cross(positions[indices[i + 1]] - a, positions[indices[i + 2]] - a);
            n = n * (1 / length(n));
            for (std::size_t c = 0; c < 3; ++c) normals[indices[i + c]] += n;
        }
        for (std::size_t v = 0; v < part.positions.size(); ++v) normals[v] = normals[v] * (1 / length(normals[v]));
    }
}

// The publication's way: for every vertex, all faces of all objects, by equal positions.
void brute_force(const BenchModel& model, const std::vector<AttributeBuffers>& out) {
    struct Face {
        vec3 corner[3], normal;
    };
    std::vector<Face> faces;
    for (const BenchPart& part : model.parts)
        for (std::size_t i = 0; i < part.indices.size(); i += 3) {
            Face f;
            for (std::size_t k = 0; k < 3; ++k) f.corner[k] = part.positions[part.indices[i + k]];
            f.normal = normalize_or(cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]), vec3{});
            faces.push_back(f);
        }
    for (std::size_t k = 0; k < model.parts.size(); ++k)
        for (std::size_t v = 0; v < model.parts[k].positions.size(); ++v) {
            const vec3 p = model.parts[k].positions[v];
            vec3 sum;
            for (const Face& f : faces)
                if (f.corner[0] == p || f.corner[1] == p || f.corner[2] == p) sum += f.normal;
            out[k].normals[v] = normalize_or(sum, vec3{0, 0, 1});
        }
}

double copy_bandwidth(Context& context) {
    constexpr std::size_t bytes = std::size_t(1) << 28, piece = std::size_t(1) << 24;
    geometry::LargeArray<char> from, to;
    from.reserve(bytes);
    to.reserve(bytes);
    std::memset(from.data(), 1, bytes);
    std::memset(to.data(), 2, bytes);
    double best = 0;
    for (int i = 0; i < 5; ++i) {
        const auto start = Clock::now();
        context.parallel_for(
            bytes / piece, [&](std::size_t p) { std::memcpy(to.data() + p * piece, from.data() + p * piece, piece); });
        best = std::max(best, 2.0 * double(bytes) / seconds_since(start));
    }
    return best * 1e-9;
}

struct Measured {
    BenchRow row;
    std::function<void()> run;
    std::uint32_t most_repetitions = 1000;
    std::vector<double> seconds, cpu_seconds;
};

void check(const SmoothBenchOptions& o) {
    const auto refuse = [](const char* text) { throw Error(ErrorCode::usage, text); };
    if (o.triangles < 100 || o.triangles > 1'000'000'000) refuse("triangles must be 100 to 1000000000");
    if (o.objects < 1 || o.objects > 100'000 || o.objects > o.triangles / 32)
        refuse("objects must be 1 to 100000, with 32 triangles or more each");
    if (o.repetitions < 1 || o.repetitions > 1000) refuse("repetitions must be 1 to 1000");
    if (!(o.weld_distance >= 0 && o.weld_distance <= 0.25)) refuse("the tolerance must be 0 to 0.25 edge lengths");
    if (!(o.crease_angle_rad >= 0 && o.crease_angle_rad <= pi + 1e-9))
        refuse("the crease angle must be 0 to 180 degrees");
    if (o.brute_force && o.triangles > 50'000) refuse("brute force is for 50000 triangles at most");
}

class SmoothBench {
public:
    SmoothBench(const SmoothBenchOptions& options, Context& context)
        : options_(options),
          context_(context),
          model_(make_bench_sphere(options.triangles, options.objects, options.shuffled)),
          triangles_(double(model_.triangles())),
          plain_out_(model_, false) {}

    SmoothBenchReport run() {
        SmoothBenchReport report{.triangles = model_.triangles(),
                                 .vertices = model_.vertices(),
                                 .objects = std::uint32_t(model_.parts.size()),
                                 .order = options_.shuffled ? "shuffled" : "coherent",
                                 .isa = name(isa_from_environment()),
                                 .huge_pages = true};
        report.copy_gb_per_s = copy_bandwidth(context_);
        add("plain loop, normals", 1, [this] { plain_loop(model_, plain_out_.spans); });
        add_smooth("normals", false);
        add_smooth("normals + tangents", true);
        if (options_.brute_force) {
            add("brute force, normals", 1, [this] { brute_force(model_, plain_out_.spans); });
            measured_.back().most_repetitions = 1;
        }
        repeat();
        for (Measured& m : measured_) report.rows.push_back(finished(m));
        return report;
    }

private:
    void add(std::string what, int threads, std::function<void()> run) {
        Measured& m = measured_.emplace_back();
        m.row.what = std::move(what);
        m.row.threads = threads;
        m.run = std::move(run);
        const auto start = Clock::now();
        m.run();
        m.row.cold_ns_per_triangle = seconds_since(start) * 1e9 / triangles_;
    }

    void add_smooth(const char* what, bool tangents) {
        AttributeOptions attributes;
        attributes.weight = options_.weight;
        attributes.crease_angle_rad = options_.crease_angle_rad;
        attributes.weld_distance = options_.weld_distance * model_.grid_step;
        attributes.tangents = tangents;
        const MemoryPeak peak;
        auto out = std::make_shared<Outputs>(model_, tangents);
        auto workspace = std::make_shared<AttributeWorkspace>();
        const auto meshes = model_.meshes(tangents);
        add(what, context_.threads(),
            [=, this] { compute_attributes_into(meshes, attributes, out->spans, *workspace, context_); });
        const double held = double(peak.bytes()) - double(out->bytes());
        measured_.back().row.bytes_per_triangle = std::max(held, double(workspace->bytes())) / triangles_;
    }

    void repeat() {
        for (std::uint32_t r = 0; r < options_.repetitions; ++r) {
            context_.throw_if_cancelled();
            for (Measured& m : measured_) {
                if (r >= m.most_repetitions) continue;
                const std::clock_t cpu = std::clock();
                const auto start = Clock::now();
                m.run();
                m.seconds.push_back(seconds_since(start));
                m.cpu_seconds.push_back(double(std::clock() - cpu) / CLOCKS_PER_SEC);
            }
            context_.progress("bench", double(r + 1) / options_.repetitions);
        }
    }

    BenchRow finished(Measured& m) const {
        std::sort(m.seconds.begin(), m.seconds.end());
        const auto ns = [&](double s) { return s * 1e9 / triangles_; };
        const std::size_t n = m.seconds.size();
        m.row.ns_per_triangle = ns(0.5 * (m.seconds[(n - 1) / 2] + m.seconds[n / 2]));
        std::sort(m.cpu_seconds.begin(), m.cpu_seconds.end());
        m.row.cpu_ns_per_triangle = ns(m.cpu_seconds[n / 2]);
        m.row.fastest_ns = ns(m.seconds.front());
        m.row.slowest_ns = ns(m.seconds.back());
        const double plain = measured_.front().row.ns_per_triangle;
        m.row.ratio_to_plain = plain > 0 ? m.row.ns_per_triangle / plain : 1;
        return m.row;
    }

    SmoothBenchOptions options_;
    Context& context_;
    BenchModel model_;
    double triangles_;
    Outputs plain_out_;
    std::vector<Measured> measured_;
};

}  // namespace

SmoothBenchReport bench_smooth(const SmoothBenchOptions& options, Context& context) {
    check(options);
    // 36 bytes a triangle of input, 14 of output, twice the normals, and the scratch of the stages.
    context.memory().check(options.triangles * 100, "the model to measure");
    return SmoothBench(options, context).run();
}

}  // namespace rakelight
