// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <rakelight/tools/compare.h>
#include <rakelight/tools/rows.h>
#include <rakelight/world/values.h>
#include <rakelight_internal/base/exit_code.h>
#include <rakelight_internal/base/file_ending.h>
#include <rakelight_internal/tools/compare_page.h>
#include <rakelight_internal/tools/inspection_report.h>
#include <rakelight_internal/tools/text_file.h>

#include "../../common/interrupt.h"
#include "../../common/picture_options.h"
#include "../run_file.h"
#include "file_groups.h"
#include "help_texts.h"
#include "verbs.h"

namespace rakelight::cli {
namespace {

using enum apps::Form;

/// A limit of --check about surfaces.
struct Limit {
    const char* name;
    bool CheckLimits::*member;
    const char* help;
};
constexpr Limit limits_of_surfaces[] = {
    {"no-degenerate", &CheckLimits::no_degenerate, "No triangle has zero area"},
    {"no-t-junctions", &CheckLimits::no_t_junctions, "No vertex lies inside another face's open edge"},
    {"no-non-manifold", &CheckLimits::no_non_manifold, "No edge has three or more faces"},
    {"consistent-winding", &CheckLimits::consistent_winding,
     "No edge is traversed in the same direction by both of its faces"},
    {"no-inside-out", &CheckLimits::no_inside_out, "No closed body, of one or several objects, is inside out"},
    {"closed", &CheckLimits::closed, "Every object is closed: no edge has only one face"},
    {"unit-normals", &CheckLimits::unit_normals, "No normal in the file is zero, non-finite or not of unit length"},
};

std::vector<Option> normal_options() {
    std::vector<Option> all = apps::picture_options(), options;
    apps::find(all, "normals").help =
        "Normals to inspect: auto (default: the file's, smoothed per object where it has none), file (else flat), "
        "flat, object, model, seams (the file's, joined where parts meet, as smooth does)";
    apps::find(all, "border-distance").help =
        "Also measure seams along borders of different meshes that run along each other without shared vertices, at "
        "most this far apart [m] (default 0: off; a value is suggested if there are such borders)";
    for (const char* name : {"normals", "crease-angle", "crease", "weld-distance", "border-distance", "weight",
                             "tangents", "orthogonalize", "keep-instances"})
        options.push_back(apps::find(all, name));
    return options;
}

std::vector<Option> own_options() {
    std::vector<Option> options = {
        {"no-borders", "Normals", "", "Do not search for borders that meshes share", flag},
        {"no-surfaces", "Normals", "", "Do not check edges, faces and normals of each object", flag},
        {"check", "Check", "",
         "Print only pass or fail: exit code 5 if the limit of --max-seam or one of those below is exceeded", flag},
        {"max-seam", "Check", "DEG",
         "Largest allowed seam between two objects or two materials of one (default 1; 180 allows any)"},
    };
    for (const Limit& limit : limits_of_surfaces) options.push_back({limit.name, "Check", "", limit.help, flag});
    options.push_back({"report", "Reports", "FILE",
                       "Write a page of all models (.html), or their checks as JUnit XML (.xml; like --check, it fails "
                       "if a limit is exceeded). May be repeated",
                       list});
    options.push_back({"junit", "Reports", "FILE", "The same as --report FILE.xml, whatever the file's name"});
    options.push_back({"heatmap", "Heat map", "FILE",
                       "Write a picture of the seams, colored by their angle. {model} stands for the model's name"});
    options.push_back(
        {"heatmap-legend", "Heat map", "", "Draw a legend on it: angles, and the largest seam (default on)", on_off});
    return options;
}

std::vector<Option> motion_options() {
    std::vector<Option> options = apps::picture_options();
    std::erase_if(options, [](const Option& option) { return std::string_view(option.group) != "Motion"; });
    apps::find(options, "animation-time").help =
        "Time in the clip, in seconds, whose bounds are printed (default: its start); seams are those of the bind pose";
    return options;
}

/// How the heat map is seen.
std::vector<Option> heat_map_options() {
    std::vector<Option> options;
    for (Option& option : apps::picture_options()) {
        const std::string_view name = option.name;
        if (name != "resolution" && std::string_view(option.group) != "Camera") continue;
        option.group = "Heat map";
        if (name == "resolution") option.help = "Its size in pixels, also WxH (default 1280,720)";
        options.push_back(option);
    }
    return options;
}

Command inspect_command() {
    return {"inspect",
            "List what is in models: objects, materials, textures, seams",
            inspect_footer,
            {{"MODEL", models_help}},
            apps::joined({apps::input_options(), normal_options(), motion_options(), own_options(), heat_map_options(),
                          apps::common_options()})};
}

/// @param is_checked  by a report, whether --check was given or not
std::optional<CheckLimits> limits_of(const Given& given, bool is_checked) {
    CheckLimits limits;
    bool of_surfaces = false;
    for (const Limit& limit : limits_of_surfaces) of_surfaces |= limits.*limit.member = given.has(limit.name);
    const bool has_seam = given.has("max-seam"), no_borders = given.has("no-borders");
    if (!given.has("check") && !is_checked) {
        if (!of_surfaces && !has_seam) return {};
        throw Error(ErrorCode::usage, "limits need --check", {}, "add --check");
    }
    if (of_surfaces && given.has("no-surfaces"))
        throw Error(ErrorCode::usage, "with --no-surfaces, the limits of surfaces cannot be checked");
    if (no_borders && has_seam) throw Error(ErrorCode::usage, "--no-borders and --max-seam exclude each other");
    if (no_borders && !of_surfaces)
        throw Error(ErrorCode::usage, "with --no-borders, there is nothing to check", {}, "add a limit of surfaces");
    if (no_borders) limits.max_seam_deg.reset();
    if (has_seam) limits.max_seam_deg = values::number("max-seam", given.word("max-seam"));
    if (limits.max_seam_deg && !(*limits.max_seam_deg >= 0 && *limits.max_seam_deg <= 180))
        throw values::wrong("max-seam", "must be 0 to 180 degrees");
    return limits;
}

/// The files for reports of all models.
struct Reports {
    std::vector<std::string> pages, junit;
    bool is_any() const { return !pages.empty() || !junit.empty(); }

    explicit Reports(const Given& given) {
        for (const std::string& file : given.words("report")) {
            if (is_page(file))
                pages.push_back(file);
            else if (file_ending(file) == "xml")
                junit.push_back(file);
            else
                throw values::wrong("report", "'" + one_line(file, 80) + "' is neither .html nor .xml");
        }
        if (given.has("junit")) junit.push_back(given.word("junit"));
        for (const std::string& file : pages) check_text_output(file);
        for (const std::string& file : junit) check_text_output(file);
    }
};

bool draws_heat_maps(const Run& run) {
    return run.given.has("heatmap") || std::ranges::any_of(run.given.words("report"), is_page);
}

void check_heat_map(const Run& run) {
    const RenderSettings& s = run.picture.settings;
    if (!draws_heat_maps(run)) {
        const bool is_given = std::ranges::any_of(run.command.options, [&](const Option& option) {
            return option.is_setting && std::string_view(option.group) == "Heat map" && run.given.has(option.name);
        });
        if (is_given)
            throw Error(ErrorCode::usage, "the view and its resolution need --heatmap", {},
                        "add --heatmap FILE, or --report FILE.html");
        return;
    }
    if (run.given.has("no-borders") && run.given.has("heatmap"))
        throw Error(ErrorCode::usage, "--no-borders and --heatmap exclude each other");
    constexpr std::int64_t most_pixels = 1 << 26;  // it is kept whole, 28 bytes per pixel
    if (std::int64_t(s.width) * s.height > most_pixels)
        throw values::wrong("resolution", "a heat map has at most 64 million pixels");
}

InspectOptions options_of(const Run& run) {
    const Given& given = run.given;
    InspectOptions options;
    options.borders = !given.has("no-borders");
    if (!options.borders && given.has("border-distance"))
        throw Error(ErrorCode::usage, "--no-borders and --border-distance exclude each other");
    options.surfaces = !given.has("no-surfaces");
    options.seam_lines = draws_heat_maps(run) && options.borders;
    return options;
}

/// The work to do for each file.
struct Task {
    InspectOptions options;
    std::optional<CheckLimits> limits;
    SeamMarks marks = SeamMarks::legend;
    bool has_page = false;
};

/// All of the model where unused for a camera: one of the file may show a part alone.
ViewRequest seam_view(const PictureRequest& picture) {
    ViewRequest view = picture.view;
    const bool is_asked = !view.side.empty() || !view.camera.empty() || view.is_placed();
    if (!is_asked && !is_world_file(picture.input)) view.side = "default";
    return view;
}

/// As it is requested, and from behind: seams lie on both sides.
std::vector<ReportPicture> page_pictures(const Scene& scene, const PictureRequest& picture, const Task& task,
                                         const Inspection& inspection, const Frame& asked, Context& context) {
    std::vector<ReportPicture> pictures = {report_picture("Seams, by their angle", asked)};
    ViewRequest behind = seam_view(picture);
    behind.azimuth_rad = behind.azimuth_rad.value_or(0) + pi;
    pictures.push_back(report_picture(
        "From behind", draw_seams(scene, inspection, task.options, behind, picture.settings, context, task.marks)));
    return pictures;
}

/// "left.obj + right.obj" of files that are inspected as one model.
std::string name_of(const PictureRequest& picture) {
    constexpr std::size_t most_named = 2;  ///< beside the first
    const std::vector<std::string>& others = picture.load.joined;
    if (others.size() > most_named) return picture.input + " + " + std::to_string(others.size()) + " more files";
    std::string name = picture.input;
    for (const std::string& other : others) name += " + " + other;
    return name;
}

/// The work on one file.
void inspect_file(const PictureRequest& picture, Task task, InspectionRow& row, std::vector<ReportPicture>& pictures,
                  Context& context) {
    Scene loaded = load(picture.input, picture.load, context);
    const std::vector<ClipTime> clips = clips_of(loaded, picture.motion);
    const Scene scene = scene_at(std::move(loaded), clips, context.memory());
    task.options.prepare = picture.prepare;
    task.options.weld_distance = picture.prepare.weld_distance;
    task.options.border_distance = picture.prepare.border_distance;
    row.inspection = inspect(scene, task.options, context);
    row.inspection->file = row.file;
    if (task.limits) row.check = check_limits(*row.inspection, *task.limits);
    if (const std::string seams = proposal_text(*row.inspection); task.limits && !seams.empty())
        context.report().add(Remark::warning, picture.input, {}, "not checked: " + seams, {"border-distance"});
    if (task.options.seam_lines) {
        const Frame map =
            draw_seams(scene, *row.inspection, task.options, seam_view(picture), picture.settings, context, task.marks);
        if (task.has_page) pictures = page_pictures(scene, picture, task, *row.inspection, map, context);
        context.progress("write", 0);
        if (!picture.output.empty()) save(map, row.heat_map = picture.output);
    }
    row.inspection->seam_lines = {};
}

/// The output about a model: whether it passed if it is only checked, else all tables.
std::string text_of(const Run& run, const InspectionRow& row, const std::optional<CheckLimits>& limits, bool is_first) {
    if (!row.check || run.loudness == Loudness::verbose)
        return (is_first ? "" : "\n") + with_options(to_text(*row.inspection), {"border-distance"});
    if (!row.check->empty() || run.loudness == Loudness::quiet) return {};
    return one_line(row.file) + ": passed: " + to_text(*limits) + "\n";
}

/// One line a limit; returns the exit code.
int print_failures(const InspectionRow& row) {
    if (!row.check || row.check->empty()) return 0;
    for (const CheckFailure& failure : *row.check)
        print_error(Error(ErrorCode::check_failed, failure.limit + ": " + failure.message).with_file(row.file));
    return exit_code(ErrorCode::check_failed);
}

/// The heat map is the picture.
std::vector<InputRequest> requests_of(Run run) {
    std::vector<InputRequest> requests;
    run.picture.output = run.given.word("heatmap");
    if (run.picture.output.empty()) {
        for (const std::string& file : run.inputs) requests.push_back(request_for(run, file));
        return requests;
    }
    requests = picture_requests(run);
    check_requests(requests);
    return requests;
}

void write_reports(const Reports& reports, const InspectionPage& page, const std::vector<InspectionRow>& rows,
                   const std::optional<CheckLimits>& limits) {
    if (!reports.is_any() || CancelOnInterrupt::happened()) return;
    for (const std::string& file : reports.pages) page.save(file);
    for (const std::string& file : reports.junit) save_text(file, to_junit(rows, *limits));
}

/// Seams between files are not among those of each file.
void note_groups(const Run& run, const Task& task) {
    if (run.inputs.size() < 2 || !task.options.borders || run.loudness == Loudness::quiet) return;
    if (CancelOnInterrupt::happened()) return;
    SmoothFileOptions options;
    options.attributes.weld_distance = run.picture.prepare.weld_distance;
    options.load = run.picture.load;
    for (const FileGroup& group : groups_by_borders(run, run.inputs, options))
        if (group.members.size() > 1)
            print_message(
                group.title + ": open borders fit together; --as-one inspects them as one model, as smooth joins them",
                run.loudness);
}

int run_inspect(const Run& run) {
    const Reports reports(run.given);
    const Task task{
        .options = options_of(run),
        .limits = limits_of(run.given, !reports.junit.empty()),
        .marks = run.given.has("heatmap-legend") && !values::on_off("heatmap-legend", run.given.word("heatmap-legend"))
                     ? SeamMarks::none
                     : SeamMarks::legend,
        .has_page = !reports.pages.empty()};
    check_heat_map(run);
    InspectionPage page;
    std::vector<InspectionRow> rows;
    std::string text;  // what is reported once the reports are written: who reads it may stop
    int worst = 0;
    for (const InputRequest& input : requests_of(run)) {
        const PictureRequest& picture = input.picture;
        InspectionRow row{.file = name_of(picture)};
        std::vector<ReportPicture> pictures;
        if (CancelOnInterrupt::happened()) {
            row.error = Error(ErrorCode::failed, "cancelled").with_file(picture.input);
            rows.push_back(std::move(row));
            continue;
        }
        worst = std::max(
            worst, run_input(run, input, row, [&](Context& c) { inspect_file(picture, task, row, pictures, c); }));
        if (!run.is_json && row.inspection) text += text_of(run, row, task.limits, rows.empty());
        if (!reports.is_any()) print_text(std::exchange(text, {}));
        worst = std::max(worst, print_failures(row));
        if (!row.heat_map.empty())
            print_note(
                row.heat_map + ": seams from 0.01 degrees dark blue through 1 violet, 5 red, 20 orange to 60 yellow",
                run.loudness);
        if (task.has_page) page.add(row, pictures);
        rows.push_back(std::move(row));
    }
    note_groups(run, task);
    write_reports(reports, page, rows, task.limits);
    print_text(text);
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

}  // namespace

const Verb inspect_verb = {inspect_command, run_inspect};

}  // namespace rakelight::cli
