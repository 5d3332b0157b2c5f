// SPDX-License-Identifier: Apache-2.0
// The command line by CLI11. It is slow to compile: only this file, those of the verbs and usage_error.cpp include it.
#include "options.h"

#include <CLI/CLI.hpp>

#include <algorithm>

#include "help_texts.h"
#include "render_options.h"
#include "switches.h"
#include "usage_error.h"
#include "values.h"
#include "world_options.h"

namespace rakelight::cli {
namespace {

constexpr std::size_t column_width = 32, page_width = 100;

/// CLI11's layout with descriptions wrapped to the page and single blank lines.
class HelpLayout final : public CLI::Formatter {
public:
    HelpLayout() { column_width(cli::column_width); }

    std::string make_option_opts(const CLI::Option* option) const override {
        return is_switch(*option) ? std::string(" ") + switch_type : Formatter::make_option_opts(option);
    }

    std::string make_option_desc(const CLI::Option* option) const override {
        std::string text = Formatter::make_option_desc(option), out;
        constexpr std::size_t width = page_width - cli::column_width;
        while (text.size() > width) {
            const std::size_t blank = text.rfind(' ', width);
            if (blank == std::string::npos) break;
            out += text.substr(0, blank) + "\n";
            text.erase(0, blank + 1);
        }
        return out + text;
    }

    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        std::string text = Formatter::make_help(app, name, mode);
        for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;) text.erase(at, 1);
        return text;
    }
};

/// Options that every verb has.
struct CommonWords {
    std::string threads, max_memory;
    bool json = false, quiet = false, verbose = false, allow_outside = false;
};

void add_common_options(CLI::App& app, CommonWords& w) {
    app.add_flag("--json", w.json, "Write the results as JSON to standard output")->group("Output");
    app.add_flag("--quiet", w.quiet, "Print no warnings, only errors")->group("Output");
    app.add_flag("--verbose", w.verbose, "Print notes and times too")->group("Output");
    app.add_option("--threads", w.threads, "Worker threads (default: all processors). The result does not depend on it")
        ->type_name("N")
        ->group("Machine");
    app.add_option("--max-memory", w.max_memory,
                   "Memory that a model's data may ask for, for example 4G (default: 2G, or 64 bytes for each byte of "
                   "its files)")
        ->type_name("SIZE")
        ->group("Machine");
    app.add_flag("--allow-outside", w.allow_outside, "Let a model refer to files outside its own folder")
        ->group("Machine");
}

void add_inputs(CLI::App& app, std::vector<std::string>& inputs, const std::string& help) {
    app.add_option("MODEL", inputs, help)->type_name("")->required();
}

CLI::Option* add(CLI::App& app, const char* group, const char* name, std::string& word, const char* type,
                 const char* help) {
    return app.add_option(name, word, help)->type_name(type)->group(group);
}

}  // namespace

void add_normal_options(CLI::App& app, const char* which, RenderWords& w) {
    const char* const group = "Normals";
    add(app, group, "--normals", w.normals, "WHICH", which);
    add(app, group, "--crease-angle", w.crease_angle, "DEG",
        "Edges bent more than this stay sharp, 0 to 180 (default 60)");
    add(app, group, "--weight", w.weight, "HOW",
        "How a triangle pulls on a normal: angle (default), uniform, area, angle-area");
    add(app, group, "--tangents", w.tangents, "HOW",
        "auto (default: the file's, else mikktspace with the file's normals, else averaged), averaged, mikktspace, "
        "published, published-no-handedness (without its step that turns mirrored texture coordinates into inverted "
        "maps)");
    add(app, group, "--orthogonalize", w.orthogonalize, "WHERE",
        "Make tangents perpendicular to normals: attribute (default: once, per vertex, and per pixel), shader (per "
        "pixel "
        "only), off. When given, how far off they were is said");
    app.add_flag(
           "--keep-instances", w.keep_instances,
           "Instances go on sharing a mesh, with the normals of the first, even where they touch different things")
        ->group(group);
}

void add_view_options(CLI::App& app, const char* group, RenderWords& w) {
    add(app, group, "--view", w.view, "SIDE",
        "Fit the model, seen from: front (+Z), back, left, right, top (+Y), bottom, isometric, default (oblique, "
        "although the file has a camera)");
    add(app, group, "--camera-index", w.camera, "N",
        "Camera of the file, by number from 0 or by name (default: the first, if any)");
    add(app, group, "--camera-position", w.position, "X,Y,Z",
        "Where the camera stands [m]; not with --view or --camera-index");
    add(app, group, "--camera-focal-point", w.focal_point, "X,Y,Z",
        "What it looks at (default: the middle of the model)");
    add(app, group, "--camera-view-up", w.up, "X,Y,Z",
        "Which way is up (default 0,1,0). OBJ, STL and PLY files are taken as Y up: 0,0,1 shows models that are Z up");
    add(app, group, "--camera-view-angle", w.view_angle, "DEG", "Vertical angle of view (default 40)");
    add(app, group, "--camera-horizontal-angle", w.horizontal_angle, "DEG",
        "Horizontal angle of view; with --camera-view-angle both hold, and pixels need not be square");
    add(app, group, "--near", w.near, "D",
        "Nothing nearer is drawn [m], more than 0 (default: the camera's, else before the model)");
    add(app, group, "--far", w.far, "D", "Nothing farther is drawn [m] (default: the camera's, else behind the model)");
    app.add_flag("--camera-orthographic", w.orthographic,
                 "Parallel projection, as high as what the angle of view shows at the focal point")
        ->group(group);
}

static void add_line_options(CLI::App& app, RenderWords& w) {
    const char* const group = "Lines and points";
    app.add_flag("-e,--edges", w.edges, "Draw the edges of the triangles over the picture")->group(group);
    app.add_flag("--wireframe", w.wireframe, "Draw only the edges, no surfaces")->group(group);
    add(app, group, "--points", w.points, "SHAPE",
        "Draw the vertices of the triangles over the picture: square, disc (default none)");
    app.add_flag("--point-sprites", w.point_sprites,
                 "Draw only the vertices, no surfaces (as --points says, else discs)")
        ->group(group);
    add(app, group, "--line-width", w.line_width, "PX", "Width of lines in pixels, the model's own too (default 1)");
    add(app, group, "--point-size", w.point_size, "PX", "Size of points in pixels, the model's own too (default 4)");
    add(app, group, "--line-color", w.line_color, "COLOR",
        "Color of edges and vertices (default: black over surfaces, else the material's)");
}

void hide_drawn_lines(CLI::App& app) {
    for (const char* name : {"--edges", "--wireframe", "--points", "--point-sprites"}) app.get_option(name)->group("");
}

void add_render_options(CLI::App& app, RenderWords& w) {
    add(app, "Output", "-o,--output", w.output, "FILE",
        "Picture to write: .png .jpg .webp (sRGB) .exr .hdr (linear). {model} stands for the model's name")
        ->required();
    add(app, "Output", "--resolution", w.resolution, "W,H",
        "Size of the picture in pixels, also WxH (default 1280,720)");
    add(app, "Output", "--window", w.window, "X,Y,W,H",
        "Draw and write only this part of the picture; 0,0 is the top left pixel");
    add(app, "Output", "--samples", w.samples, "N",
        "Samples a pixel: 1 (default), 4 or 8 make edges smooth; surfaces are shaded once a pixel");
    add(app, "Output", "--anisotropy", w.anisotropy, "N",
        "Texture samples along a pixel's longer side, 1 (default) to 16: sharp at grazing angles");
    add(app, "Output", "--background", w.background, "COLOR",
        "r,g,b from 0 to 1 or '#rrggbb' as seen on a display, or transparent");
    add(app, "Output", "--channels", w.channels, "LIST",
        "Also write data: depth, normal, face-normal, tangent, uv, uv1, position, object, mesh, material, "
        "triangle, barycentric, overdraw, base-color, ambient, diffuse, specular, emission; lighting: the last "
        "four; all");
    add(app, "Output", "--channel-files", w.channel_files, "HOW",
        "exr (default: NAME.depth.exr, ...), layers (all in one EXR: FILE itself, else NAME.channels.exr), png "
        "(for the eye: NAME.depth.png, ...); several: exr,png");
    add(app, "Output", "--exr-colors", w.exr_colors, "HOW", "Colors in EXR files: float (default) or half (16 bits)");

    add(app, "Shading", "--engine", w.engine, "NAME",
        "soft (default): own rasterizer, the same picture on every machine");
    app.add_option(
           "--shading", w.shading,
           "How often lighting is evaluated: phong (default: at every pixel), gouraud (at every vertex), flat (once a "
           "face), unlit (never: own color only), auto (gouraud where triangles are so small that it hardly differs). "
           "For a "
           "part: material:NAME=HOW, object:NAME=HOW; may be repeated, the last that fits counts")
        ->type_name("HOW")
        ->group("Shading")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_surface_options(app, w.surface);
    add(app, "Shading", "--front-face", w.front_face, "ccw|cw",
        "How the model's triangles turn, seen from their front: counter-clockwise (default) or clockwise");
    add(app, "Shading", "--cull", w.cull, "WHICH",
        "Faces left out: auto (default: as the material says), none, back, front");
    add(app, "Shading", "--visibility", w.visibility, "METHOD",
        "How hidden surfaces are taken away: z-reversed (default: z-buffer of reversed float depth), z16, z24, z32 or "
        "z-float "
        "(z-buffer of the textbook's depth), painter (triangles sorted by depth), none (the last drawn stays), "
        "back-face (none, "
        "and back faces are left out)");
    add(app, "Shading", "--interpolation", w.interpolation, "HOW",
        "Attributes between the corners of a triangle: perspective (default: correct) or screen (linear on the "
        "picture, as old "
        "hardware had it)");
    add_line_options(app, w);
    add_normal_options(app,
                       "auto (default: the file's, else as its format says, else model), file, flat, object (smooth "
                       "within each object), model (smooth over all objects: no seams)",
                       w);
    add(app, "Bumps", "--displacement-edge", w.displacement_edge, "M",
        "displacement: longer edges are cut, in meters (default: a 250th of the model's diagonal)");
    add(app, "Bumps", "--displacement-triangles", w.displacement_triangles, "N",
        "displacement: cutting stops before so many, 1 to 100000000 (default 4000000)");
    add_subdivision_options(app, w.subdivision);
    add(app, "Normals", "--uv", w.uv, "HOW",
        "Texture coordinates for models without: box, sphere, cylinder (default none)");

    add_view_options(app, "Camera", w);
    add_scene_options(app, w.scene);
}

namespace {

Options finish(Options options, const CommonWords& common) {
    if (common.quiet && common.verbose) throw Error(ErrorCode::usage, "--quiet and --verbose exclude each other");
    options.json = common.json;
    options.loudness = common.quiet ? Loudness::quiet : common.verbose ? Loudness::verbose : Loudness::normal;
    if (!common.threads.empty()) options.threads = integer("threads", common.threads, 1, 1024);
    if (!common.max_memory.empty()) options.max_memory = byte_size("max-memory", common.max_memory);
    options.picture.load.allow_outside = common.allow_outside;
    return options;
}

/// What the options of all verbs were given.
struct VerbWords {
    RenderWords render, stages;
    InspectWords inspect;
    SmoothWords smooth;
    BenchWords bench;
    ExplainWords explain;
    CheckWords check;
};

/// A verb of the program: its help, its options and what they mean.
struct VerbEntry {
    std::string_view name;
    const char* help;
    const char* footer;  ///< of its own help; may be null
    bool takes_models;
    Verb verb;
    void (*declare)(CLI::App& app, VerbWords& words);
    void (*read)(const VerbWords& words, Options& options);
};

void declare_render(CLI::App& app, VerbWords& w) {
    add_render_options(app, w.render);
    app.add_flag("--stats", w.render.stats,
                 "Say what the engine counted: lighting evaluations, triangles, pixels, overdraw")
        ->group("Output");
}

constexpr VerbEntry verbs[] = {
    {"render", "Draw models to picture files", render_footer, true, Verb::render, declare_render,
     [](const VerbWords& w, Options& o) {
         o.stats = w.render.stats;
         apply(w.render, o.picture);
     }},
    {"inspect", "Say what is in models: objects, materials, textures, seams", inspect_footer, true, Verb::inspect,
     [](CLI::App& app, VerbWords& w) { add_inspect_options(app, w.inspect); },
     [](const VerbWords& w, Options& o) {
         apply(w.inspect.render, o.picture);
         apply(w.inspect, o.inspect, o.picture);
     }},
    {"smooth", "Write models back with seam-free normals and tangents", smooth_footer, true, Verb::smooth,
     [](CLI::App& app, VerbWords& w) { add_smooth_options(app, w.smooth); },
     [](const VerbWords& w, Options& o) {
         o.picture.output = w.smooth.output;
         apply(w.smooth, o.smooth);
     }},
    {"bench", "Measure the program itself, beside what it is compared with", nullptr, false, Verb::bench,
     [](CLI::App& app, VerbWords& w) { add_bench_options(app, w.bench); },
     [](const VerbWords& w, Options& o) { apply(w.bench, o.bench); }},
    {"explain", "Say why a pixel has its color: every number on the way to it", explain_footer, true, Verb::explain,
     [](CLI::App& app, VerbWords& w) { add_explain_options(app, w.explain); },
     [](const VerbWords& w, Options& o) {
         apply(w.explain.render, o.picture);
         apply(w.explain, o.explain, o.picture);
     }},
    {"stages", "Show what each stage makes of a model, as a page", stages_footer, true, Verb::stages,
     [](CLI::App& app, VerbWords& w) { add_stages_options(app, w.stages); },
     [](const VerbWords& w, Options& o) { apply(w.stages, o.picture); }},
    {"check", "Say whether scene files load, and what they hold", check_footer, false, Verb::check,
     [](CLI::App& app, VerbWords& w) { add_check_options(app, w.check); },
     [](const VerbWords& w, Options& o) { o.print_schema = w.check.schema; }},
};

/// The verbs with their options.
void add_verbs(CLI::App& app, VerbWords& words, CommonWords& common, std::vector<std::string>& inputs) {
    for (const VerbEntry& verb : verbs) {
        CLI::App* const sub = app.add_subcommand(std::string(verb.name), verb.help);
        if (verb.takes_models)
            add_inputs(*sub, inputs,
                       std::string("Model files, ") +
                           (verb.verb == Verb::smooth ? "" : "world files (*.scene.toml), ") +
                           "or builtin:teapot, builtin:sphere:tolerance=0.01, ...");
        if (verb.verb == Verb::check) sub->add_option("SCENE", inputs, "Model files and world files")->type_name("");
        verb.declare(*sub, words);
        add_common_options(*sub, common);
        if (verb.footer) sub->footer(verb.footer);
    }
}

/// The words that CLI11 would not explain: a verb that is none, an empty value, a file that looks like an option.
void check_words(int argc, const char* const* argv) {
    const std::string_view first = argc > 1 ? argv[1] : "";
    if (argc > 1 && !first.starts_with('-') && std::ranges::find(verbs, first, &VerbEntry::name) == std::end(verbs))
        throw Error(ErrorCode::usage, "unknown command '" + one_line(std::string(first), 40) + "'", {},
                    "use render, smooth, inspect, explain, stages, check or bench, see rakelight --help");
    for (int i = 2; i < argc && std::string_view(argv[i]) != "--"; ++i) {
        const std::string_view word = argv[i], option = argv[i - 1];
        const bool is_value = option.starts_with('-') && option.find('=') == option.npos;
        if ((word.empty() && is_value) || (word.starts_with("--") && word.ends_with('=')))
            throw Error(ErrorCode::usage,
                        one_line(std::string(word.empty() ? option : word), 40) + ": the value is empty");
        if (word.empty()) throw Error(ErrorCode::usage, "the name of a model is empty");
    }
}

std::string help_of(const CLI::App& app) {
    const std::vector<CLI::App*> subs = app.get_subcommands();
    return subs.empty() ? app.help() : subs.front()->help(app.get_name());
}

}  // namespace

/// `rakelight help [VERB]` is `rakelight [VERB] --help`.
static Options parse_help(int argc, const char* const* argv) {
    if (argc > 3) throw Error(ErrorCode::usage, "help takes one command", {}, "see rakelight --help");
    const char* const words[] = {argv[0], argc > 2 ? argv[2] : "--help", "--help"};
    return parse(argc > 2 ? 3 : 2, words);
}

/// Whether the command line says how the whole is shaded: parts of a world then have no shading of their own.
static bool shades_the_whole(const CLI::App& verb) {
    const CLI::Option* const shading = verb.get_option_no_throw("--shading");
    return shading && std::ranges::any_of(shading->results(), [](const std::string& word) {
               return !word.starts_with("material:") && !word.starts_with("object:");
           });
}

/// @param world  whose options come behind those of the command line; null: none
static Options parse_with(int argc, const char* const* argv, const WorldOptions* world) {
    check_words(argc, argv);
    Options options;
    VerbWords words;
    CommonWords common;
    CLI::App app("Renders 3D models made of many parts: bumps show, seams do not.", "rakelight");
    app.formatter(std::make_shared<HelpLayout>());  // before the verbs, which inherit it
    app.set_help_flag("-h,--help", "Show this help; rakelight VERB --help shows a verb's");
    app.set_version_flag("-V,--version", std::string("-"), "Say version, formats, engines and instruction sets");
    app.require_subcommand(1);
    app.footer(main_footer);
    add_verbs(app, words, common, options.inputs);
    refuse_values_of_flags(app, argc, argv);
    try {
        std::vector<std::string> arguments = join_switches(app, argc, argv);
        std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
        app.parse(arguments);
    } catch (const CLI::CallForHelp&) {
        options.help = help_of(app);
        return options;
    } catch (const CLI::CallForVersion&) {
        options.verb = Verb::version;
        return options;
    } catch (const CLI::ParseError& fault) {
        throw usage_error(fault, app);
    }
    for (const VerbEntry& verb : verbs) {
        if (!app.got_subcommand(std::string(verb.name))) continue;
        options.verb = verb.verb;
        CLI::App& sub = *app.get_subcommand(std::string(verb.name));
        const bool is_for_all = shades_the_whole(sub);
        std::vector<std::string> overridden;
        if (world) overridden = add_world_options(sub, *app.get_subcommand("render"), *world);
        verb.read(words, options);
        options.picture.load.overridden = std::move(overridden);
        options.picture.settings.own_shading = !is_for_all;
    }
    options.arguments.assign(argv, argv + argc);
    return finish(std::move(options), common);
}

Options parse(int argc, const char* const* argv) {
    if (argc > 1 && std::string_view(argv[1]) == "help") return parse_help(argc, argv);
    return parse_with(argc, argv, nullptr);
}

static WorldOptions read_options(const std::string& path, bool allow_outside) {
    Context context({.threads = 1});
    return {path, read_world(path, context).render, allow_outside};
}

/// The command line again, with the options of a world.
static PictureRequest parse_for_world(const std::vector<std::string>& arguments, const WorldOptions& world) {
    std::vector<const char*> argv;
    argv.reserve(arguments.size());
    for (const std::string& word : arguments) argv.push_back(word.c_str());
    try {
        return parse_with(int(argv.size()), argv.data(), &world).picture;
    } catch (const Error& error) {
        throw with_place(error, world, arguments);
    }
}

InputRequest request_for(const Options& options, const std::string& input) {
    InputRequest request{options.picture, {}};
    try {
        if (is_world_file(input)) {
            request.world = read_options(input, options.picture.load.allow_outside);
            request.picture = parse_for_world(options.arguments, *request.world);
        }
    } catch (const Error& error) {
        request.error = error;
    }
    request.picture.input = input;
    return request;
}

PictureRequest request_of_world(std::vector<std::string> arguments, const std::string& world, bool allow_outside) {
    arguments.insert(arguments.begin(), {"rakelight", "render", world, "--output=picture.png"});
    return parse_for_world(arguments, read_options(world, allow_outside));
}

void check_world_options(const Options& options, const std::string& input, const Scene& scene, Context& context) {
    if (!is_world_file(input)) return;
    const std::vector<std::string> arguments = {"rakelight", "render", input, "-o", "picture.png"};
    const WorldOptions world = read_options(input, options.picture.load.allow_outside);
    const PictureRequest request = parse_for_world(arguments, world);
    try {
        check_picture(scene, request, context);
    } catch (const Error& error) {
        throw at_option(error, world, arguments);
    }
}

}  // namespace rakelight::cli
