// SPDX-License-Identifier: Apache-2.0
// Built-in benchmarks. Each benchmark also measures its baseline in the same run.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/render/picture.h>

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

/// Options of bench_normals().
struct NormalBenchOptions {
    std::uint32_t repetitions = 3;  ///< 1 to 100: the random surfaces and the noise are made anew in each
};

/// The vertex normals of one class of surfaces, by each weight.
struct NormalBenchRow {
    struct Errors {
        double mean_deg = 0, largest_deg = 0;  ///< angle to the exact normal over all judged vertices
    };
    std::string surface{};         ///< for people
    std::string kind{};            ///< "smooth", "border", "noise" or "hard"
    std::uint64_t vertices = 0;    ///< that are judged, in each repetition
    std::vector<Errors> errors{};  ///< [NormalBenchReport::weights]
};

/// Result of bench_normals().
struct NormalBenchReport {
    std::vector<CornerWeight> weights{};
    std::vector<NormalBenchRow> rows{};
};

/// How far vertex normals are from the exact ones, on surfaces with known normals: round and irregular ones, open
/// borders, noise, bevels. Positions are rounded to float.
/// @throws Error usage: options out of range
RL_API NormalBenchReport bench_normals(const NormalBenchOptions& options, Context& context);
/// Schema rakelight.bench/1: {"schema", "rows": [{"surface", "kind", "vertices", "angle": {"mean_deg", "largest_deg"}, ...}]}.
RL_API std::string to_json(const NormalBenchReport& report);
/// A table for people.
RL_API std::string to_text(const NormalBenchReport& report);

/// Options of bench_creases().
struct CreaseBenchOptions {
    std::vector<double> angles_deg = {30, 40, 60};  ///< [degrees] 0 to 180: crease angles beside the automatic rule
};

/// How well a rule finds the hard edges of a model. Lengths of edges count, not their number.
struct CreaseScore {
    double precision = 1;     ///< share of what is decided hard that is meant hard; 1 if nothing is decided hard
    double recall = 1;        ///< share of what is meant hard that is decided hard; 1 if nothing is meant hard
    std::uint64_t wrong = 0;  ///< edges that are decided otherwise than meant
    /// Kinds of edges of which some are decided hard and some soft, by a whim of the rounding. Edges of one kind are
    /// meant alike. Before rounding their lengths, their bends and the areas of their faces and surfaces are equal.
    std::uint64_t mixes = 0;
};

/// One model, by each rule.
struct CreaseBenchRow {
    std::string model{};                ///< for people
    bool is_decidable = true;           ///< false: its shape leaves open what is hard, so totals leave it out
    bool is_holdout = false;            ///< made without a look at the automatic rule, which is not tuned by it
    std::uint64_t triangles = 0;        ///< of the model
    double hard_share = 0;              ///< share of the length of its edges that is meant hard
    std::vector<CreaseScore> scores{};  ///< [CreaseBenchReport::rules]
};

/// Over several decidable models, by each rule.
struct CreaseBenchTotal {
    std::string what{};                   ///< "all", "tuned" or "holdout"
    std::uint64_t models = 0;             ///< number of models
    std::vector<CreaseScore> together{};  ///< [rules] over the lengths of all edges; mixes: models that have any
    std::vector<CreaseScore> means{};     ///< [rules] of the models' precision and recall; `wrong` and `mixes` are 0
};

/// Result of bench_creases().
struct CreaseBenchReport {
    std::vector<std::string> rules{};  ///< angles in degrees, then "auto"
    std::vector<CreaseBenchRow> rows{};
    std::vector<CreaseBenchTotal> totals{};
};

/// How well crease angles and find_creases() find hard edges, on models whose hard edges are known because the models
/// are made of surfaces. Positions are rounded to decimals or to bits.
/// @throws Error usage: options out of range
RL_API CreaseBenchReport bench_creases(const CreaseBenchOptions& options, Context& context);
/// Schema rakelight.bench/1: {"schema", "rules", "rows": [{"model", "60": {"precision", "recall", ...}, ...}], "totals"}.
RL_API std::string to_json(const CreaseBenchReport& report);
/// A table for people.
RL_API std::string to_text(const CreaseBenchReport& report);

/// Options of bench_pose(): a generated character, or the first clip of a model file.
struct PoseBenchOptions {
    std::string scene{};  ///< model file; empty: a character generated from the three numbers below
    LoadOptions load{};
    std::uint64_t triangles = 1'000'000;  ///< approximate number of triangles, 100 to 10^8
    std::uint32_t objects = 16;           ///< 1 to 100 000, at most one for each 32 triangles
    std::uint32_t joints = 64;            ///< 2 to 1000
    std::uint32_t repetitions = 10;       ///< 1 to 1000, after one run that is not counted
    PictureRequest picture{};             ///< settings of the last row; its input is ignored
};

/// One measurement over all animated vertices. Times are wall clock; repetitions of all rows are interleaved.
struct PoseBenchRow {
    std::string what{};                                                ///< for people
    double median_ms = 0, fastest_ms = 0, slowest_ms = 0, cpu_ms = 0;  ///< [ms]
    double ns_per_vertex = 0;                                          ///< from the median
    double ratio_to_copy = 0;                                          ///< median divided by that of the plain copy
};

/// Result of bench_pose().
struct PoseBenchReport {
    std::string scene{};                        ///< description of the scene
    std::uint64_t triangles = 0, vertices = 0;  ///< of the animated meshes
    std::uint32_t objects = 0, joints = 0;      ///< of the scene
    int threads = 1;                            ///< threads used
    std::vector<PoseBenchRow> rows{};
};

/// Measures at moments spread over the clip. The rows are:
/// - a plain copy of positions, normals and tangents (memcpy on all threads);
/// - skinning only;
/// - the whole pose with given normals;
/// - the whole pose with recomputed normals and tangents, with the corner groups of the bind pose;
/// - whole pictures, from the pose to display values.
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
    std::uint64_t triangles = 100'000;  ///< approximate number of triangles, 100 to 10^8
    std::uint32_t objects = 100;        ///< 1 to 100 000, at most one for each 20 triangles
    /// Number of point lights, 0 to 10 000. Up to 8 lights have an unlimited range; more lights have a range of 1 m.
    std::uint32_t lights = 2;
    /// Generated scene: further numbers of lights to measure. Pictures with different numbers of lights are
    /// interleaved.
    std::vector<std::uint32_t> other_lights{};
    std::vector<std::string> engines = {"soft"};  ///< see make_engine(); the same engine may appear several times
    std::uint32_t frames = 15;                    ///< pictures of each engine, 1 to 10 000, after one warm-up picture
    RenderSettings settings = full_hd();          ///< the generated scene culls back faces by default
    /// Materials, normals, view, lights, environment and tone of the pictures. Input, load options, settings and output
    /// of this request are ignored.
    PictureRequest picture{};
    std::string output{};       ///< picture file of the first engine; empty: it is not written
    std::string export_file{};  ///< .glb file for the scene; empty: it is not written

    static RenderSettings full_hd() {
        RenderSettings settings{};
        settings.width = 1920;
        settings.height = 1080;
        return settings;
    }
};

/// Measurement of one engine. Times are wall clock; pictures of all engines are interleaved.
struct RenderBenchRow {
    std::string engine{}, isa{};                           ///< name of the engine; instruction set, or empty
    int threads = 0;                                       ///< threads used
    std::uint32_t lights = 0;                              ///< of the scene
    double median_ms = 0, fastest_ms = 0, slowest_ms = 0;  ///< from vertices to 8-bit display values
    double cpu_ms = 0;      ///< median CPU time of all threads, less sensitive to other load
    double first_ms = 0;    ///< time of the warm-up picture, with untouched memory
    double prepare_ms = 0;  ///< time of Engine::prepare(), which is called once
    double mtri_per_s = 0;  ///< million triangles of the scene per second, from the median
    double mpix_per_s = 0;  ///< million shaded pixels per second, from the median
    StageTimes stages{};    ///< [s] median of each stage
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

/// Draws the scene repeatedly to 8-bit display values. If `picture` sets no camera, the first camera of the scene is
/// used, or a fitted camera if the scene has none. Model files are prepared as in render_picture(). A scene without
/// lights gets the default light rig.
/// @throws Error usage: options out of range, an unknown engine; as load() and make_engine()
RL_API RenderBenchReport bench_render(const RenderBenchOptions& options, Context& context);

/// Schema rakelight.bench/1: {"schema", "rows": [{"engine", "median_ms", ...}], and the scene}.
RL_API std::string to_json(const RenderBenchReport& report);
/// A table for people.
RL_API std::string to_text(const RenderBenchReport& report);

}  // namespace rakelight
