// SPDX-License-Identifier: Apache-2.0
// Measures how fast attributes are computed, beside a plain loop that is measured in the same run.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/geometry/attributes.h>

namespace rakelight {

/// Options of bench_smooth(): a displaced sphere cut into objects.
struct SmoothBenchOptions {
    std::uint64_t triangles = 10'000'000;  ///< approximate number of triangles, 100 to 10^9
    std::uint32_t objects = 16;            ///< 1 to 100 000, at most one for each 32 triangles
    bool shuffled = false;  ///< true: triangles and vertices of each object are in random order; false: in grid order
    std::uint32_t repetitions = 10;  ///< 1 to 1000, after one warm-up run
    CornerWeight weight = CornerWeight::uniform;
    double crease_angle_rad = pi;  ///< 0..pi
    double weld_distance = 0;      ///< [edge lengths of the model's grid] 0: weld equal positions only
    /// Also measures brute force, which compares every vertex with every face. For up to 50 000 triangles.
    bool brute_force = false;
    bool crease = false;     ///< also measures with the crease angle crease_row_rad and `weight`
    bool tolerance = false;  ///< also measures with a weld distance of tolerance_row edge lengths
    bool order = false;      ///< also measures a second model with the other order of triangles
    bool plan = false;       ///< also measures group(), accumulate() and regroup() separately, at crease_row_rad
    /// Also measures a third model, a sphere of objects that share no vertices, at crease_row_rad. Equal positions are
    /// welded, then borders within a quarter of an edge are matched.
    bool borders = false;
    /// Also measures the weights `angle` and `automatic` at crease_row_rad: on this model, and on smooth ones on which a
    /// sixth of the places need a fit, and nearly all.
    bool weights = false;
    static constexpr double crease_row_rad = radians(60);  ///< crease angle of `crease`, `plan` and `borders`
    static constexpr double tolerance_row = 0.1;           ///< [edge lengths]
};

/// One measurement. Times are wall clock; repetitions of all rows are interleaved.
struct BenchRow {
    std::string what{};                     ///< for people
    int threads = 1;                        ///< threads used
    double ns_per_triangle = 0;             ///< median over the repetitions
    double fastest_ns = 0, slowest_ns = 0;  ///< [ns] per triangle
    double cpu_ns_per_triangle = 0;         ///< median CPU time of all threads, less sensitive to other load
    double cold_ns_per_triangle = 0;        ///< first run, with untouched memory; 0: not measured
    double bytes_per_triangle = 0;          ///< peak memory besides input and output; 0: none or not measured
    double ratio_to_plain = 0;              ///< median divided by that of "plain loop, normals"; 0: no such row
    double ratio_to_brute_force = 0;        ///< median divided by that of "brute force, normals"; 0: no such row
};

/// Result of bench_smooth().
struct SmoothBenchReport {
    std::uint64_t triangles = 0, vertices = 0;  ///< of the model
    std::uint32_t objects = 0;                  ///< of the model
    std::string order{}, isa{};                 ///< `order`: of the model's triangles. `isa`: the instruction set
    double copy_gb_per_s = 0;                   ///< speed of memcpy on all threads, bytes read plus bytes written
    bool huge_pages = false;                    ///< huge pages were requested (madvise) for buffers and scratch memory
    std::vector<BenchRow> rows{};
};

/// Creates the model and measures. The baseline is a plain loop in one thread: it sums face normals per vertex and
/// normalizes the sums, for each object alone, so the result has seams. The next rows are compute_attributes_into() for
/// normals, and for normals and tangents, with scope model and reused buffers and workspace. For further rows see
/// SmoothBenchOptions.
/// @throws Error usage: options out of range; bad_file: the memory budget is too small
RL_API SmoothBenchReport bench_smooth(const SmoothBenchOptions& options, Context& context);

/// Schema rakelight.bench/1: {"schema", "rows": [{"what", "ns_per_triangle", ...}], and the model}.
RL_API std::string to_json(const SmoothBenchReport& report);
/// A table for people.
RL_API std::string to_text(const SmoothBenchReport& report);

}  // namespace rakelight
