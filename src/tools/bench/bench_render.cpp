// SPDX-License-Identifier: Apache-2.0
// Pictures against the clock. Pictures of all engines are interleaved, so that a neighbor's load falls on all of them.
#include <rakelight_internal/tools/bench_render.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include <nlohmann/json.hpp>

#include <rakelight/render/picture.h>
#include <rakelight_internal/base/file_ending.h>

#include "base/format_text.h"
#include "engines/check_settings.h"
#include "render/draw_shot.h"
#include "render/engines.h"
#include "render/prepared_scene.h"
#include "render/shot.h"
#include "render/stopwatch.h"
#include "scene/placement.h"
#include "tools/bench/bench_export.h"
#include "tools/bench/bench_scene.h"
#include "tools/inspect/inspect_text.h"
#include "tools/report_json.h"

namespace rakelight {
namespace {

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

/// One engine and what its pictures took.
struct Measured {
    RenderBenchRow row;
    std::unique_ptr<Engine> engine;
    std::vector<double> ms, cpu_ms;
    std::vector<StageTimes> stages;

    double median_stage(double StageTimes::*stage) const {
        std::vector<double> values;
        for (const StageTimes& t : stages) values.push_back(t.*stage);
        return median(std::move(values));
    }
};

void check(const RenderBenchOptions& o) {
    const auto refuse = [](const char* text) { throw Error(ErrorCode::usage, text); };
    if (o.triangles < 100 || o.triangles > 100'000'000) refuse("triangles must be 100 to 100000000");
    if (o.objects < 1 || o.objects > 100'000) refuse("objects must be 1 to 100000");
    if (o.objects > o.triangles / 20)
        throw Error(
            ErrorCode::usage,
            format_text("{} triangles are too few for {} objects of 20 triangles or more each", o.triangles, o.objects),
            {}, "give fewer 'objects' or more 'triangles'")
            .naming({"objects", "triangles"});
    if (o.lights > bench_small_lights_max) refuse("lights must be 0 to 10000");
    for (const std::uint32_t lights : o.other_lights)
        if (lights > bench_small_lights_max) refuse("lights must be 0 to 10000");
    if (o.frames < 1 || o.frames > 10'000) refuse("frames must be 1 to 10000");
    if (o.engines.empty()) refuse("no engine to measure");
    for (const std::string& name : o.engines) check_engine_name(name);
    if (!o.export_file.empty() && file_ending(o.export_file) != "glb")
        throw Error(ErrorCode::usage, "scenes are exported as .glb").with_file(o.export_file);
    check_settings(o.settings);
    if (o.output.empty()) return;
    PictureRequest request;
    request.input = "builtin:bench";
    request.output = o.output;
    request.settings = o.settings;
    request.channel_files = o.picture.channel_files, request.half_colors = o.picture.half_colors;
    check_request(request);
}

class RenderBench {
public:
    RenderBench(const RenderBenchOptions& options, Context& context)
        : options_(options),
          context_(context),
          settings_(options.settings),
          scene_(options.scene.empty() ? built_in() : load(options.scene, options.load, context)) {
        decide();
    }

    RenderBenchReport run() {
        measured_.reserve(options_.engines.size() * (1 + options_.other_lights.size()));
        for (const std::string& name : options_.engines) {
            add_engine(name, scene_);
            for (const std::uint32_t lights : options_.other_lights) {
                Scene other = scene_;
                other.lights = make_bench_lights(lights);
                add_engine(name, other);
            }
        }
        for (std::uint32_t frame = 0; frame < options_.frames; ++frame) {
            for (Measured& m : measured_) draw(m);
            context_.progress("bench", double(frame + 1) / options_.frames);
        }
        if (!options_.output.empty()) write_picture();
        RenderBenchReport report = about_the_scene();
        for (Measured& m : measured_) report.rows.push_back(finished(m));
        return report;
    }

private:
    Scene built_in() {
        // All of it is closed; of classical materials both sides are drawn else.
        if (settings_.cull == Cull::automatic) settings_.cull = Cull::back;
        return make_bench_scene(options_.triangles, options_.objects, options_.lights, context_);
    }

    /// The loaded scene becomes the one that engines get.
    void decide() {
        PictureRequest request = options_.picture;
        request.input = options_.scene.empty() ? scene_.source : options_.scene;
        request.load = options_.load, request.settings = settings_, request.look = Look::plain;
        if (options_.scene.empty() && options_.lights == 0 && !request.lights)
            request.lights.emplace();  // none, no default ones
        const auto exported = [&](Scene scene) {
            if (!options_.export_file.empty()) export_bench_scene(scene, options_.export_file, context_);
            return scene;
        };
        Session session("soft");
        shot_ = decide_single(session, std::move(scene_), request, exported, {}, context_);
        scene_ = drawn_scene(*session.prepared_for(shot_, context_), shot_, context_);
        sink_.emplace(PixelFormat{}, ToneCurve(request.tone, shot_.behind));
    }

    void add_engine(const std::string& name, const Scene& scene) {
        Measured& m = measured_.emplace_back();
        m.engine = make_engine(name);
        m.row.engine = name;
        m.row.isa = engine_isa(name);
        m.row.threads = context_.threads();
        m.row.lights = std::uint32_t(scene.lights.size());
        Stopwatch watch;
        m.engine->prepare(scene, context_);
        m.row.prepare_ms = watch.lap_ms();
        m.engine->render(shot_.camera, shot_.settings, *sink_, context_);
        m.row.first_ms = watch.lap_ms();
    }

    void draw(Measured& m) {
        context_.throw_if_cancelled();
        const std::clock_t cpu = std::clock();
        const Stopwatch watch;
        m.row.stats = m.engine->render(shot_.camera, shot_.settings, *sink_, context_);
        m.ms.push_back(watch.ms());
        m.cpu_ms.push_back(1e3 * double(std::clock() - cpu) / CLOCKS_PER_SEC);
        m.stages.push_back(m.row.stats.times);
    }

    void write_picture() {
        PictureRequest request;
        request.output = options_.output;
        request.settings = settings_;
        request.tone = options_.picture.tone;
        request.channel_files = options_.picture.channel_files, request.half_colors = options_.picture.half_colors;
        FileTarget target(request);
        Session session(measured_.front().row.engine);
        session.set(std::make_shared<PreparedScene>(PreparedScene{scene_, {}}));
        Shot shot = plan_shot(scene_, request, shot_.camera, {.is_linear = target.is_linear()}, context_);
        shot.lights = scene_.lights;
        PictureResult result;
        draw_shot(session, shot, request, target, nullptr, result, context_);
    }

    RenderBenchReport about_the_scene() const {
        RenderBenchReport report{.scene = options_.scene.empty() ? "built-in" : options_.scene,
                                 .triangles = triangle_count(scene_),
                                 .width = options_.settings.width,
                                 .height = options_.settings.height,
                                 .frames = options_.frames};
        for (const Mesh& mesh : scene_.meshes) report.vertices += mesh.positions.size();
        for (const Node& node : scene_.nodes) report.objects += !node.meshes.empty();
        report.lights = std::uint32_t(scene_.lights.size());
        return report;
    }

    RenderBenchRow finished(const Measured& m) const {
        RenderBenchRow row = m.row;
        row.median_ms = median(m.ms);
        row.fastest_ms = *std::min_element(m.ms.begin(), m.ms.end());
        row.slowest_ms = *std::max_element(m.ms.begin(), m.ms.end());
        row.cpu_ms = median(m.cpu_ms);
        row.mtri_per_s = double(triangle_count(scene_)) / row.median_ms * 1e-3;
        row.mpix_per_s = double(row.stats.pixels_shaded) / row.median_ms * 1e-3;
        for (const auto stage :
             {&StageTimes::front_end, &StageTimes::tiles, &StageTimes::visibility, &StageTimes::occlusion,
              &StageTimes::shading, &StageTimes::blending, &StageTimes::delivery})
            row.stages.*stage = m.median_stage(stage);
        return row;
    }

    const RenderBenchOptions& options_;
    Context& context_;
    RenderSettings settings_;
    Scene scene_;                      ///< as engines get it
    Shot shot_;                        ///< of an 8-bit picture
    std::optional<PictureSink> sink_;  ///< display values, three bytes per pixel
    std::vector<Measured> measured_;
};

Json json_of(const StageTimes& t) {
    return {{"front_end", 1e3 * t.front_end}, {"tiles", 1e3 * t.tiles},       {"visibility", 1e3 * t.visibility},
            {"shading", 1e3 * t.shading},     {"blending", 1e3 * t.blending}, {"delivery", 1e3 * t.delivery},
            {"occlusion", 1e3 * t.occlusion}};
}

}  // namespace

RenderBenchReport bench_render(const RenderBenchOptions& options, Context& context) {
    check(options);
    // Half a vertex of 48 bytes and three indices per triangle, and as much again while they are made.
    if (options.scene.empty()) context.memory().check(options.triangles * 80, "the scene to measure");
    return RenderBench(options, context).run();
}

std::string to_json(const RenderBenchReport& report) {
    Json rows = Json::array();
    for (const RenderBenchRow& r : report.rows)
        rows.push_back({{"engine", r.engine},
                        {"isa", r.isa},
                        {"threads", r.threads},
                        {"lights", r.lights},
                        {"median_ms", r.median_ms},
                        {"fastest_ms", r.fastest_ms},
                        {"slowest_ms", r.slowest_ms},
                        {"cpu_ms", r.cpu_ms},
                        {"first_ms", r.first_ms},
                        {"prepare_ms", r.prepare_ms},
                        {"mtri_per_s", r.mtri_per_s},
                        {"mpix_per_s", r.mpix_per_s},
                        {"stages_ms", json_of(r.stages)},
                        {"stats", stats_json(r.stats)}});
    const Json json = {{"schema", "rakelight.bench/1"}, {"rows", rows},
                       {"scene", report.scene},         {"triangles", report.triangles},
                       {"vertices", report.vertices},   {"objects", report.objects},
                       {"lights", report.lights},       {"width", report.width},
                       {"height", report.height},       {"frames", report.frames}};
    return json_text(json);
}

std::string to_text(const RenderBenchReport& report) {
    char line[320];
    const auto format = [&](auto... values) {
        std::snprintf(line, sizeof line, values...);
        return std::string(line);
    };
    const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::string text = one_line(report.scene, 120) + format(": %llu triangles, %llu vertices, %s, %s, %d x %d, %s\n",
                                                            number(report.triangles), number(report.vertices),
                                                            counted(report.objects, "object").c_str(),
                                                            counted(report.lights, "light").c_str(), report.width,
                                                            report.height, counted(report.frames, "frame").c_str());
    text += "engine          threads  median ms (fastest  slowest)      CPU    first   Mtri/s   Mpix/s\n";
    for (const RenderBenchRow& r : report.rows) {
        text += format("%-6s %-8s %8d %10.2f %8.2f %8.2f %10.2f %8.2f %8.2f %8.2f\n", r.engine.c_str(), r.isa.c_str(),
                       r.threads, r.median_ms, r.fastest_ms, r.slowest_ms, r.cpu_ms, r.first_ms, r.mtri_per_s,
                       r.mpix_per_s);
        if (r.lights != report.lights) text += format("  with %s\n", counted(r.lights, "light").c_str());
        if (!r.stats.gpu_passes.empty()) {
            text += "  on the GPU:";
            for (const GpuPass& pass : r.stats.gpu_passes)
                text += format(" %s %.2f ms;", pass.name.c_str(), 1e3 * pass.seconds);
            text.back() = '\n';
            text += format("  %llu pixels covered (%.1f %%), %llu shaded\n", number(r.stats.pixels_covered),
                           100.0 * double(r.stats.pixels_covered) / (double(report.width) * report.height),
                           number(r.stats.pixels_shaded));
            continue;
        }
        text += format(
            "  front end %.2f ms, then tiles %.2f ms; summed over threads: visibility %.2f, shading %.2f, blending "
            "%.2f, "
            "delivery %.2f ms; depths for ambient occlusion %.2f ms\n",
            1e3 * r.stages.front_end, 1e3 * r.stages.tiles, 1e3 * r.stages.visibility, 1e3 * r.stages.shading,
            1e3 * r.stages.blending, 1e3 * r.stages.delivery, 1e3 * r.stages.occlusion);
        text += format(
            "  %llu back-face culled, %llu degenerate or between samples, %llu outside, %llu drawn; %llu pixels "
            "covered (%.1f %%), %llu shaded\n",
            number(r.stats.culled_back), number(r.stats.culled_degenerate), number(r.stats.culled_outside),
            number(r.stats.drawn), number(r.stats.pixels_covered),
            100.0 * double(r.stats.pixels_covered) / (double(report.width) * report.height),
            number(r.stats.pixels_shaded));
    }
    return text;
}

}  // namespace rakelight
