// SPDX-License-Identifier: Apache-2.0
// Measurements as the program's JSON, schema rakelight.bench/1 (fields are added, never renamed), and as a table.
#include <programs/tools/bench.h>

#include <cstdio>

#include <nlohmann/json.hpp>

#include "tools/report_json.h"

namespace rakelight {

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

std::string to_json(const PoseBenchReport& report) {
    Json rows = Json::array();
    for (const PoseBenchRow& r : report.rows)
        rows.push_back({{"what", r.what},
                        {"median_ms", r.median_ms},
                        {"fastest_ms", r.fastest_ms},
                        {"slowest_ms", r.slowest_ms},
                        {"cpu_ms", r.cpu_ms},
                        {"ns_per_vertex", r.ns_per_vertex},
                        {"ratio_to_copy", r.ratio_to_copy}});
    return json_text({{"schema", "rakelight.bench/1"},
                      {"rows", rows},
                      {"scene", report.scene},
                      {"triangles", report.triangles},
                      {"vertices", report.vertices},
                      {"objects", report.objects},
                      {"joints", report.joints},
                      {"threads", report.threads}});
}

std::string to_text(const PoseBenchReport& report) {
    char line[256];
    const auto format = [&](auto... values) {
        std::snprintf(line, sizeof line, values...);
        return std::string(line);
    };
    std::string text =
        format("%s: what moves has %llu triangles, %llu vertices, %u objects, %u joints; %d threads\n",
               report.scene.c_str(), static_cast<unsigned long long>(report.triangles),
               static_cast<unsigned long long>(report.vertices), report.objects, report.joints, report.threads);
    text += "ms                                         median    (fastest  slowest)      CPU  ns/vertex  to copy\n";
    for (const PoseBenchRow& r : report.rows)
        text += format("%-40s %8.2f    %9.2f %9.2f %8.2f %10.2f %8.2f\n", r.what.c_str(), r.median_ms, r.fastest_ms,
                       r.slowest_ms, r.cpu_ms, r.ns_per_vertex, r.ratio_to_copy);
    return text;
}

}  // namespace rakelight
