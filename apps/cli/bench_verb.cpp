// SPDX-License-Identifier: Apache-2.0
#include "bench_verb.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>

#include <rakelight/world.h>

#include "console.h"
#include "interrupt.h"
#include "options.h"
#include "values.h"

namespace rakelight::cli {
namespace {

// A whole number; k and M stand for thousands and millions.
int count(const char* option, std::string word, int low, int high) {
    std::string zeros;
    if (!word.empty() && (word.back() == 'k' || word.back() == 'K')) zeros = "000";
    if (!word.empty() && word.back() == 'M') zeros = "000000";
    if (!zeros.empty()) word.pop_back();
    return int(integer(option, word + zeros, low, high));
}

// Words separated by commas.
void add_rows(const std::string& words, SmoothBenchOptions& o) {
    for (std::size_t first = 0; first <= words.size();) {
        const std::size_t last = std::min(words.find(',', first), words.size());
        const int row = word<int>("with", words.substr(first, last - first),
                                  {{"crease", 1}, {"tolerance", 2}, {"order", 4}, {"plan", 8}, {"all", 15}});
        o.crease |= (row & 1) != 0;
        o.tolerance |= (row & 2) != 0;
        o.order |= (row & 4) != 0;
        o.plan |= (row & 8) != 0;
        first = last + 1;
    }
}

// [bytes] All of it; as much as can be asked for where the system does not say.
std::uint64_t memory_of_machine() {
    const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGE_SIZE);
    return pages > 0 && size > 0 ? std::uint64_t(pages) * std::uint64_t(size) : ~std::uint64_t(0);
}

/// An option that belongs to the other measurement.
void refuse(const char* what, std::initializer_list<std::pair<const char*, const std::string&>> words) {
    for (const auto& [option, word] : words)
        if (!word.empty()) throw Error(ErrorCode::usage, std::string(option) + " is not for bench " + what);
}

void apply_smooth(const BenchWords& w, SmoothBenchOptions& o) {
    refuse("smooth", {{"a scene", w.scene},
                      {"--lights", w.lights},
                      {"--engine", w.engines},
                      {"--frames", w.frames},
                      {"--output", w.output},
                      {"--export", w.export_file}});
    for (const WorldValue& value : values_of(w.render))
        if (value.key != "weight" && value.key != "crease-angle")
            throw Error(ErrorCode::usage, "--" + value.key + " is not for bench smooth");
    o.triangles = w.triangles.empty() ? 1'000'000 : std::uint64_t(count("triangles", w.triangles, 100, 1'000'000'000));
    o.objects = w.objects.empty() ? std::uint32_t(std::min<std::uint64_t>(o.objects, o.triangles / 32))
                                  : std::uint32_t(count("objects", w.objects, 1, 100'000));
    if (!w.order.empty()) o.shuffled = word<bool>("order", w.order, {{"coherent", false}, {"shuffled", true}});
    if (!w.render.weight.empty())
        o.weight = word<CornerWeight>("weight", w.render.weight,
                                      {{"uniform", CornerWeight::uniform},
                                       {"area", CornerWeight::area},
                                       {"angle", CornerWeight::angle},
                                       {"angle-area", CornerWeight::angle_area}});
    const std::string& crease = w.crease.empty() ? w.render.crease_angle : w.crease;
    if (!crease.empty()) o.crease_angle_rad = radians(number("crease-angle", crease));
    if (!w.tolerance.empty()) o.weld_distance = number("tolerance", w.tolerance);
    if (!w.repetitions.empty()) o.repetitions = std::uint32_t(count("repetitions", w.repetitions, 1, 1000));
    if (!w.with.empty()) add_rows(w.with, o);
    o.brute_force = w.brute_force;
}

std::vector<std::string> arguments_of_pictures(const BenchWords& w) {
    std::vector<std::string> arguments;
    for (const WorldValue& value : values_of(w.render)) {
        const bool is_flag = find_render_key(value.key)->kind == RenderKey::Kind::flag;
        for (const std::string& word : value.words) arguments.push_back("--" + value.key + (is_flag ? "" : "=" + word));
    }
    return arguments;
}

void apply_render(const BenchWords& w, RenderBenchOptions& o) {
    refuse("render", {{"--order", w.order},
                      {"--crease", w.crease},
                      {"--tolerance", w.tolerance},
                      {"--repetitions", w.repetitions},
                      {"--with", w.with}});
    if (w.brute_force) throw Error(ErrorCode::usage, "--brute-force is not for bench render");
    if (!w.scene.empty())
        for (const auto& [option, word] :
             {std::pair("--triangles", &w.triangles), {"--objects", &w.objects}, {"--lights", &w.lights}})
            if (!word->empty())
                throw Error(ErrorCode::usage, std::string(option) + " is for the built-in scene, not for a file");
    o.scene = w.scene;
    o.output = w.output;
    o.export_file = w.export_file;
    if (!w.triangles.empty()) o.triangles = std::uint64_t(count("triangles", w.triangles, 100, 100'000'000));
    o.objects = w.objects.empty() ? std::uint32_t(std::min<std::uint64_t>(o.objects, o.triangles / 20))
                                  : std::uint32_t(count("objects", w.objects, 1, 100'000));
    std::vector<std::uint32_t> lights;
    for (const std::string_view number : split(w.lights, ','))
        if (!w.lights.empty()) lights.push_back(std::uint32_t(count("lights", std::string(number), 0, 10'000)));
    if (!lights.empty()) o.lights = lights.front(), o.other_lights.assign(lights.begin() + 1, lights.end());
    if (!w.frames.empty()) o.frames = std::uint32_t(count("frames", w.frames, 1, 10'000));
    if (!w.engines.empty()) {
        o.engines.clear();
        for (const std::string_view name : split(w.engines, ',')) o.engines.emplace_back(name);
    }
    o.picture.settings = o.settings;  // in full HD
    read_render_keys(values_of(w.render), o.picture);
    o.settings = o.picture.settings;
}

}  // namespace

void add_bench_options(CLI::App& app, BenchWords& w) {
    const char* const smooth = "Measurement: bench smooth";
    const char* const render = "Measurement: bench render";
    const auto add = [&](const char* group, const char* name, std::string& word, const char* type, const char* help) {
        app.add_option(name, word, help)->type_name(type)->group(group);
    };
    add_render_options(app, w.render);  // of pictures; what is about files is left out, or says something else here
    for (const char* name : {"--output", "--engine", "--window", "--channels", "--channel-files", "--exr-colors"})
        app.remove_option(app.get_option(name));
    app.get_option("--resolution")->description("Size of the picture in pixels, also WxH (default 1920,1080)");
    app.get_option("--weight")
        ->description(
            "How a triangle pulls on a normal: angle (default of render), uniform (default of smooth), area, "
            "angle-area");
    app.add_option("WHAT", w.what, "What to measure: smooth (normals and tangents) or render (pictures)")
        ->type_name("")
        ->required();
    app.add_option("SCENE", w.scene,
                   "For render: a model or world file, or builtin:teapot (default: a scene made by formulas)")
        ->type_name("");
    add("Measurement", "--triangles", w.triangles, "N",
        "Size of the model that is made; 100k, 10M (default: smooth 1M, render 100k)");
    add("Measurement", "--objects", w.objects, "N",
        "Objects that it has (default: smooth 16, render 100; fewer where triangles are few)");
    add(smooth, "--order", w.order, "ORDER", "coherent (default) or shuffled triangles and vertices");
    add(smooth, "--crease", w.crease, "DEG", "Edges bent more than this stay sharp (default 180); as --crease-angle");
    add(smooth, "--tolerance", w.tolerance, "X", "Weld within X edge lengths, up to 0.25 (default 0: exact)");
    add(smooth, "--repetitions", w.repetitions, "N", "Counted runs of each row (default 10)");
    add(smooth, "--with", w.with, "ROWS",
        "Also measure: crease (60 degrees), tolerance (0.1), order (the other one), plan (group, accumulate, regroup); "
        "all");
    app.add_flag("--brute-force", w.brute_force, "Also every vertex against every face, up to 50k triangles")
        ->group(smooth);
    add(render, "--lights", w.lights, "N",
        "Point lights of the scene that is made, 0 to 8 (default 2), or up to 10000 small ones; 8,1000: both");
    add(render, "--engine", w.engines, "NAMES",
        "Engines, separated by commas; their pictures are interleaved (default soft)");
    add(render, "--frames", w.frames, "N",
        "Counted pictures of each engine, after one that is not counted (default 15)");
    add(render, "-o,--output", w.output, "FILE", "Also write the picture of the first engine");
    add(render, "--export", w.export_file, "FILE",
        "Also write the scene as .glb, for other programs to be measured with");
}

void apply(const BenchWords& w, BenchRequest& request) {
    request.is_render = w.what == "render";
    request.has_engines = !w.engines.empty();
    request.picture_arguments = arguments_of_pictures(w);
    if (request.is_render) return apply_render(w, request.render);
    if (w.what != "smooth")
        throw Error(ErrorCode::usage, "bench measures smooth or render, not '" + one_line(w.what, 80) + "'");
    apply_smooth(w, request.smooth);
}

namespace {

/// What the program's own models may ask for: no file does.
std::uint64_t memory_for(const BenchRequest& r) {
    if (!r.is_render) return r.smooth.triangles * (r.smooth.order ? 500 : 400) + (1u << 30);
    return r.render.scene.empty() ? r.render.triangles * 1200 + (4ull << 30) : 0;
}

}  // namespace

/// How a picture of the world is made by its [render] and the command line; data channels and windows are left out.
void take_world(const Options& options, RenderBenchOptions& o) {
    std::vector<std::string> arguments = options.bench.picture_arguments;
    Context quiet({.threads = 1});
    const WorldFile world = read_world(o.scene, quiet);
    const bool says_size = std::ranges::find(world.render, "resolution", &WorldValue::key) != world.render.end() ||
                           std::ranges::any_of(arguments, [](const auto& a) { return a.starts_with("--resolution="); });
    if (!says_size)
        arguments.push_back("--resolution=" + std::to_string(o.settings.width) + "," +
                            std::to_string(o.settings.height));
    const PictureRequest picture = request_of_world(arguments, o.scene, options.picture.load.allow_outside);
    o.picture = picture;
    o.load = picture.load;
    o.settings = picture.settings;
    o.settings.channels = 0;
    o.settings.window = {};
    if (!options.bench.has_engines) o.engines = {picture.engine};
}

int run_bench(const Options& options) {
    ProgressLine progress("bench", options.loudness);
    const BenchRequest& request = options.bench;
    // What the machine has not is refused, for a model that is too large is not told so by the system: the process is ended.
    const std::uint64_t memory =
        options.max_memory != 0 ? options.max_memory : std::min(memory_for(request), memory_of_machine());
    Context context({.threads = options.threads, .max_memory = memory, .progress = progress.callback()});
    const CancelOnInterrupt guard(context, {});
    std::string text;
    if (request.is_render) {
        RenderBenchOptions render = request.render;
        render.load = options.picture.load;
        if (is_world_file(render.scene)) take_world(options, render);
        const RenderBenchReport report = bench_render(render, context);
        text = options.json ? to_json(report) : to_text(report);
    } else {
        const SmoothBenchReport report = bench_smooth(request.smooth, context);
        text = options.json ? to_json(report) : to_text(report);
    }
    progress.wipe();
    if (request.is_render) print_remarks(context.report(), options.loudness);
    options.json ? print_data(text) : print_text(text);
    return 0;
}

}  // namespace rakelight::cli
