// SPDX-License-Identifier: Apache-2.0
// The page has the worst first: exceeded limits, heat maps, seams, faults.
#include <rakelight_internal/tools/inspection_report.h>

#include <algorithm>
#include <filesystem>

#include <rakelight_internal/tools/text_file.h>

#include "base/format_text.h"
#include "render/rows.h"
#include "tools/html.h"
#include "tools/inspect/largest_seam.h"
#include "tools/inspect/seam_sections.h"
#include "tools/report_json.h"

namespace rakelight {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --bad: light-dark(#b3261e, #f2786f); --good: light-dark(#1b6e3c, #6fcf97); }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 76rem; margin: 0 auto; padding: 1rem; background: Canvas; color: CanvasText; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.3rem; margin-top: 3rem; border-top: 1px solid GrayText; padding-top: 1rem; overflow-wrap: anywhere; }
h3 { font-size: 1rem; margin: 1.5rem 0 .3rem; } p { max-width: 60rem; margin: .3rem 0; } figure { margin: .5rem 0; } img { max-width: 100%; height: auto; display: block; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(32rem, 100%), 1fr)); gap: 0 1rem; }
figcaption, .note, th { color: GrayText; font-size: .85rem; } .scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; font-weight: normal; padding: .1rem 1rem .1rem 0; border-bottom: 1px solid color-mix(in srgb, GrayText 30%, transparent); white-space: nowrap; }
.r { text-align: right; } .bad { color: var(--bad); } .good { color: var(--good); } nav td:first-child { white-space: normal; overflow-wrap: anywhere; }
)";

std::string table_html(const TextTable& table) {
    std::string out = "<div class=\"scroll\"><table>\n";
    bool is_head = true;
    for (const std::vector<std::string>& row : table.rows()) {
        out += "<tr>";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string name = is_head ? "th" : "td";
            out +=
                "<" + name + (table.is_to_the_right(c) ? " class=\"r\">" : ">") + html_text(row[c]) + "</" + name + ">";
        }
        out += "</tr>\n";
        is_head = false;
    }
    return out + "</table></div>\n";
}

std::string section_html(const Section& s) {
    std::string out = "<h3>" + html_text(s.title) + "</h3>\n";
    if (!s.table.empty()) out += table_html(s.table);
    if (!s.note.empty()) out += "<p class=\"note\">" + html_text(s.note) + "</p>\n";
    return out;
}

/// Where pairs have seams, what there is to see of the worst.
std::string worst_seam_html(const Inspection& i) {
    const std::optional<LargestSeam> worst = largest_seam(i);
    if (!worst) return {};
    return "<p>The largest seam, " + number(worst->deg, "%.2f") + " degrees, is " + html_text(between_text(i, *worst)) +
           ", at " + position_text(worst->position) + " " + i.unit + ".</p>\n";
}

/// The largest seam, or that nothing could have one.
std::string seam_cell(const Inspection& i) {
    if (i.shared_positions == 0 && i.matched.pairs.empty()) return "-";
    return number(std::max(i.seams.seam_deg, i.matched.seam_deg), "%.2f");
}

std::string check_html(const InspectionRow& row) {
    if (!row.check) return {};
    if (row.check->empty()) return "<p class=\"good\">No limit is exceeded.</p>\n";
    std::string out;
    for (const CheckFailure& failure : *row.check)
        out += "<p class=\"bad\">" + html_text(failure.limit + ": " + failure.message) + "</p>\n";
    return out;
}

std::string pictures_html(std::span<const ReportPicture> pictures) {
    if (pictures.empty()) return {};
    std::string out = "<div class=\"pictures\">\n";
    for (const ReportPicture& p : pictures)
        out += format_text(
            "<figure><img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"{}\"><figcaption>{}</figcaption></figure>\n",
            html_text(p.caption), p.pixels.width, p.pixels.height, png_uri(p.pixels), html_text(p.caption));
    return out + "</div>\n";
}

/// Borders and faults before what the model holds.
std::string tables_html(const Inspection& i) {
    std::vector<Section> sections = sections_of(i);
    constexpr std::string_view first[] = {"borders (degrees)", matched_title, "T-junctions", "inside out", "surfaces"};
    const auto place = [&](const Section& s) { return std::ranges::find(first, s.title) - std::begin(first); };
    std::ranges::stable_sort(sections, {}, place);
    std::string out;
    for (const Section& s : sections) out += section_html(s);
    return out;
}

std::string verdict_html(const InspectionRow& row) {
    if (row.error) return "<span class=\"bad\">cannot be read</span>";
    if (row.check)
        return row.check->empty() ? "<span class=\"good\">passed</span>"
                                  : "<span class=\"bad\">fails " + counted(row.check->size(), "limit") + "</span>";
    return "";
}

/// Of "out/left.obj + out/right.obj", too: folder names may be private.
std::string without_folders(const std::string& files) {
    constexpr std::string_view between = " + ";
    const std::size_t end = files.find(between);
    const std::string first = std::filesystem::path(files.substr(0, end)).filename().string();
    return end == files.npos ? first
                             : first + std::string(between) + without_folders(files.substr(end + between.size()));
}

// Checks as JUnit's XML: what build servers show as tests.

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + html_text(value) + "\"";
}

std::string test_case(const InspectionRow& row, const std::string& name, const std::string& inside) {
    const std::string head =
        "    <testcase" + attribute("classname", row.file.empty() ? "?" : row.file) + attribute("name", name);
    return head + (inside.empty() ? "/>\n" : ">\n" + inside + "    </testcase>\n");
}

std::string fault(const char* kind, const std::string& type, const std::string& message) {
    return std::string("      <") + kind + attribute("type", type) + attribute("message", message) + ">" +
           html_text(message) + "</" + kind + ">\n";
}

struct Suite {
    std::string cases;
    std::size_t tests = 0, failures = 0, errors = 0;
};

Suite suite_of(const InspectionRow& row, const CheckLimits& limits) {
    Suite suite;
    const auto add = [&](const std::string& name, const std::string& inside) {
        suite.cases += test_case(row, name, inside);
        ++suite.tests;
    };
    if (row.error) {
        add("load", fault("error", name_of(row.error->code()), row.error->what()));
        suite.errors = 1;
        return suite;
    }
    add("load", "");
    if (!row.check) return suite;
    for (const std::string& limit : names_of(limits)) {
        const auto failed =
            std::ranges::find_if(*row.check, [&](const CheckFailure& failure) { return failure.limit == limit; });
        const bool passed = failed == row.check->end();
        add(limit, passed ? "" : fault("failure", limit, failed->message));
        suite.failures += !passed;
    }
    return suite;
}

std::string counts(std::size_t tests, std::size_t failures, std::size_t errors) {
    return attribute("tests", std::to_string(tests)) + attribute("failures", std::to_string(failures)) +
           attribute("errors", std::to_string(errors));
}

}  // namespace

ReportPicture report_picture(std::string caption, const Frame& frame) {
    const PixelFormat format{.component = Component::u8, .channels = 3};
    Pixels pixels{frame.window.width, frame.window.height, 3, Component::u8, false, {}};
    pixels.bytes.resize(frame.color.size() * format.bytes());
    convert_row(frame.color.data(), frame.color.size(), format, ToneCurve(), pixels.bytes.data());
    return {std::move(caption), std::move(pixels)};
}

void InspectionPage::add(const InspectionRow& row, std::span<const ReportPicture> pictures) {
    const std::string id = "model-" + std::to_string(++models_), name = without_folders(row.file);
    const std::string seam = row.inspection ? seam_cell(*row.inspection) : "-";
    contents_ += "<tr><td><a href=\"#" + id + "\">" + html_text(name) + "</a></td><td class=\"r\">" +
                 (row.inspection ? std::to_string(row.inspection->objects.size()) : "-") + "</td><td class=\"r\">" +
                 seam + "</td><td>" + verdict_html(row) + "</td></tr>\n";
    sections_ += "<section id=\"" + id + "\">\n<h2>" + html_text(name) + "</h2>\n";
    if (row.error) sections_ += "<p class=\"bad\">" + html_text(row.error->what()) + "</p>\n";
    sections_ += check_html(row);
    if (row.inspection) {
        const Inspection& i = *row.inspection;
        for (const std::string& line : summary_lines(i)) sections_ += "<p>" + html_text(line) + "</p>\n";
        sections_ += worst_seam_html(i) + pictures_html(pictures) + tables_html(i);
    }
    sections_ += "</section>\n";
}

void InspectionPage::save(const std::string& path) const {
    const std::string title = counted(models_, "model") + " inspected";
    save_text(path,
              "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
              "content=\"width=device-width, initial-scale=1\">\n<title>" +
                  title + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" + title +
                  "</h1>\n<p>A seam is the angle between the normals of two meshes at a position that both share, if "
                  "rakelight smooth would remove it. Meshes are objects, or parts of an object with a material of "
                  "their own. On request, seams are also measured along open "
                  "borders that run along each other.</p>\n<nav><table>\n<tr><th>model</th><th "
                  "class=\"r\">objects</th><th class=\"r\">largest seam [degrees]</th><th>limits</th></tr>\n" +
                  contents_ + "</table></nav>\n<main>\n" + sections_ + "</main>\n</body>\n</html>\n");
}

std::string to_junit(std::span<const InspectionRow> rows, const CheckLimits& limits) {
    std::string suites;
    std::size_t tests = 0, failures = 0, errors = 0;
    for (const InspectionRow& row : rows) {
        const Suite s = suite_of(row, limits);
        suites += "  <testsuite" + attribute("name", row.file) + counts(s.tests, s.failures, s.errors) + ">\n" +
                  s.cases + "  </testsuite>\n";
        tests += s.tests, failures += s.failures, errors += s.errors;
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"rakelight inspect\"" +
           counts(tests, failures, errors) + ">\n" + suites + "</testsuites>\n";
}

}  // namespace rakelight
