// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <rakelight/tools/rows.h>
#include <rakelight/world/values.h>

#include "../../common/picture_options.h"
#include "../run_file.h"
#include "help_texts.h"
#include "map_size.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

/// A length in meters that has to be more than 0.
struct Length {
    const char *name, *group, *help;
    double BakeOptions::*value;
};
constexpr Length lengths[] = {
    {"distance", "Rays",
     "Distance of the cage from LOW [m], outward and inward (default: estimated by rays from LOW, and printed)",
     &BakeOptions::distance},
    {"occlusion-distance", "Maps", "Occlusion: surfaces farther away [m] do not occlude (default: no limit)",
     &BakeOptions::occlusion_distance},
    {"curvature-radius", "Maps",
     "Curvature: the radius of curvature [m] that maps to white where convex and to black where concave (default: 1/50 "
     "of HIGH's diagonal)",
     &BakeOptions::curvature_radius},
};

/// A whole number from `low` to `high`.
struct Count {
    const char *name, *type, *group, *help;
    int BakeOptions::*value;
    int low, high;
};
constexpr Count counts[] = {
    {"samples", "N", "Rays", "Rays per texel: 1, 4 (default) or 16", &BakeOptions::samples, 1, 16},
    {"radiosity-elements", "N", "Maps",
     "Light: radiosity elements that HIGH is divided into, 1 to 200000 (default 20000, or 1.5 times its triangles)",
     &BakeOptions::light_elements, 1, max_radiosity_elements},
    {"rays", "N", "Maps", "Occlusion: rays per sample, 1 to 4096 (default 64)", &BakeOptions::rays, 1, 4096},
    {"padding", "PX", "Texture coordinates", "Pixels by which charts are extended beyond their borders (default 8)",
     &BakeOptions::padding, 0, 1024},
    {"chart-margin", "PX", "Texture coordinates",
     "Free pixels between charts of generated texture coordinates (default 8)", &BakeOptions::chart_margin, 1, 1024},
};

constexpr Word<BakeSpace> spaces[] = {{"tangent", BakeSpace::tangent}, {"object", BakeSpace::object}};
constexpr Word<NormalSource> normals[] = {{"auto", NormalSource::automatic}, {"model", NormalSource::model}};
constexpr Word<bool> greens[] = {{"up", false}, {"down", true}};

std::vector<Option> number_options(std::string_view group) {
    std::vector<Option> options;
    for (const Length& length : lengths)
        if (length.group == group) options.push_back({length.name, length.group, "M", length.help});
    for (const Count& count : counts)
        if (count.group == group) options.push_back({count.name, count.group, count.type, count.help});
    return options;
}

std::vector<Word<BakeMap>> map_words() {
    std::vector<Word<BakeMap>> words;
    for (const BakeMap map : all_bake_maps()) words.push_back({name_of(map), map});
    return words;
}

std::vector<std::string> map_names() {
    std::vector<std::string> names;
    for (const Word<BakeMap>& word : map_words()) names.emplace_back(word.name);
    return names;
}

std::vector<Option> own_options() {
    using enum apps::Form;
    return apps::joined(
        {{{.name = "output",
           .group = "Output",
           .type = "FILE",
           .help = "Pictures to write, .png or .exr; {map} stands for the name of each map",
           .is_required = true,
           .letter = 'o'},
          {"model", "Output", "FILE",
           "Also write LOW as .glb or .gltf, with the texture coordinates, normals and tangents that the maps were "
           "baked for, and with the normal and occlusion maps"},
          {"bits", "Output", "N", "PNG: bits per component, 8 or 16 (default 16 for heights, else 8)"},
          {"size", "Output", "N", "Size of the maps in pixels: one number for a square, or W,H (default 1024)"}},
         {{.name = "maps",
           .group = "Maps",
           .type = "LIST",
           .help = "Maps to bake: normal, height, curvature, occlusion, light (default normal)",
           .words = map_names,
           .takes_several_words = true},
          {.name = "space",
           .group = "Maps",
           .type = "WHICH",
           .help = "Space of normal maps: tangent (default) or object",
           .words = apps::names_of<spaces>},
          {.name = "green",
           .group = "Maps",
           .type = "WAY",
           .help =
               "Direction of green in tangent-space normal maps: up (default, as glTF and OpenGL) or down (DirectX)",
           .words = apps::names_of<greens>},
          {"normalize-frames", "Maps", "",
           "Make normal and tangent of LOW unit and perpendicular in each texel before a normal is encoded. Rakelight "
           "reads maps that way by default (default off: as MikkTSpace)",
           on_off}},
         number_options("Maps"),
         number_options("Rays"),
         {{.name = "high-normals",
           .group = "Normals",
           .type = "WHICH",
           .help = "Normals of HIGH: auto (default: as rendered; glTF without normals is flat) or model (computed, "
                   "smooth across all objects)",
           .words = apps::names_of<normals>},
          {.name = "normals",
           .group = "Normals",
           .type = "WHICH",
           .help = "Normals of LOW: auto (default: the file's where it has them, else model) or model (computed, "
                   "smooth across all objects)",
           .words = apps::names_of<normals>},
          {"crease-angle", "Normals", "DEG",
           "Edges of LOW with a larger angle between their faces stay sharp where normals are computed (default 180: "
           "none). Rays ignore creases"},
          {.name = "crease",
           .group = "Normals",
           .type = "HOW",
           .help =
               "Sharp edges of LOW: angle (default: by --crease-angle) or auto (edge by edge, as render finds them)",
           .words = apps::names_of<creasing_words>},
          {.name = "weight",
           .group = "Normals",
           .type = "HOW",
           .help =
               "Weight of a triangle in a computed normal of LOW: auto (default), angle, uniform, area, angle-area, "
               "max, fit, as in render",
           .words = apps::names_of<corner_weight_words>}},
         {{"make-coordinates", "Texture coordinates", "",
           "Generate texture coordinates even if LOW has some (where it has none, they are always generated)", flag}},
         number_options("Texture coordinates"),
         apps::without(apps::common_options(), {"config"})});
}

void read_size(const Given& given, BakeOptions& options) {
    if (!given.has("size")) return;
    const std::vector<int> size = map_size("size", given.word("size"));
    options.width = size.front(), options.height = size.back();
}

void read_maps(const Given& given, BakeOptions& options) {
    if (!given.has("maps")) return;
    const std::vector<Word<BakeMap>> words = map_words();
    const std::string list = given.word("maps");
    options.maps.clear();
    for (const std::string_view word : values::split(list, ','))
        options.maps.push_back(values::word<BakeMap>("maps", word, words));
}

BakeOptions bake_options(const Given& given) {
    BakeOptions options;
    read_maps(given, options);
    read_size(given, options);
    for (const Length& length : lengths) {
        if (!given.has(length.name)) continue;
        options.*length.value = values::number(length.name, given.word(length.name));
        if (!(options.*length.value > 0)) throw values::wrong(length.name, "must be more than 0");
    }
    for (const Count& count : counts)
        if (given.has(count.name))
            options.*count.value = values::integer(count.name, given.word(count.name), count.low, count.high);
    if (given.has("space")) options.space = values::word("space", given.word("space"), spaces);
    if (given.has("normals")) options.low_normals = values::word("normals", given.word("normals"), normals);
    if (given.has("high-normals"))
        options.high_normals = values::word("high-normals", given.word("high-normals"), normals);
    if (given.has("green")) options.green_down = values::word("green", given.word("green"), greens);
    if (given.has("normalize-frames"))
        options.normalize_frames = values::on_off("normalize-frames", given.word("normalize-frames"));
    if (given.has("crease-angle"))
        options.crease_angle_rad = radians(values::number("crease-angle", given.word("crease-angle"), 0, 180));
    if (given.has("crease")) options.creases = values::word("crease", given.word("crease"), creasing_words);
    if (given.has("weight")) options.weight = values::word("weight", given.word("weight"), corner_weight_words);
    options.make_coordinates = given.has("make-coordinates");
    return options;
}

Command bake_command() {
    return {"bake",
            "Bake the surface of a detailed model into maps for a simple one",
            bake_footer,
            {{"HIGH", "The detailed model: a file, world file or builtin:...", true, false},
             {"LOW", "The simple model, at the same place", true, false}},
            own_options()};
}

int run_bake(const Run& run) {
    BakeRequest request{.high = run.inputs.at(0), .low = run.inputs.at(1), .output = run.picture.output};
    request.options = bake_options(run.given);
    request.load.allow_outside = run.given.has("allow-outside");
    request.model = run.given.word("model");
    if (run.given.has("bits")) request.bits = values::integer("bits", run.given.word("bits"), 8, 16);
    BakeRow row{.result = {.high = request.high, .low = request.low}};
    const int code = run_file(run, request.low, row, [&](Context& c) { row.result = bake_files(request, c); });
    if (code == 0) print_note(summary(row.result), run.loudness);
    if (run.is_json) print_data(to_json(std::span(&row, 1)));
    return code;
}

}  // namespace

const Verb bake_verb = {bake_command, run_bake};

}  // namespace rakelight::cli
