// SPDX-License-Identifier: Apache-2.0
// Measurements that the program makes of itself, beside what it is compared with, in one run.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/attributes.h>

namespace rakelight {

/// A displaced sphere cut into objects, and what to do with it.
struct SmoothBenchOptions {
    std::uint64_t triangles = 10'000'000;  ///< about; 100 to 10^9
    std::uint32_t objects = 16;            ///< 1 to 100 000, at most one for each 32 triangles
    bool shuffled = false;           ///< triangles and vertices of each object in random order, else as a grid has them
    std::uint32_t repetitions = 10;  ///< 1 to 1000, after one run that is not counted
    CornerWeight weight = CornerWeight::uniform;
    double crease_angle_rad = pi;
    double weld_distance = 0;  ///< [edge lengths of the model's grid] 0: exact
    bool brute_force = false;  ///< also every vertex against every face, up to 50 000 triangles
    bool crease = false;       ///< also crease_row_rad and the weight, whatever crease_angle_rad is
    bool tolerance = false;    ///< also a weld within tolerance_row edge lengths
    bool order = false;        ///< also plain loop, normals, and normals and tangents of the other order (a second model)
    bool plan = false;         ///< also the steps apart, at crease_row_rad: group, accumulate, regroup
    static constexpr double crease_row_rad = radians(60);
    static constexpr double tolerance_row = 0.1;
};

/// One thing measured. Times are wall clock; repetitions of all rows are interleaved.
struct BenchRow {
    std::string what;
    int threads = 1;
    double ns_per_triangle = 0;  ///< median over the repetitions
    double fastest_ns = 0, slowest_ns = 0;
    double cpu_ns_per_triangle = 0;   ///< median of the processor time of all threads: less moved by a neighbor's load
    double cold_ns_per_triangle = 0;  ///< the first run, into memory never used before; 0: not measured
    double bytes_per_triangle = 0;    ///< held at most beyond input and output; 0: none or not measured
    double ratio_to_plain = 0;        ///< of medians, to the row "plain loop, normals"; 0: none
    double ratio_to_brute_force = 0;  ///< the same, to the row "brute force, normals"; 0: none
};

struct SmoothBenchReport {
    std::uint64_t triangles = 0, vertices = 0;
    std::uint32_t objects = 0;
    std::string order, isa;
    double copy_gb_per_s = 0;  ///< bytes read plus bytes written by memcpy on all threads
    bool huge_pages = false;   ///< asked for (madvise) for buffers and scratch
    std::vector<BenchRow> rows;
};

/// Makes the model and measures: the plain loop (one thread, objects apart, face normals summed per vertex and
/// normalized: what everybody writes, with seams), then normals, and normals and tangents, by compute_attributes_into()
/// with buffers and a workspace that were used before, scope model. Rows that are asked for besides: see SmoothBenchOptions.
/// @throws Error usage: options out of range; bad_file where the context's memory budget is too small
SmoothBenchReport bench_smooth(const SmoothBenchOptions& options, Context& context);

/// Schema rakelight.bench/1: {"schema", "rows": [{"what", "ns_per_triangle", ...}], and the model}.
std::string to_json(const SmoothBenchReport& report);
/// A table for people.
std::string to_text(const SmoothBenchReport& report);

}  // namespace rakelight
