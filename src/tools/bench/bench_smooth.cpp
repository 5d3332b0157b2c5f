// SPDX-License-Identifier: Apache-2.0
// Attributes against the plain loop. What one repetition measures is interleaved over all rows, so that a neighbor's
// load falls on all of them.
#include <rakelight/geometry/matching_borders.h>
#include <rakelight_internal/tools/bench_smooth.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>

#include <nlohmann/json.hpp>

#include "geometry/input/fast_memory.h"
#include "math/isa.h"
#include "tools/bench/bench_baselines.h"
#include "tools/bench/bench_memory.h"
#include "tools/report_json.h"

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

struct Measured {
    BenchRow row;
    std::function<void()> run;
    std::uint32_t most_repetitions = 1000;
    std::vector<double> seconds, cpu_seconds;
};

constexpr const char* plain_name = "plain loop, normals";
constexpr const char* brute_force_name = "brute force, normals";

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
          triangles_(double(model_.triangles())) {}

    SmoothBenchReport run() {
        SmoothBenchReport report{.triangles = model_.triangles(),
                                 .vertices = model_.vertices(),
                                 .objects = std::uint32_t(model_.parts.size()),
                                 .order = options_.shuffled ? "shuffled" : "coherent",
                                 .isa = name(isa_from_environment()),
                                 .huge_pages = true};
        report.copy_gb_per_s = copy_bandwidth(context_);
        AttributeOptions plain;
        plain.weight = options_.weight;
        plain.crease_angle_rad = options_.crease_angle_rad;
        plain.weld_distance = options_.weld_distance * model_.grid_step;
        add_pair("", model_, plain);
        AttributeOptions creased = plain;
        creased.crease_angle_rad = SmoothBenchOptions::crease_row_rad;
        if (options_.crease) add_smooth("crease 60, ", model_, creased);
        if (options_.tolerance) {
            AttributeOptions within = plain;
            within.weld_distance = SmoothBenchOptions::tolerance_row * model_.grid_step;
            add_smooth("tolerance 0.1 edges, ", model_, within);
        }
        if (options_.weights) add_weights(creased);
        if (options_.plan) add_plan(creased);
        if (options_.borders) add_borders(creased);
        if (options_.order) {
            other_ = make_bench_sphere(options_.triangles, options_.objects, !options_.shuffled);
            add_pair(options_.shuffled ? "coherent, " : "shuffled, ", other_, plain);
        }
        if (options_.brute_force) {
            add_loop(brute_force_name, model_,
                     [this](const BenchModel& model, auto out) { brute_force(model, out, context_); });
            measured_.back().most_repetitions = 1;
        }
        repeat();
        for (Measured& m : measured_) report.rows.push_back(finished(m));
        add_ratios(report.rows);
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
        context_.throw_if_cancelled();
    }

    template <class Loop>
    void add_loop(const std::string& what, const BenchModel& model, const Loop& loop) {
        auto out = std::make_shared<Outputs>(model, false);
        add(what, 1, [=, &model] { loop(model, out->spans); });
    }

    void add_pair(const std::string& prefix, const BenchModel& model, const AttributeOptions& attributes) {
        add_loop(prefix + plain_name, model, plain_loop);
        add_smooth(prefix, model, attributes);
    }

    // Normals, then normals and tangents, into buffers.
    void add_smooth(const std::string& prefix, const BenchModel& model, AttributeOptions attributes) {
        for (const bool tangents : {false, true}) {
            attributes.tangents = tangents;
            const MemoryPeak peak;
            auto out = std::make_shared<Outputs>(model, tangents);
            auto workspace = std::make_shared<AttributeWorkspace>();
            const auto meshes = model.meshes(tangents);
            add(prefix + (tangents ? "normals + tangents" : "normals"), context_.threads(),
                [=, this] { compute_attributes_into(meshes, attributes, out->spans, *workspace, context_); });
            const double held = double(peak.bytes()) - double(out->bytes());
            measured_.back().row.bytes_per_triangle = std::max(held, double(workspace->bytes())) / triangles_;
        }
    }

    void add_weights(AttributeOptions attributes) {
        few_ = make_waved_sphere(options_.triangles, options_.objects, 1.0 / 6);
        waved_ = make_waved_sphere(options_.triangles, options_.objects, 1);
        attributes.weight = CornerWeight::angle;
        add_smooth("angle, crease 60, ", model_, attributes);
        add_smooth("angle, crease 60, waves, ", waved_, attributes);
        attributes.weight = CornerWeight::automatic;
        add_smooth("auto, a sixth fitted, ", few_, attributes);
        add_smooth("auto, all fitted, ", waved_, attributes);
        add_smooth("auto, all noise, ", model_, attributes);
    }

    // The steps apart, normals only: what a pose saves, and what a moved crease saves.
    void add_plan(AttributeOptions attributes) {
        attributes.tangents = false;
        const auto meshes = model_.meshes(false);
        const auto plan = std::make_shared<AttributePlan>(group(meshes, attributes, context_));
        const auto step = [&](const char* what, std::function<void()> body) {
            const MemoryPeak peak;
            add(std::string("crease 60, ") + what, context_.threads(), std::move(body));
            measured_.back().row.bytes_per_triangle = double(peak.bytes()) / triangles_;
        };
        step("group + accumulate", [=, this] { accumulate(group(meshes, attributes, context_), meshes, context_); });
        step("accumulate only (pose)", [=, this] { accumulate(*plan, meshes, context_); });
        step("regroup + accumulate", [=, this]() mutable {
            attributes.crease_angle_rad += radians(0.01);
            accumulate(regroup(*plan, meshes, attributes, context_), meshes, context_);
        });
        step("group", [=, this] { group(meshes, attributes, context_); });
        step("regroup (crease moved)", [=, this]() mutable {
            attributes.crease_angle_rad += radians(0.01);
            regroup(*plan, meshes, attributes, context_);
        });
    }

    // Whole attributes of a model whose neighbors share no vertices: as they are, and joined along their borders.
    void add_borders(AttributeOptions attributes) {
        uneven_ = make_uneven_sphere(options_.triangles, options_.objects);
        attributes.tangents = false;
        auto out = std::make_shared<Outputs>(uneven_, false);
        auto workspace = std::make_shared<AttributeWorkspace>();
        const auto plain = uneven_.meshes(false);
        const auto smooth = [=, this] { compute_attributes_into(plain, attributes, out->spans, *workspace, context_); };
        const MatchOptions match{.distance = uneven_.grid_step / 4,
                                 .crease_angle_rad = attributes.crease_angle_rad,
                                 .weld_distance = attributes.weld_distance,
                                 .weight = attributes.weight};
        add("uneven, normals", context_.threads(), smooth);
        add("uneven, normals + borders", context_.threads(), [=, this] {
            smooth();
            std::vector<AttributeMesh> meshes = plain;
            for (std::size_t m = 0; m < meshes.size(); ++m) meshes[m].normals = out->spans[m].normals;
            MatchReport report;
            join_borders(match_borders(meshes, match, context_), meshes, {}, report, context_);
            if (report.following == 0) throw Error(ErrorCode::failed, "no borders of the model match");
        });
    }

    // What one repetition measures is interleaved over all rows.
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
        return m.row;
    }

    static void add_ratios(std::vector<BenchRow>& rows) {
        const auto ns_of = [&](const char* what) {
            for (const BenchRow& row : rows)
                if (row.what == what) return row.ns_per_triangle;
            return 0.0;
        };
        const double plain = ns_of(plain_name), brute = ns_of(brute_force_name);
        for (BenchRow& row : rows) {
            row.ratio_to_plain = plain > 0 ? row.ns_per_triangle / plain : 0;
            row.ratio_to_brute_force = brute > 0 ? row.ns_per_triangle / brute : 0;
        }
    }

    SmoothBenchOptions options_;
    Context& context_;
    BenchModel model_, other_, uneven_, few_, waved_;  ///< other_: in the other order; few_, waved_: of add_weights()
    double triangles_;
    std::vector<Measured> measured_;
};

}  // namespace

SmoothBenchReport bench_smooth(const SmoothBenchOptions& options, Context& context) {
    check(options);
    // 36 bytes per triangle of input, 14 of output, twice the normals, and the scratch of the stages.
    context.memory().check(
        options.triangles * (100 + (options.order ? 60 : 0) + (options.borders ? 60 : 0) + (options.weights ? 120 : 0)),
        "the model to measure");
    return SmoothBench(options, context).run();
}

std::string to_json(const SmoothBenchReport& report) {
    Json rows = Json::array();
    for (const BenchRow& r : report.rows)
        rows.push_back({{"what", r.what},
                        {"threads", r.threads},
                        {"ns_per_triangle", r.ns_per_triangle},
                        {"fastest_ns_per_triangle", r.fastest_ns},
                        {"slowest_ns_per_triangle", r.slowest_ns},
                        {"cpu_ns_per_triangle", r.cpu_ns_per_triangle},
                        {"cold_ns_per_triangle", r.cold_ns_per_triangle},
                        {"bytes_per_triangle", r.bytes_per_triangle},
                        {"ratio_to_plain", r.ratio_to_plain},
                        {"ratio_to_brute_force", r.ratio_to_brute_force}});
    Json json = {{"schema", "rakelight.bench/1"},
                 {"rows", rows},
                 {"triangles", report.triangles},
                 {"vertices", report.vertices},
                 {"objects", report.objects},
                 {"order", report.order},
                 {"isa", report.isa},
                 {"huge_pages", report.huge_pages},
                 {"copy_gb_per_s", report.copy_gb_per_s}};
    return json_text(json);
}

std::string to_text(const SmoothBenchReport& report) {
    char line[256];
    const auto format = [&](auto... values) {
        std::snprintf(line, sizeof line, values...);
        return std::string(line);
    };
    std::string text =
        format("%llu triangles, %llu vertices, %u objects, %s; %s; copying %.1f GB/s\n",
               static_cast<unsigned long long>(report.triangles), static_cast<unsigned long long>(report.vertices),
               report.objects, report.order.c_str(), report.isa.c_str(), report.copy_gb_per_s);
    text +=
        "ns a triangle                             threads   median    (fastest  slowest)      CPU     cold  bytes  to "
        "plain\n";
    for (const BenchRow& r : report.rows)
        text += format("%-40s %8d %8.2f    %9.2f %9.2f %8.2f %8.2f %6.1f %9.2f\n", r.what.c_str(), r.threads,
                       r.ns_per_triangle, r.fastest_ns, r.slowest_ns, r.cpu_ns_per_triangle, r.cold_ns_per_triangle,
                       r.bytes_per_triangle, r.ratio_to_plain);
    return text;
}

}  // namespace rakelight
