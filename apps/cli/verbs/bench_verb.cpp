// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <algorithm>
#include <cstdint>

#include <rakelight/world/render_keys.h>
#include <rakelight/world/values.h>
#include <rakelight/world/world_request.h>
#include <rakelight_internal/tools/bench_creases.h>
#include <rakelight_internal/tools/bench_normals.h>
#include <rakelight_internal/tools/bench_pose.h>
#include <rakelight_internal/tools/bench_render.h>
#include <rakelight_internal/tools/bench_smooth.h>

#include "../../common/interrupt.h"
#include "../../common/picture_options.h"
#include "help_texts.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

using enum apps::Form;

constexpr const char* of_smooth = "Measurement: bench smooth";
constexpr const char* of_render = "Measurement: bench render";
constexpr const char* of_pose = "Measurement: bench pose";

using Measure = void (*)(const Run&);
void measure_smooth(const Run&);
void measure_render(const Run&);
void measure_pose(const Run&);
void measure_normals(const Run&);
void measure_creases(const Run&);
constexpr Word<Measure> measurements[] = {{"smooth", measure_smooth},
                                          {"render", measure_render},
                                          {"pose", measure_pose},
                                          {"normals", measure_normals},
                                          {"creases", measure_creases}};
constexpr Word<bool> orders[] = {{"coherent", false}, {"shuffled", true}};
constexpr Word<int> rows[] = {{"crease", 1},   {"tolerance", 2}, {"order", 4}, {"plan", 8},
                              {"borders", 16}, {"weights", 32},  {"all", 63}};

std::vector<Option> options_of_pictures() {
    std::vector<Option> options = apps::without(apps::picture_options(), {"engine", "crease"});
    apps::find(options, "resolution").help = "Size of the picture in pixels, also WxH (default 1920,1080)";
    Option& crease = apps::find(options, "crease-angle");
    crease.help =
        "Edges with a larger angle between their faces stay sharp, 0 to 180 (default for render: the rule of creases; "
        "smooth: 180)";
    crease.also = "crease";
    Option& weld = apps::find(options, "weld-distance");
    weld.help =
        "Positions of different objects at most this far apart are welded: for render in meters (default: equal up to "
        "rounding), for smooth in edge lengths, up to 0.25 (default 0: exact)";
    weld.also = "tolerance";
    apps::find(options, "weight").help =
        "Weight of a triangle in a vertex normal: auto (default for render), uniform (default for smooth), angle, "
        "area, angle-area, max, fit";
    return options;
}

std::vector<Option> options_of_measurement() {
    return {
        {"triangles", "Measurement", "N",
         "Triangles of the generated model, such as 100k or 10M (default: 1M for smooth and pose, 100k for render)"},
        {"objects", "Measurement", "N",
         "Objects of the generated model (default: 16 for smooth and pose, 100 for render; fewer if it has few "
         "triangles)"},
        {.name = "order",
         .group = of_smooth,
         .type = "ORDER",
         .help = "Order of triangles and vertices: coherent (default) or shuffled",
         .words = apps::names_of<orders>},
        {"repetitions", of_smooth, "N", "Timed runs per row, for smooth and pose (default 10)"},
        {.name = "with",
         .group = of_smooth,
         .type = "ROWS",
         .help = "Also measure: crease (60 degrees), tolerance (0.1), order (the other one), plan (group, accumulate, "
                 "regroup), borders (matched where neighbors share no vertices), weights (angle and auto, 60 degrees), "
                 "or all",
         .words = apps::names_of<rows>,
         .takes_several_words = true},
        {"brute-force", of_smooth, "", "Also measure every vertex against every face, up to 50k triangles", flag},
        {"joints", of_pose, "N", "Joints of the generated character (default 64)"},
        {"lights", of_render, "N",
         "Point lights of the generated scene, 0 to 8 (default 2), or up to 10000 small ones; 8,1000 measures both"},
        {.name = "engine",
         .group = of_render,
         .type = "NAMES",
         .help = "Engines, separated by commas; their pictures are interleaved (default soft)",
         .words = apps::engine_words,
         .takes_several_words = true},
        {"frames", of_render, "N", "Timed pictures per engine, after one to warm up (default 15)"},
        {.name = "output",
         .group = of_render,
         .type = "FILE",
         .help = "Also write the picture of the first engine",
         .letter = 'o'},
        {"export", of_render, "FILE", "Also write the scene as .glb, to measure other programs with it"},
    };
}

Command bench_command() {
    return {"bench",
            "Measure the speed of the program next to baselines",
            bench_footer,
            {{"WHAT",
              "What to measure: smooth (normals and tangents), render (pictures), pose (clips), "
              "normals (errors by each weight on surfaces with known normals) or creases (what crease angles and the "
              "automatic rule find on models with known hard edges)",
              true, false, apps::names_of<measurements>},
             {"SCENE",
              "For render: a model or world file, or builtin:teapot; for pose: a model with clips (default: generated)",
              false, false}},
            apps::joined(
                {options_of_pictures(), options_of_measurement(), {apps::shader_option()}, apps::common_options()})};
}

// A whole number; k and M stand for thousands and millions.
int count(const char* option, std::string word, int low, int high) {
    std::string zeros;
    if (!word.empty() && (word.back() == 'k' || word.back() == 'K')) zeros = "000";
    if (!word.empty() && word.back() == 'M') zeros = "000000";
    if (!zeros.empty()) word.pop_back();
    return values::integer(option, word + zeros, low, high);
}

template <class T>
void read_count(const Given& given, const char* option, T& to, int low, int high) {
    if (given.has(option)) to = T(count(option, given.word(option), low, high));
}

// Words separated by commas.
void add_rows(const std::string& words, SmoothBenchOptions& o) {
    for (const std::string_view name : values::split(words, ',')) {
        const int row = values::word("with", name, rows);
        o.crease |= (row & 1) != 0;
        o.tolerance |= (row & 2) != 0;
        o.order |= (row & 4) != 0;
        o.plan |= (row & 8) != 0;
        o.borders |= (row & 16) != 0;
        o.weights |= (row & 32) != 0;
    }
}

// [bytes] All of it; as much as can be asked for where the system does not say.
std::uint64_t memory_of_machine() {
    const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGE_SIZE);
    return pages > 0 && size > 0 ? std::uint64_t(pages) * std::uint64_t(size) : ~std::uint64_t(0);
}

/// An option that belongs to the other measurement.
void refuse(const Given& given, const char* what, std::initializer_list<std::string_view> options) {
    if (const std::string_view option = given.first_of(options); !option.empty())
        throw Error(ErrorCode::usage, "--" + std::string(option) + " does not apply to bench " + what);
}

SmoothBenchOptions smooth_options(const Run& run) {
    const Given& given = run.given;
    if (run.inputs.size() > 1) throw Error(ErrorCode::usage, "bench smooth takes no scene");
    refuse(given, "smooth", {"lights", "engine", "frames", "output", "export", "joints"});
    for (const WorldValue& value : given.settings())
        if (value.key != "weight" && value.key != "crease-angle" && value.key != "weld-distance")
            throw Error(ErrorCode::usage, "--" + value.key + " does not apply to bench smooth");
    SmoothBenchOptions o;
    o.triangles = 1'000'000;
    read_count(given, "triangles", o.triangles, 100, 1'000'000'000);
    o.objects = std::uint32_t(std::min<std::uint64_t>(o.objects, o.triangles / 32));
    read_count(given, "objects", o.objects, 1, 100'000);
    if (given.has("order")) o.shuffled = values::word("order", given.word("order"), orders);
    if (given.has("weight")) o.weight = run.picture.prepare.weight;
    if (given.has("crease-angle")) o.crease_angle_rad = run.picture.prepare.crease_angle_rad;
    if (given.has("weld-distance")) o.weld_distance = run.picture.prepare.weld_distance;
    read_count(given, "repetitions", o.repetitions, 1, 1000);
    if (given.has("with")) add_rows(given.word("with"), o);
    o.brute_force = given.has("brute-force");
    return o;
}

/// How a picture of the world is made by its [render] and the command line.
void take_world(const Run& run, RenderBenchOptions& o) {
    const WorldRequest world = world_request(run, o.scene, run.given.settings());
    const bool says_size = run.given.has("resolution") ||
                           std::ranges::find(world.applied, "resolution", &WorldValue::key) != world.applied.end();
    const int width = o.settings.width, height = o.settings.height;
    o.picture = world.picture;
    o.load = o.picture.load;
    o.settings = o.picture.settings;
    if (!says_size) o.settings.width = width, o.settings.height = height;
}

RenderBenchOptions render_options(const Run& run) {
    const Given& given = run.given;
    refuse(given, "render", {"order", "repetitions", "with", "brute-force", "joints"});
    RenderBenchOptions o;
    if (run.inputs.size() > 1) o.scene = run.inputs[1];
    if (const std::string_view option = given.first_of({"triangles", "objects", "lights"});
        !o.scene.empty() && !option.empty())
        throw Error(ErrorCode::usage, "--" + std::string(option) + " applies to the generated scene, not to a file");
    o.load = run.picture.load;
    o.output = run.picture.output;
    o.export_file = given.word("export");
    read_count(given, "triangles", o.triangles, 100, 100'000'000);
    o.objects = std::uint32_t(std::min<std::uint64_t>(o.objects, o.triangles / 20));
    read_count(given, "objects", o.objects, 1, 100'000);
    if (given.has("lights")) {
        std::vector<std::uint32_t> lights;
        const std::string numbers = given.word("lights");
        for (const std::string_view number : values::split(numbers, ','))
            lights.push_back(std::uint32_t(count("lights", std::string(number), 0, 10'000)));
        o.lights = lights.front(), o.other_lights.assign(lights.begin() + 1, lights.end());
    }
    read_count(given, "frames", o.frames, 1, 10'000);
    if (given.has("engine")) {
        const std::string names = given.word("engine");
        const std::vector<std::string_view> parts = values::split(names, ',');
        o.engines.assign(parts.begin(), parts.end());
    }
    o.picture.settings = o.settings;  // in full HD
    read_render_keys(given.settings(), o.picture);
    o.settings = o.picture.settings;
    if (is_world_file(o.scene)) take_world(run, o);
    return o;
}

PoseBenchOptions pose_options(const Run& run) {
    const Given& given = run.given;
    refuse(given, "pose", {"order", "with", "brute-force", "lights", "engine", "frames", "output", "export"});
    PoseBenchOptions o;
    if (run.inputs.size() > 1) o.scene = run.inputs[1];
    if (const std::string_view option = given.first_of({"triangles", "objects", "joints"});
        !o.scene.empty() && !option.empty())
        throw Error(ErrorCode::usage,
                    "--" + std::string(option) + " applies to the generated character, not to a file");
    o.load = run.picture.load;
    read_count(given, "triangles", o.triangles, 100, 100'000'000);
    o.objects = std::uint32_t(std::min<std::uint64_t>(o.objects, o.triangles / 32));
    read_count(given, "objects", o.objects, 1, 100'000);
    read_count(given, "joints", o.joints, 2, 1000);
    read_count(given, "repetitions", o.repetitions, 1, 1000);
    read_render_keys(given.settings(), o.picture);  // 1280 x 720 where nobody says else
    return o;
}

/// The memory limit for the program's own models; 0, the usual limit, for scenes of files.
std::uint64_t memory_for(const SmoothBenchOptions& o) { return o.triangles * (o.order ? 500 : 400) + (1u << 30); }
std::uint64_t memory_for(const NormalBenchOptions&) { return 1u << 30; }
std::uint64_t memory_for(const CreaseBenchOptions&) { return 1u << 30; }
std::uint64_t memory_for(const PoseBenchOptions& o) { return o.scene.empty() ? o.triangles * 1000 + (2ull << 30) : 0; }
std::uint64_t memory_for(const RenderBenchOptions& o) {
    return o.scene.empty() ? o.triangles * 1200 + (4ull << 30) : 0;
}

/// Measures and says what came out.
template <class Options, class Bench>
void measure(const Run& run, const Options& options, const Bench& bench, Loudness remarks) {
    run.files->of = 1;  // its first word is no file
    ProgressLine progress("bench", run.loudness, *run.files);
    // More memory than the machine has is refused here. The system does not report a model that is too large: it ends
    // the process.
    const std::uint64_t memory =
        run.max_memory != 0 ? run.max_memory : std::min(memory_for(options), memory_of_machine());
    Context context({.threads = run.threads, .max_memory = memory, .progress = progress.callback()});
    const CancelOnInterrupt guard(context, cancelled_line({}));
    const auto report = bench(options, context);
    progress.wipe();
    print_remarks(context.report(), remarks);
    run.is_json ? print_data(to_json(report)) : print_text(to_text(report));
}

void measure_smooth(const Run& run) { measure(run, smooth_options(run), bench_smooth, Loudness::quiet); }
void measure_render(const Run& run) { measure(run, render_options(run), bench_render, run.loudness); }
/// Refuses all settings, for a measurement that makes its own models and takes none.
void refuse_all(const Run& run, const char* what) {
    if (run.inputs.size() > 1) throw Error(ErrorCode::usage, std::string("bench ") + what + " takes no scene");
    refuse(run.given, what,
           {"triangles", "objects", "order", "with", "brute-force", "lights", "engine", "frames", "output", "export",
            "joints"});
    for (const WorldValue& value : run.given.settings())
        throw Error(ErrorCode::usage, "--" + value.key + " does not apply to bench " + what);
}

NormalBenchOptions normal_options(const Run& run) {
    refuse_all(run, "normals");
    NormalBenchOptions o;
    read_count(run.given, "repetitions", o.repetitions, 1, 100);
    return o;
}

CreaseBenchOptions crease_options(const Run& run) {
    refuse_all(run, "creases");
    refuse(run.given, "creases", {"repetitions"});
    return {};
}

void measure_normals(const Run& run) { measure(run, normal_options(run), bench_normals, Loudness::quiet); }
void measure_creases(const Run& run) { measure(run, crease_options(run), bench_creases, Loudness::quiet); }
void measure_pose(const Run& run) { measure(run, pose_options(run), bench_pose, run.loudness); }

int run_bench(const Run& run) {
    values::word("WHAT", run.inputs.at(0), measurements)(run);
    return 0;
}

}  // namespace

const Verb bench_verb = {bench_command, run_bench};

}  // namespace rakelight::cli
