// SPDX-License-Identifier: Apache-2.0
// What smoothing would do to a model, as a page of one file: no script, pictures inside.
#include <rakelight/tools/smooth_file.h>

#include <cstdio>
#include <filesystem>
#include <map>

#include "base/format_text.h"
#include "io/files/output_file.h"
#include "math/color.h"
#include "prepare/normals/repair_borders.h"
#include "prepare/normals/repair_seams.h"
#include "tools/html.h"
#include "tools/object_title.h"
#include "tools/smooth/smooth_file_scene.h"

namespace rakelight {
namespace {

constexpr std::size_t most_rows = 40;

constexpr const char* style = R"(
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 100rem; padding: 1rem; background: Canvas; color: CanvasText; }
h1 { font-size: 1.5rem; overflow-wrap: anywhere; } h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(24rem, 1fr)); gap: 1rem; } figure { margin: 0; } img { width: 100%; height: auto; }
.legend { height: 1rem; max-width: 40rem; } .marks { display: flex; justify-content: space-between; max-width: 40rem; font-size: .85rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; } .scroll { overflow: auto; }
th, td { text-align: right; padding: .1rem 1.5rem .1rem 0; } th { font-weight: normal; color: GrayText; font-size: .85rem; } .name { text-align: left; }
p { max-width: 60rem; }
)";

/// An angle; what is rounding is 0.
std::string number(double x) {
    if (x < 0.001) return "0";
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", x);
    return text;
}

std::string css(vec3 linear) {
    char text[32];
    const auto code = [](float x) { return int(srgb8_from_linear(x)); };
    std::snprintf(text, sizeof text, "#%02x%02x%02x", code(linear.x), code(linear.y), code(linear.z));
    return text;
}

/// The colors of heat_color() over its marks, evenly spaced.
std::string legend_html() {
    std::string stops, marks;
    for (const double deg : {0.01, 1.0, 5.0, 20.0, 60.0}) {
        stops += ", " + css(heat_color(deg));
        marks += "<span>" + number(deg) + "&deg;</span>";
    }
    return "<div class=\"legend\" style=\"background: linear-gradient(to right" + stops +
           ")\"></div>\n<div class=\"marks\">" + marks + "</div>\n";
}

std::string figure_html(const char* title, const Frame& frame) {
    return std::string("<figure><img alt=\"") + title + "\" src=\"" + data_uri("image/png", encode(frame, ".png")) +
           "\"><figcaption>" + title + "</figcaption></figure>\n";
}

std::string row_html(const char* tag, std::initializer_list<std::string> cells) {
    std::string row = "<tr>";
    bool is_first = true;
    for (const std::string& cell : cells) {
        row += std::string("<") + tag + (is_first ? " class=\"name\">" : ">") + cell + "</" + tag + ">";
        is_first = false;
    }
    return row + "</tr>\n";
}

/// Seams over the whole model, before and after.
std::string totals_html(const SeamTotals& before, const SeamTotals& after) {
    const auto row = [](const char* name, const SeamTotals& t) {
        return row_html("td", {name, number(t.seam_deg), number(t.before.max_deg), number(t.before.mean_deg),
                               std::to_string(t.continuous)});
    };
    return "<div class=\"scroll\"><table>\n" +
           row_html("th", {"normals", "largest seam [deg]", "largest angle [deg]", "mean angle [deg]",
                           format_text("continuous of {} shared positions", before.positions)}) +
           row("before", before) + row("after", after) + "</table></div>\n";
}

/// The borders with the largest seams before; both inspections list the same objects.
std::string borders_html(const Inspection& before, const Inspection& after) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, const BorderSummary*> now;
    for (const BorderSummary& b : after.borders) now[{b.object_a, b.object_b}] = &b;
    const auto name = [&](std::uint32_t object) { return html_text(one_line(before.objects[object].name, 60)); };
    std::string rows;
    std::size_t count = 0;
    for (const BorderSummary& b : before.borders) {
        if (!(b.seam_deg > continuous_deg) || count++ == most_rows) break;
        const auto found = now.find({b.object_a, b.object_b});
        const bool is_there = found != now.end();
        rows += row_html("td", {name(b.object_a), name(b.object_b), std::to_string(b.positions), number(b.seam_deg),
                                is_there ? number(found->second->seam_deg) : "?", number(b.largest_deg),
                                is_there ? number(found->second->largest_deg) : "?"});
    }
    if (rows.empty()) return "<p>No positions that two meshes share have a seam.</p>\n";
    return "<div class=\"scroll\"><table>\n" +
           row_html("th", {"object", "object", "shared", "seam before", "after", "largest angle before", "after"}) +
           rows + "</table></div>\n";
}

/// Seams along open borders without shared vertices, before and after; nothing where they were not requested.
std::string matched_html(const MatchedSeams& before, const MatchedSeams& after) {
    if (!(before.distance > 0)) return "";
    const auto row = [](const char* name, const CurveAngles& seam) {
        return row_html("td", {name, number(seam.max_deg), number(seam.mean_deg), number(seam.p95_deg)});
    };
    return "<h2>Borders that run along each other without shared vertices</h2>\n<div class=\"scroll\"><table>\n" +
           row_html("th", {"normals", "largest angle [deg]", "mean [deg]", "95 % at most [deg]"}) +
           row("before", before.before) + row("after", after.before) + "</table></div>\n";
}

InspectOptions inspect_options(const SmoothFileOptions& options) {
    InspectOptions out;
    out.surfaces = false;
    out.seam_lines = true;
    out.weld_distance = options.attributes.weld_distance;
    out.border_distance = options.border_distance;
    out.authored = options.authored;
    out.prepare.crease_angle_rad = options.attributes.crease_angle_rad;
    out.prepare.creases = options.attributes.creases;
    out.prepare.weight = options.attributes.weight;
    return out;
}

void write_text(const std::string& path, const std::string& text) {
    io::OutputFile file(path);
    file.write(std::as_bytes(std::span(text)));
    file.commit();
}

std::string page_of(const std::string& name, const std::string& what, const std::string& body) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\">\n<title>" +
           html_text(name) + ": seams before and after</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" +
           html_text(name) + "</h1>\n<p>" + html_text(what) + ". No model was written.</p>\n" + body +
           "</body>\n</html>\n";
}

}  // namespace

SmoothedFile preview_smooth(const std::string& input, const PreviewPlace& place, const SmoothFileOptions& options,
                            const ViewRequest& view, const RenderSettings& settings, Context& context) {
    const Scene before = load(input, options.load, context);
    const SmoothedScene after = smooth_for_file(before, options, context);
    SmoothedFile result{.file = input,
                        .output = place.page,
                        .missing_made = after.missing_made,
                        .seams = after.seams,
                        .borders = after.borders};
    result.changed =
        !after.seams || after.seams->turned + after.missing_made > 0 || (after.borders && after.borders->turned > 0);
    const InspectOptions look = inspect_options(options);
    const Inspection a = inspect(before, look, context), b = inspect(after.scene, look, context);
    const Frame seams_before = draw_seams(before, a, look, view, settings, context),
                seams_after = draw_seams(after.scene, b, look, view, settings, context);
    if (!place.picture_before.empty()) save(seams_before, place.picture_before);
    if (!place.picture_after.empty()) save(seams_after, place.picture_after);
    const std::string name = std::filesystem::path(input).filename().string();
    const std::string what = (after.seams ? describe(*after.seams, after.missing_made) : "all normals are recomputed") +
                             (after.borders ? "; " + describe(*after.borders) : "");
    write_text(place.page, page_of(name, what,
                                   "<div class=\"pair\">\n" + figure_html("before", seams_before) +
                                       figure_html("after", seams_after) +
                                       "</div>\n<h2>Angle between the normals of two meshes</h2>\n" + legend_html() +
                                       totals_html(a.seams, b.seams) + matched_html(a.matched, b.matched) +
                                       "<h2>Borders</h2>\n" + borders_html(a, b)));
    return result;
}

}  // namespace rakelight
