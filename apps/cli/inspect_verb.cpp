// SPDX-License-Identifier: Apache-2.0
#include "inspect_verb.h"

#include <CLI/CLI.hpp>

#include <algorithm>

#include "options.h"
#include "run_file.h"
#include "values.h"

namespace rakelight::cli {

void add_inspect_options(CLI::App& app, InspectWords& w) {
    const auto add = [&](const char* group, const char* name, std::string& value, const char* type, const char* help) {
        app.add_option(name, value, help)->type_name(type)->group(group);
    };
    const auto flag = [&](const char* group, const char* name, bool& value, const char* help) {
        app.add_flag(name, value, help)->group(group);
    };
    add_normal_options(
        app,
        "Whose normals are looked at: auto (default: the file's, smoothed per object where it has none), "
        "file (else flat), flat, object, model",
        w.render);
    add("Normals", "--weld-distance", w.weld_distance, "M",
        "Positions at most this far apart [m] count as one (default: equal, but for rounding)");
    flag("Normals", "--no-borders", w.no_borders, "Do not look for the borders that objects share");
    flag("Normals", "--no-surfaces", w.no_surfaces, "Do not look at edges, faces and normals of each object");
    const char* const check = "Check";
    flag(check, "--check", w.check,
         "Only pass or fail: exit code 5 past the limit of --max-seam or one asked for below");
    add(check, "--max-seam", w.max_seam, "DEG", "Largest seam between two objects (default 1; 180 allows any)");
    flag(check, "--no-degenerate", w.no_degenerate, "No triangle without area");
    flag(check, "--no-t-junctions", w.no_t_junctions, "No vertex on the inside of another face's open edge");
    flag(check, "--no-non-manifold", w.no_non_manifold, "No edge of three or more faces");
    flag(check, "--consistent-winding", w.consistent_winding, "No edge whose two faces go along it the same way");
    flag(check, "--no-inside-out", w.no_inside_out, "No closed body, of one or several objects, that looks inwards");
    flag(check, "--closed", w.closed, "Every object closed: no edge of one face");
    flag(check, "--unit-normals", w.unit_normals, "No zero, non-finite or non-unit normal in the file");
    add("Heat map", "--heatmap", w.heat_map, "FILE",
        "Write a picture of the seams, colored by their angle. {model} stands for the model's name");
    add("Heat map", "--resolution", w.render.resolution, "W,H", "Its size in pixels, also WxH (default 1280,720)");
    add_view_options(app, "Heat map", w.render);
}

namespace {

void apply_limits(const InspectWords& w, InspectRequest& request) {
    CheckLimits limits;
    limits.no_degenerate = w.no_degenerate, limits.no_t_junctions = w.no_t_junctions;
    limits.no_non_manifold = w.no_non_manifold, limits.consistent_winding = w.consistent_winding;
    limits.no_inside_out = w.no_inside_out, limits.closed = w.closed, limits.unit_normals = w.unit_normals;
    const bool of_surfaces = w.no_degenerate || w.no_t_junctions || w.no_non_manifold || w.consistent_winding ||
                             w.no_inside_out || w.closed || w.unit_normals;
    if (!w.check && (of_surfaces || !w.max_seam.empty()))
        throw Error(ErrorCode::usage, "limits are for --check", {}, "add --check");
    if (!w.check) return;
    if (of_surfaces && w.no_surfaces)
        throw Error(ErrorCode::usage, "--no-surfaces leaves nothing to check the limits of surfaces by");
    if (w.no_borders && !w.max_seam.empty())
        throw Error(ErrorCode::usage, "--no-borders and --max-seam exclude each other");
    if (w.no_borders) limits.max_seam_deg.reset();
    if (!w.max_seam.empty()) limits.max_seam_deg = number("max-seam", w.max_seam);
    if (limits.max_seam_deg && !(*limits.max_seam_deg >= 0 && *limits.max_seam_deg <= 180))
        throw wrong("max-seam", "must be 0 to 180 degrees");
    request.check = limits;
}

/// The work on one file.
void inspect_file(const Options& options, const PictureRequest& picture, InspectionRow& row, Context& context) {
    const Scene scene = load(picture.input, picture.load, context);
    InspectOptions inspected = options.inspect.options;
    inspected.prepare = picture.prepare;  // a world's [render] may say something of its normals
    row.inspection = inspect(scene, inspected, context);
    if (options.inspect.check) row.check = check_limits(*row.inspection, *options.inspect.check);
    if (picture.output.empty()) return;
    save(draw_seams(scene, *row.inspection, inspected, picture.view, picture.settings, context), picture.output);
    row.heat_map = picture.output;
    row.inspection->seam_lines = {};
}

/// What is said of a model on standard output: of one that is only checked that it passed, of others all tables.
std::string said(const Options& options, const InspectionRow& row, bool is_first) {
    if (!row.check || options.loudness == Loudness::verbose) return (is_first ? "" : "\n") + to_text(*row.inspection);
    if (!row.check->empty() || options.loudness == Loudness::quiet) return {};
    return one_line(row.file) + ": passed: " + to_text(*options.inspect.check) + "\n";
}

/// One line a limit; returns the exit code.
int print_failures(const InspectionRow& row) {
    if (!row.check || row.check->empty()) return 0;
    for (const CheckFailure& failure : *row.check)
        print_error(Error(ErrorCode::check_failed, failure.limit + ": " + failure.message).with_file(row.file));
    return exit_code(ErrorCode::check_failed);
}

}  // namespace

void apply(const InspectWords& w, InspectRequest& request, PictureRequest& picture) {
    picture.output = w.heat_map;
    request.options.borders = !w.no_borders;
    request.options.surfaces = !w.no_surfaces;
    request.options.seam_lines = !w.heat_map.empty();
    request.options.prepare = picture.prepare;
    if (!w.weld_distance.empty()) {
        request.options.weld_distance = number("weld-distance", w.weld_distance);
        if (!(request.options.weld_distance >= 0)) throw wrong("weld-distance", "must be 0 or more");
    }
    apply_limits(w, request);
    if (w.heat_map.empty()) {
        if (!w.render.resolution.empty() || picture.view.is_placed() || !w.render.view.empty() ||
            !w.render.camera.empty())
            throw Error(ErrorCode::usage, "the view and its resolution are for --heatmap", {}, "add --heatmap FILE");
        return;
    }
    if (w.no_borders) throw Error(ErrorCode::usage, "--no-borders and --heatmap exclude each other");
    constexpr std::int64_t most_pixels = 1 << 26;  // it is kept whole, 28 bytes a pixel
    if (std::int64_t(picture.settings.width) * picture.settings.height > most_pixels)
        throw wrong("resolution", "a heat map has at most 64 million pixels");
}

int run_inspect(const Options& options) {
    std::vector<InputRequest> pictures;
    if (!options.picture.output.empty()) {
        pictures = picture_requests(options);
        for (const InputRequest& picture : pictures)
            if (!picture.error) check_request(picture.picture);
    } else {
        for (const std::string& file : options.inputs) pictures.push_back(request_for(options, file));
    }
    std::vector<InspectionRow> rows;
    int worst = 0;
    for (const InputRequest& input : pictures) {
        const PictureRequest& picture = input.picture;
        InspectionRow row{.file = picture.input};
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(picture.input);
            rows.push_back(std::move(row));
            continue;
        }
        worst = std::max(worst,
                         run_input(options, input, row, [&](Context& c) { inspect_file(options, picture, row, c); }));
        if (!options.json && row.inspection) print_text(said(options, row, rows.empty()));
        worst = std::max(worst, print_failures(row));
        if (!row.heat_map.empty())
            print_note(
                row.heat_map + ": seams from 0.01 degrees dark blue over 1 violet, 5 red, 20 orange to 60 yellow",
                options.loudness);
        rows.push_back(std::move(row));
    }
    if (options.json) print_data(to_json(rows));
    return worst;
}

}  // namespace rakelight::cli
