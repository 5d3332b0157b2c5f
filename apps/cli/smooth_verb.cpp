// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <system_error>

#include <rakelight/compare.h>
#include <rakelight/tools/rows.h>
#include <rakelight/tools/values.h>

#include "../common/picture_options.h"
#include "help_texts.h"
#include "interrupt.h"
#include "run_file.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

/// What --normals does with the normals of a file.
struct Way {
    AuthoredNormals authored;
    Scope scope;
};
constexpr Word<Way> ways[] = {{"seams", {AuthoredNormals::seams, Scope::model}},
                              {"model", {AuthoredNormals::replaced, Scope::model}},
                              {"object", {AuthoredNormals::replaced, Scope::object}},
                              {"face", {AuthoredNormals::replaced, Scope::face}},
                              {"flat", {AuthoredNormals::replaced, Scope::face}}};
constexpr Word<TangentChoice> choices[] = {
    {"auto", TangentChoice::automatic}, {"always", TangentChoice::always}, {"never", TangentChoice::never}};

}  // namespace

Command smooth_command() {
    using enum apps::Form;
    std::vector<Option> shared = apps::picture_options();
    Option keep = apps::find(shared, "keep-instances");
    std::vector<Option> input = apps::input_options();
    Option as_one = apps::find(input, "as-one");
    as_one.help =
        "Smooth all files as one model, each in its own coordinates: borders between files are joined too. Each "
        "file is written to its own output, all of them or none";
    keep.help = "glTF: keep instances sharing one mesh even where they touch different objects";
    return {
        "smooth",
        "Rewrite models with seam-free normals and tangents",
        smooth_footer,
        {{"MODEL", models_help}},
        apps::joined(
            {{{.name = "output",
               .group = "Output",
               .type = "FILE",
               .help = "File to write, may be the model itself: .glb or .gltf from glTF and .obj from OBJ (all other "
                       "data of the file is kept), .glb, .gltf, .obj or .ply from any format. {model} stands for the "
                       "model's name",
               .letter = 'o'},
              {"preview", "Output", "PLACE",
               "Write a page with heat maps of the seams before and after instead of a model: an .html file, or a "
               "folder for NAME.html and its pictures"},
              {"keep-unused", "Output", "", "glTF: keep the bytes of buffer views that are no longer used", flag},
              {.name = "normals",
               .group = "Normals",
               .type = "WHICH",
               .help = "seams (default if the file has normals: they are kept, and joined only where parts meet), or "
                       "recomputed: model (default if it has none; smooth across all objects, no seams), object, face "
                       "(flat)",
               .words = apps::names_of<ways>},
              {.name = "scope",
               .group = "Normals",
               .type = "WHICH",
               .help = "Old name of --normals",
               .words = apps::names_of<ways>},
              apps::find(shared, "crease-angle"),
              apps::find(shared, "weight"),
              {"weld-distance", "Normals", "M",
               "Positions of different objects at most this far apart [m] are welded (default: equal up to rounding)"},
              apps::find(shared, "border-distance"),
              {.name = "tangents",
               .group = "Normals",
               .type = "WHICH",
               .help = "auto (default: tangents of the file are rotated with their normals; with recomputed normals, "
                       "where there is a normal map or there were tangents), always (where there are texture "
                       "coordinates), never",
               .words = apps::names_of<choices>},
              {"bitangents", "Normals", "",
               "glTF: write tangents and bitangents averaged as by --tangents published-no-handedness of render, the "
               "bitangents as the attribute _BITANGENT",
               flag},
              keep},
             apps::without(apps::input_options(), {"format", "as-one"}),
             {as_one},
             apps::common_options()})};
}

namespace {

/// --normals, or its old name.
void read_normals(const Given& given, SmoothFileOptions& options) {
    if (given.has("normals") && given.has("scope"))
        throw Error(ErrorCode::usage, "--normals and --scope, its old name, exclude each other");
    const char* const name = given.has("scope") ? "scope" : "normals";
    if (!given.has(name)) return;
    const Way way = values::word(name, given.word(name), ways);
    options.authored = way.authored;
    options.attributes.scope = way.scope;
}

/// @param picture  of one model: a world file may set the crease angle and the weight
SmoothFileOptions smooth_options(const Run& run, const PictureRequest& picture) {
    SmoothFileOptions options;
    AttributeOptions& a = options.attributes;
    a.crease_angle_rad = picture.prepare.crease_angle_rad;
    a.weight = picture.prepare.weight;
    options.border_distance = picture.prepare.border_distance;
    read_normals(run.given, options);
    if (run.given.has("tangents")) options.tangents = values::word("tangents", run.given.word("tangents"), choices);
    if (run.given.has("weld-distance")) {
        a.weld_distance = values::number("weld-distance", run.given.word("weld-distance"));
        if (!(a.weld_distance >= 0)) throw values::wrong("weld-distance", "must be 0 or more");
    }
    options.bitangents = run.given.has("bitangents");
    options.keep_unused = run.given.has("keep-unused");
    options.keep_instances = picture.prepare.keep_instances;
    options.load = picture.load;
    return options;
}

/// The same run with an output for each model: the model, or the page of its preview.
Run with_output(Run run) {
    if (run.given.has("preview") == run.given.has("output"))
        throw Error(ErrorCode::usage,
                    run.given.has("preview") ? "--preview writes no model: it excludes -o" : "an output is missing", {},
                    "write -o FILE for the model, or --preview FILE.html for a page that shows what would change");
    if (!run.given.has("preview")) return run;
    run.picture.output = run.given.word("preview");
    if (!is_page(run.picture.output))
        run.picture.output += (run.picture.output.ends_with('/') ? "" : "/") + std::string("{model}.html");
    return run;
}

/// Beside a page in a folder its pictures; a page that was named stands alone.
PreviewPlace preview_place(const Run& run, const std::string& page) {
    if (is_page(run.given.word("preview"))) return {page, {}, {}};
    const std::string stem = page.substr(0, page.size() - std::string_view(".html").size());
    return {page, stem + "-before.png", stem + "-after.png"};
}

SmoothedFile smooth_input(const Run& run, const PictureRequest& request, const SmoothFileOptions& options, Context& c) {
    if (!run.given.has("preview")) return smooth_file(request.input, request.output, options, c);
    const PreviewPlace place = preview_place(run, request.output);
    if (!place.picture_before.empty()) {
        std::error_code fault;  // missing files are reported when the page is written
        std::filesystem::create_directories(std::filesystem::path(place.page).parent_path(), fault);
    }
    return preview_smooth(request.input, place, options, request.view, request.settings, c);
}

/// All inputs as one model. @return the exit code
int smooth_as_one(const Run& run, const std::vector<InputRequest>& inputs, std::vector<SmoothedFileRow>& rows) {
    std::vector<FileToSmooth> files;
    std::string title;
    for (const InputRequest& input : inputs) {
        files.push_back({input.picture.input, input.picture.output});
        title += (title.empty() ? "" : " + ") + input.picture.input;
        rows.emplace_back().file = input.picture.input;
    }
    *run.files = {.of = 1};
    SmoothedFileRow all;
    std::vector<SmoothedFile> results;
    const int code = run_file(run, title, all, [&](Context& context) {
        for (const InputRequest& input : inputs)
            if (input.error) throw *input.error;
        results = smooth_files(files, smooth_options(run, inputs.front().picture), context);
    });
    rows.front().remarks = all.remarks, rows.front().remarks_left_out = all.remarks_left_out;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (code != 0) {
            rows[i].error = all.error;
            continue;
        }
        rows[i].result = std::move(results[i]);
        print_message(summary(*rows[i].result), run.loudness);
    }
    return code;
}

/// Each input by itself. @return the exit code
int smooth_each(const Run& run, const std::vector<InputRequest>& inputs, std::vector<SmoothedFileRow>& rows) {
    int worst = 0;
    for (const InputRequest& input : inputs) {
        const PictureRequest& request = input.picture;
        if (CancelOnInterrupt::happened()) break;
        SmoothedFileRow& row = rows.emplace_back();
        row.file = request.input;
        const int code = run_input(run, input, row, [&](Context& c) {
            row.result = smooth_input(run, request, smooth_options(run, request), c);
        });
        if (code == 0) print_message(summary(*row.result), run.loudness);
        worst = std::max(worst, code);
    }
    if (inputs.size() > 1 && !run.given.has("preview"))
        print_message("each file was smoothed by itself; --as-one also joins the borders between them", run.loudness);
    return worst;
}

}  // namespace

int run_smooth(const Run& given) {
    if (std::ranges::any_of(given.inputs, [](const std::string& file) { return file.starts_with("standard input"); }))
        throw Error(ErrorCode::usage, "smooth takes files, not standard input", {}, "write the model to a file first");
    const Run run = with_output(given);
    (void)smooth_options(run, run.picture);  // what is wrong for all is reported once
    const std::vector<InputRequest> inputs = picture_requests(run);
    std::vector<SmoothedFileRow> rows;
    const bool is_one = run.given.has("as-one") && inputs.size() > 1;
    const int worst = is_one ? smooth_as_one(run, inputs, rows) : smooth_each(run, inputs, rows);
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

}  // namespace rakelight::cli
