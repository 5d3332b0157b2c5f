// SPDX-License-Identifier: Apache-2.0
// Measurements of pictures as the program's JSON, schema rakelight.bench/1 (fields are added, never renamed), and as a
// table.
#include <programs/tools/bench.h>

#include <cstdio>

#include <nlohmann/json.hpp>

#include "tools/inspect/inspect_sections.h"
#include "tools/report_json.h"

namespace rakelight {
namespace {

Json json_of(const StageTimes& t) {
    return {{"front_end", 1e3 * t.front_end}, {"tiles", 1e3 * t.tiles},       {"visibility", 1e3 * t.visibility},
            {"shading", 1e3 * t.shading},     {"blending", 1e3 * t.blending}, {"delivery", 1e3 * t.delivery},
            {"occlusion", 1e3 * t.occlusion}};
}

}  // namespace

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
