// SPDX-License-Identifier: Apache-2.0
// Built-in benchmarks, each with its baseline in the same run.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/export.h>
#include <rakelight/picture.h>

namespace rakelight {

/// Options of bench_smooth(): a displaced sphere cut into objects.
struct SmoothBenchOptions {
    std::uint64_t triangles = 10'000'000;  ///< about; 100 to 10^9
    std::uint32_t objects = 16;            ///< 1 to 100 000, at most one for each 32 triangles
    bool shuffled = false;           ///< triangles and vertices of each object in random order, else in grid order
    std::uint32_t repetitions = 10;  ///< 1 to 1000, after one warm-up run
    CornerWeight weight = CornerWeight::uniform;
    double crease_angle_rad = pi;  ///< 0..pi
    double weld_distance = 0;      ///< [edge lengths of the model's grid] 0: exact
    bool brute_force = false;      ///< also brute force, every vertex against every face, up to 50 000 triangles
    bool crease = false;           ///< also at crease_row_rad with `weight`
    bool tolerance = false;        ///< also with a weld distance of tolerance_row edge lengths
    bool order = false;            ///< also with the other order of triangles (a second model)
    bool plan = false;             ///< also the single steps at crease_row_rad: group, accumulate, regroup
    bool borders =
        false;  ///< also a sphere whose objects share no vertices (a third model) at crease_row_rad: exact weld, then matching borders within a quarter of an edge
    static constexpr double crease_row_rad = radians(60);  ///< crease angle of `crease`, `plan` and `borders`
    static constexpr double tolerance_row = 0.1;           ///< [edge lengths]
};

/// One measurement. Times are wall clock; repetitions of all rows are interleaved.
struct BenchRow {
    std::string what{};                     ///< for people
    int threads = 1;                        ///< threads used
    double ns_per_triangle = 0;             ///< median over the repetitions
    double fastest_ns = 0, slowest_ns = 0;  ///< [ns] a triangle
    double cpu_ns_per_triangle = 0;         ///< median CPU time of all threads, less sensitive to other load
    double cold_ns_per_triangle = 0;        ///< first run, with untouched memory; 0: not measured
    double bytes_per_triangle = 0;          ///< peak memory beyond input and output; 0: none or not measured
    double ratio_to_plain = 0;              ///< ratio of medians to the row "plain loop, normals"; 0: none
    double ratio_to_brute_force = 0;        ///< ratio of medians to the row "brute force, normals"; 0: none
};

/// Result of bench_smooth().
struct SmoothBenchReport {
    std::uint64_t triangles = 0, vertices = 0;  ///< of the model
    std::uint32_t objects = 0;                  ///< of the model
    std::string order{}, isa{};                 ///< of the model's triangles; instruction set
    double copy_gb_per_s = 0;                   ///< memcpy on all threads, bytes read plus bytes written
    bool huge_pages = false;                    ///< requested (madvise) for buffers and scratch
    std::vector<BenchRow> rows{};
};

/// Creates the model and measures. The baseline is a plain loop: one thread, separate objects, face normals summed per
/// vertex and normalized, with seams. Then compute_attributes_into() for normals, and for normals and tangents, with
/// reused buffers and workspace, scope model. Further rows: see SmoothBenchOptions.
/// @throws Error usage: options out of range; bad_file: the memory budget is too small
RL_API SmoothBenchReport bench_smooth(const SmoothBenchOptions& options, Context& context);

/// Schema rakelight.bench/1: {"schema", "rows": [{"what", "ns_per_triangle", ...}], and the model}.
RL_API std::string to_json(const SmoothBenchReport& report);
/// A table for people.
RL_API std::string to_text(const SmoothBenchReport& report);

/// Options of bench_pose(): a generated character, or the first clip of a model file.
struct PoseBenchOptions {
    std::string scene{};  ///< model file; empty: a character generated from the three numbers below
    LoadOptions load{};
    std::uint64_t triangles = 1'000'000;  ///< about; 100 to 10^8
    std::uint32_t objects = 16;           ///< 1 to 100 000, at most one for each 32 triangles
    std::uint32_t joints = 64;            ///< 2 to 1000
    std::uint32_t repetitions = 10;       ///< 1 to 1000, after one run that is not counted
    PictureRequest picture{};             ///< settings of the last row; its input is ignored
};

/// One measurement over all animated vertices. Times are wall clock; repetitions of all rows are interleaved.
struct PoseBenchRow {
    std::string what{};                                                ///< for people
    double median_ms = 0, fastest_ms = 0, slowest_ms = 0, cpu_ms = 0;  ///< [ms]
    double ns_per_vertex = 0;                                          ///< by the median
    double ratio_to_copy = 0;                                          ///< ratio of medians to the plain copy
};

/// Result of bench_pose().
struct PoseBenchReport {
    std::string scene{};                        ///< description of the scene
    std::uint64_t triangles = 0, vertices = 0;  ///< of the animated meshes
    std::uint32_t objects = 0, joints = 0;      ///< of the scene
    int threads = 1;                            ///< that it ran on
    std::vector<PoseBenchRow> rows{};
};

/// Measures at moments spread over the clip. Row by row: a plain copy of positions, normals and tangents (memcpy, all
/// threads); skinning only; the whole pose with given normals; the whole pose with normals and tangents recomputed.
/// Recomputed normals use the groups of the bind pose. The last row is whole pictures, from the pose to display values.
/// @throws Error usage: options out of range, a scene without animation
RL_API PoseBenchReport bench_pose(const PoseBenchOptions& options, Context& context);
/// Schema rakelight.bench/1.
RL_API std::string to_json(const PoseBenchReport& report);
/// A table for people.
RL_API std::string to_text(const PoseBenchReport& report);

/// Options of bench_render().
struct RenderBenchOptions {
    std::string scene{};  ///< model file or "builtin:teapot"; empty: a scene generated from the three numbers below
    LoadOptions load{};
    std::uint64_t triangles = 100'000;  ///< about; 100 to 10^8
    std::uint32_t objects = 100;        ///< 1 to 100 000, at most one for each 20 triangles
    std::uint32_t lights = 2;  ///< 0 to 8 point lights of unlimited range; 9 to 10 000 lights with a range of 1 m
    std::vector<std::uint32_t> other_lights{};    ///< generated scene: further numbers of lights, pictures interleaved
    std::vector<std::string> engines = {"soft"};  ///< see make_engine(); repetitions allowed
    std::uint32_t frames = 15;                    ///< pictures of each engine, 1 to 10 000, after one warm-up picture
    RenderSettings settings = full_hd();          ///< the generated scene culls back faces by default
    /// Materials, normals, view, lights, environment and tone of the pictures. Its input, load options, settings and
    /// output are ignored.
    PictureRequest picture{};
    std::string output{};       ///< picture file of the first engine; empty: none
    std::string export_file{};  ///< .glb file for the scene; empty: none

    static RenderSettings full_hd() {
        RenderSettings settings{};
        settings.width = 1920;
        settings.height = 1080;
        return settings;
    }
};

/// Measurement of one engine. Times are wall clock; pictures of all engines are interleaved.
struct RenderBenchRow {
    std::string engine{}, isa{};                           ///< its name; the instruction set, or empty
    int threads = 0;                                       ///< that it ran on
    std::uint32_t lights = 0;                              ///< of the scene
    double median_ms = 0, fastest_ms = 0, slowest_ms = 0;  ///< from vertices to 8-bit display values
    double cpu_ms = 0;      ///< median of the processor time of all threads: less moved by a neighbor's load
    double first_ms = 0;    ///< the picture that is not counted, into memory never used before
    double prepare_ms = 0;  ///< Engine::prepare(), once: mip chains and the like
    double mtri_per_s = 0;  ///< million triangles of the scene per second, by the median
    double mpix_per_s = 0;  ///< million shaded pixels per second, by the median
    StageTimes stages{};    ///< [s] separate medians
    RenderStats stats{};    ///< of the last picture
};

/// Result of bench_render().
struct RenderBenchReport {
    std::string scene{};                        ///< description of the scene
    std::uint64_t triangles = 0, vertices = 0;  ///< of the scene
    std::uint32_t objects = 0, lights = 0;      ///< of the scene
    int width = 0, height = 0;                  ///< [px]
    std::uint32_t frames = 0;                   ///< pictures of each engine
    std::vector<RenderBenchRow> rows{};
};

/// Draws the scene repeatedly to 8-bit display values. The camera is the scene's first or a fitted one, unless
/// `picture` sets another. Model files are prepared as in render_picture(); without lights the default rig is used.
/// @throws Error usage: options out of range, an unknown engine; as load() and make_engine()
RL_API RenderBenchReport bench_render(const RenderBenchOptions& options, Context& context);

/// Schema rakelight.bench/1: {"schema", "rows": [{"engine", "median_ms", ...}], and the scene}.
RL_API std::string to_json(const RenderBenchReport& report);
/// A table for people.
RL_API std::string to_text(const RenderBenchReport& report);

}  // namespace rakelight
