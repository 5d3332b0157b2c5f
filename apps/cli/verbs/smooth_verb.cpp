// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include <rakelight/tools/compare.h>
#include <rakelight/tools/rows.h>
#include <rakelight/world/values.h>
#include <rakelight_internal/tools/compare_page.h>

#include "../../common/interrupt.h"
#include "../../common/picture_options.h"
#include "../run_file.h"
#include "file_groups.h"
#include "help_texts.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

/// The meaning of a word of --normals: how the normals of a file are used.
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

Command smooth_command() {
    using enum apps::Form;
    std::vector<Option> shared = apps::picture_options();
    Option keep = apps::find(shared, "keep-instances");
    std::vector<Option> input = apps::input_options();
    Option as_one = apps::find(input, "as-one");
    as_one.help =
        "Smooth all files as one model, each in its own coordinates. Default: those whose open borders fit together. "
        "Each "
        ""
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
              apps::find(shared, "crease"),
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
             {as_one,
              {"apart", "Input", "",
               "Smooth each file by itself, even where open borders of several files fit together", flag}},
             apps::common_options()})};
}

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
    SmoothFileOptions options = smooth_options_for(picture);
    AttributeOptions& a = options.attributes;
    read_normals(run.given, options);
    if (run.given.has("tangents")) options.tangents = values::word("tangents", run.given.word("tangents"), choices);
    if (run.given.has("weld-distance")) {
        a.weld_distance = values::number("weld-distance", run.given.word("weld-distance"));
        if (!(a.weld_distance >= 0)) throw values::wrong("weld-distance", "must be 0 or more");
    }
    options.bitangents = run.given.has("bitangents");
    options.keep_unused = run.given.has("keep-unused");
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

using Rows = std::map<std::size_t, SmoothedFileRow>;  ///< by their input
using Inputs = std::vector<InputRequest>;

std::vector<FileGroup> groups_of(const Run& run, const Inputs& inputs, const SmoothFileOptions& options) {
    std::vector<std::string> files;
    for (const InputRequest& input : inputs) files.push_back(input.picture.input);
    if (run.given.has("as-one")) return all_as_one(files);
    const bool is_over_parts = options.attributes.scope == Scope::model;  // else a group changes nothing
    return run.given.has("apart") || !is_over_parts ? each_alone(files) : groups_by_borders(run, files, options);
}

void warn_of_unused(const Run& run, const SmoothFileOptions& options, const SmoothedFile& result, Report& report) {
    const auto warn = [&](const char* key, const char* why) {
        if (run.given.has(key))
            report.add(Remark::warning, result.file, {}, std::string("'") + key + "': no effect, because " + why,
                       {key, "normals"});
    };
    if (result.seams && result.missing_made == 0 && options.border_distance == 0)
        warn("weight", "no normals are computed; 'normals' model computes all");
    if (result.seams || options.attributes.scope != Scope::face) return;
    for (const char* key : {"weight", "crease", "crease-angle"}) warn(key, "each face gets its own normal");
}

/// @return the exit code
int smooth_alone(const Run& run, const InputRequest& input, SmoothedFileRow& row) {
    const PictureRequest& request = input.picture;
    row.file = request.input;
    const int code = run_input(run, input, row, [&](Context& c) {
        const SmoothFileOptions options = smooth_options(run, request);
        row.result = smooth_input(run, request, options, c);
        warn_of_unused(run, options, *row.result, c.report());
    });
    if (code == 0) print_message(summary(*row.result), run.loudness);
    return code;
}

/// All pages or models of a group by themselves. @return the exit code
int smooth_each(const Run& run, const Inputs& inputs, const FileGroup& group, Rows& rows) {
    int worst = 0;
    for (const std::size_t i : group.members) {
        if (CancelOnInterrupt::happened()) break;
        worst = std::max(worst, smooth_alone(run, inputs[i], rows[i]));
    }
    return worst;
}

/// One page, under the name of the first.
int preview_as_one(const Run& run, const Inputs& inputs, const FileGroup& group, Rows& rows) {
    InputRequest all = inputs[group.members.front()];
    for (std::size_t k = 1; k < group.members.size(); ++k)
        all.picture.load.joined.push_back(inputs[group.members[k]].picture.input);
    print_message(group.title + ": open borders fit together, one page (--apart: a page each)", run.loudness);
    return smooth_alone(run, all, rows[group.members.front()]);
}

/// Smooths a group of several inputs as one model. `why` says why that is impossible, where it was not asked for.
int smooth_together(const Run& run, const Inputs& inputs, const FileGroup& group, SmoothedFileRow& all,
                    std::vector<SmoothedFile>& results, std::string& why) {
    std::vector<FileToSmooth> files;
    for (const std::size_t i : group.members) files.push_back({inputs[i].picture.input, inputs[i].picture.output});
    return run_file(run, group.title, all, [&](Context& context) {
        try {
            for (const std::size_t i : group.members)
                if (inputs[i].error) throw *inputs[i].error;
            results = smooth_files(files, smooth_options(run, inputs[group.members.front()].picture), context);
        } catch (const Error& error) {
            if (run.given.has("as-one") || context.cancelled()) throw;
            why = error.what();
        }
    });
}

/// Several inputs as one model. @return the exit code
int smooth_as_one(const Run& run, const Inputs& inputs, const FileGroup& group, Rows& rows) {
    SmoothedFileRow all;
    std::vector<SmoothedFile> results;
    std::string why;
    const int code = smooth_together(run, inputs, group, all, results, why);
    if (!why.empty()) {
        print_message(group.title + ": not smoothed as one model, but each by itself: " + why, run.loudness);
        return smooth_each(run, inputs, group, rows);
    }
    if (code == 0) {
        const std::string counts = summary_of_all(results.front());
        print_message(group.title +
                          (run.given.has("as-one")
                               ? ": smoothed as one model"
                               : ": open borders fit together, smoothed as one model (--apart: each by itself)") +
                          (counts.empty() ? "" : ", " + counts),
                      run.loudness);
    }
    for (std::size_t k = 0; k < group.members.size(); ++k) {
        SmoothedFileRow& row = rows[group.members[k]];
        row.file = inputs[group.members[k]].picture.input;
        row.error = all.error;
        if (k == 0) row.remarks = all.remarks, row.remarks_left_out = all.remarks_left_out;
        if (code != 0) continue;
        row.result = std::move(results[k]);
        print_message(summary(*row.result), run.loudness);
    }
    return code;
}

/// The inputs to be smoothed, and which of them belong together.
struct Work {
    Inputs inputs;
    std::vector<FileGroup> groups;
};

/// @throws Error usage: several inputs that are not one model, for one page
Work work_of(const Run& run) {
    const SmoothFileOptions options = smooth_options(run, run.picture);  // what is wrong for all is reported once
    const std::string& page = run.picture.output;
    const bool is_one_page = run.given.has("preview") && run.inputs.size() > 1 && page.find('{') == page.npos;
    Run numbered = run;  // until it is known whether they are one model
    if (is_one_page) numbered.picture.output = page + "-{n}";
    Work work{picture_requests(numbered), {}};
    work.groups = groups_of(run, work.inputs, options);
    if (is_one_page && work.groups.size() > 1) work.inputs = picture_requests(run);
    if (is_one_page) work.inputs[work.groups.front().members.front()].picture.output = page;
    return work;
}

int run_smooth(const Run& given) {
    if (std::ranges::any_of(given.inputs, [](const std::string& file) { return file.starts_with("standard input"); }))
        throw Error(ErrorCode::usage, "smooth takes files, not standard input", {}, "write the model to a file first");
    if (given.given.has("as-one") && given.given.has("apart"))
        throw Error(ErrorCode::usage, "--as-one and --apart exclude each other");
    const Run run = with_output(given);
    const auto [inputs, groups] = work_of(run);
    *run.files = {.of = groups.size()};
    Rows rows;
    int worst = 0;
    for (const FileGroup& group : groups) {
        if (CancelOnInterrupt::happened()) break;
        const auto way = group.members.size() < 2   ? smooth_each
                         : run.given.has("preview") ? preview_as_one
                                                    : smooth_as_one;
        worst = std::max(worst, way(run, inputs, group, rows));
    }
    std::vector<SmoothedFileRow> in_order;
    for (auto& [input, row] : rows) in_order.push_back(std::move(row));
    if (run.is_json) print_data(to_json(in_order));
    return worst;
}

}  // namespace

const Verb smooth_verb = {smooth_command, run_smooth};

}  // namespace rakelight::cli
