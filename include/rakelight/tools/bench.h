// SPDX-License-Identifier: Apache-2.0
// Measurements that the program makes of itself, beside what it is compared with, in one run.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/export.h>
#include <rakelight/picture.h>

namespace rakelight {

/// A displaced sphere cut into objects, and what to do with it.
struct SmoothBenchOptions {
    std::uint64_t triangles = 10'000'000;  ///< about; 100 to 10^9
    std::uint32_t objects = 16;            ///< 1 to 100 000, at most one for each 32 triangles
    bool shuffled = false;           ///< triangles and vertices of each object in random order, else as a grid has them
    std::uint32_t repetitions = 10;  ///< 1 to 1000, after one run that is not counted
    CornerWeight weight = CornerWeight::uniform;
    double crease_angle_rad = pi;  ///< 0..pi
    double weld_distance = 0;      ///< [edge lengths of the model's grid] 0: exact
    bool brute_force = false;      ///< also every vertex against every face, up to 50 000 triangles
    bool crease = false;           ///< also crease_row_rad and the weight, whatever crease_angle_rad is
    bool tolerance = false;        ///< also a weld within tolerance_row edge lengths
    bool order = false;  ///< also plain loop, normals, and normals and tangents of the other order (a second model)
    bool plan = false;   ///< also the steps apart, at crease_row_rad: group, accumulate, regroup
    bool borders =
        false;  ///< also a sphere whose neighbors do not share vertices (a third model), crease_row_rad: welded
                ///< exactly, and then matched and joined within a quarter of an edge
    static constexpr double crease_row_rad = radians(60);  ///< of the rows `crease`, `plan` and `borders`
    static constexpr double tolerance_row = 0.1;           ///< [edge lengths]
};

/// One thing measured. Times are wall clock; repetitions of all rows are interleaved.
struct BenchRow {
    std::string what{};                     ///< for people
    int threads = 1;                        ///< that it ran on
    double ns_per_triangle = 0;             ///< median over the repetitions
    double fastest_ns = 0, slowest_ns = 0;  ///< [ns] a triangle
    double cpu_ns_per_triangle = 0;   ///< median of the processor time of all threads: less moved by a neighbor's load
    double cold_ns_per_triangle = 0;  ///< the first run, into memory never used before; 0: not measured
    double bytes_per_triangle = 0;    ///< held at most beyond input and output; 0: none or not measured
    double ratio_to_plain = 0;        ///< of medians, to the row "plain loop, normals"; 0: none
    double ratio_to_brute_force = 0;  ///< the same, to the row "brute force, normals"; 0: none
};

/// What bench_smooth() measured.
struct SmoothBenchReport {
    std::uint64_t triangles = 0, vertices = 0;  ///< of the model
    std::uint32_t objects = 0;                  ///< of the model
    std::string order{}, isa{};                 ///< of the model's triangles; instruction set
    double copy_gb_per_s = 0;                   ///< bytes read plus bytes written by memcpy on all threads
    bool huge_pages = false;                    ///< asked for (madvise) for buffers and scratch
    std::vector<BenchRow> rows{};
};

/// Makes the model and measures: the plain loop (one thread, objects apart, face normals summed per vertex and
/// normalized: what everybody writes, with seams), then normals, and normals and tangents, by compute_attributes_into()
/// with buffers and a workspace that were used before, scope model. Rows that are asked for besides: see SmoothBenchOptions.
/// @throws Error usage: options out of range; bad_file where the context's memory budget is too small
RL_API SmoothBenchReport bench_smooth(const SmoothBenchOptions& options, Context& context);

/// Schema rakelight.bench/1: {"schema", "rows": [{"what", "ns_per_triangle", ...}], and the model}.
RL_API std::string to_json(const SmoothBenchReport& report);
/// A table for people.
RL_API std::string to_text(const SmoothBenchReport& report);

/// A character, or the first clip of a model file, and how often it is posed.
struct PoseBenchOptions {
    std::string scene{};  ///< model file; empty: a character made of the three numbers below
    LoadOptions load{};
    std::uint64_t triangles = 1'000'000;  ///< about; 100 to 10^8
    std::uint32_t objects = 16;           ///< 1 to 100 000, at most one for each 32 triangles
    std::uint32_t joints = 64;            ///< 2 to 1000
    std::uint32_t repetitions = 10;       ///< 1 to 1000, after one run that is not counted
    PictureRequest picture{};             ///< of the last row; its input counts for nothing
};

/// One thing measured, of all vertices that move. Times are wall clock; repetitions of all rows are interleaved.
struct PoseBenchRow {
    std::string what{};                                                ///< for people
    double median_ms = 0, fastest_ms = 0, slowest_ms = 0, cpu_ms = 0;  ///< [ms]
    double ns_per_vertex = 0;                                          ///< by the median
    double ratio_to_copy = 0;                                          ///< of medians, to the plain copy
};

/// What bench_pose() measured.
struct PoseBenchReport {
    std::string scene{};                        ///< what was posed, for people
    std::uint64_t triangles = 0, vertices = 0;  ///< of the meshes that move
    std::uint32_t objects = 0, joints = 0;      ///< of the scene
    int threads = 1;                            ///< that it ran on
    std::vector<PoseBenchRow> rows{};
};

/// Poses at moments spread over the clip: a plain copy of positions, normals and tangents (memcpy, all threads); the
/// same by the skin alone; the whole pose with given normals; with normals and tangents made again of the moved vertices
/// by the groups of the bind pose; and pictures of it, from the moment of the clip to display values.
/// @throws Error usage: options out of range, a scene in which nothing moves
RL_API PoseBenchReport bench_pose(const PoseBenchOptions& options, Context& context);
/// Schema rakelight.bench/1.
RL_API std::string to_json(const PoseBenchReport& report);
/// A table for people.
RL_API std::string to_text(const PoseBenchReport& report);

/// What to draw, how, and how often.
struct RenderBenchOptions {
    std::string scene{};  ///< model file or "builtin:teapot"; empty: the built-in scene of the three numbers below
    LoadOptions load{};
    std::uint64_t triangles = 100'000;  ///< about; 100 to 10^8
    std::uint32_t objects = 100;        ///< 1 to 100 000, at most one for each 20 triangles
    std::uint32_t lights = 2;  ///< 0 to 8 point lights that reach everywhere; 9 to 10 000 small ones of a range of 1 m
    std::vector<std::uint32_t> other_lights{};    ///< of the built-in scene: also with so many, pictures interleaved
    std::vector<std::string> engines = {"soft"};  ///< see make_engine(); each once or more often
    std::uint32_t frames = 15;  ///< counted pictures of each engine, 1 to 10 000, after one that is not counted
    RenderSettings settings = full_hd();  ///< of the built-in scene back faces are culled unless it says else
    /// Its materials, normals, view, lights, surroundings and tone, as a picture of the scene would have
    /// them. Input, load options, settings and output are those of here.
    PictureRequest picture{};
    std::string output{};       ///< picture file for what the first engine drew; empty: none
    std::string export_file{};  ///< .glb file for the scene; empty: none

    static RenderSettings full_hd() {
        RenderSettings settings{};
        settings.width = 1920;
        settings.height = 1080;
        return settings;
    }
};

/// One engine's pictures. Times are wall clock; pictures of all engines are interleaved.
struct RenderBenchRow {
    std::string engine{}, isa{};                           ///< its name; the instruction set, or empty
    int threads = 0;                                       ///< that it ran on
    std::uint32_t lights = 0;                              ///< of the scene
    double median_ms = 0, fastest_ms = 0, slowest_ms = 0;  ///< from vertices to 8-bit display values
    double cpu_ms = 0;      ///< median of the processor time of all threads: less moved by a neighbor's load
    double first_ms = 0;    ///< the picture that is not counted, into memory never used before
    double prepare_ms = 0;  ///< taking up the scene, once: mip chains and the like
    double mtri_per_s = 0;  ///< million triangles of the scene a second, by the median
    double mpix_per_s = 0;  ///< million shaded pixels a second, by the median
    StageTimes stages{};    ///< medians [s], each for itself
    RenderStats stats{};    ///< of the last picture
};

/// What bench_render() measured.
struct RenderBenchReport {
    std::string scene{};                        ///< what was drawn, for people
    std::uint64_t triangles = 0, vertices = 0;  ///< of the scene
    std::uint32_t objects = 0, lights = 0;      ///< of the scene
    int width = 0, height = 0;                  ///< [px]
    std::uint32_t frames = 0;                   ///< counted pictures of each engine
    std::vector<RenderBenchRow> rows{};
};

/// Draws the scene again and again, through its first camera or one fitted to it unless `picture` says else, into
/// display values as a picture file takes them. A model file is prepared as a picture of it would be; where it has no
/// lights, the default rig lights it.
/// @throws Error usage: options out of range, an engine that is not there; what load() and make_engine() throw
RL_API RenderBenchReport bench_render(const RenderBenchOptions& options, Context& context);

/// Schema rakelight.bench/1: {"schema", "rows": [{"engine", "median_ms", ...}], and the scene}.
RL_API std::string to_json(const RenderBenchReport& report);
/// A table for people.
RL_API std::string to_text(const RenderBenchReport& report);

}  // namespace rakelight
