// SPDX-License-Identifier: Apache-2.0
#include "tools/stages/page.h"

#include <span>

#include <nlohmann/json.hpp>

#include "base/format_text.h"
#include "tools/html.h"
#include "tools/report_json.h"

namespace rakelight::stages {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 72rem; margin: 0 auto; padding: 1rem; background: Canvas; color: CanvasText; }
h1 { font-size: 1.7rem; overflow-wrap: anywhere; } h2 { font-size: 1.3rem; margin-top: 3rem; border-top: 1px solid GrayText; padding-top: 1rem; }
p { max-width: 46rem; } nav ol { columns: 18rem; column-gap: 3rem; } figure { margin: 1rem 0; } img { max-width: 100%; height: auto; display: block; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(26rem, 100%), 1fr)); gap: 0 1rem; }
figcaption, caption { text-align: left; color: GrayText; font-size: .9rem; padding: .3rem 0; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; margin: .5rem 0; }
th, td { text-align: right; padding: .1rem .8rem .1rem 0; border-bottom: 1px solid color-mix(in srgb, GrayText 30%, transparent); white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
.matrix { margin: 0; border-inline: 1px solid GrayText; } .matrix td { border: 0; text-align: right; padding: 0 .5rem; }
)";

std::string cell_text(const Cell& v);

std::string matrix_html(const Cell::List& rows) {
    std::string out = "<table class=\"matrix\">";
    for (const Cell& row : rows) {
        out += "<tr>";
        for (const Cell& v : row.list) out += "<td>" + cell_text(v) + "</td>";
        out += "</tr>";
    }
    return out + "</table>";
}

bool is_list(const Cell& v) { return v.kind == Cell::Kind::list; }

std::string cell_text(const Cell& v) {
    if (v.kind == Cell::Kind::text) return html_text(v.text);
    if (v.kind == Cell::Kind::number) return digits(v.number);
    if (v.kind == Cell::Kind::whole) return std::to_string(v.whole);
    if (v.list.size() == 4 && is_list(v.list[0]) && v.list[0].list.size() == 4) return matrix_html(v.list);
    std::string out;
    for (const Cell& part : v.list) out += (out.empty() ? "" : is_list(part) ? " | " : " ") + cell_text(part);
    return out;
}

std::string numbers_html(const Numbers& numbers) {
    if (numbers.empty()) return {};
    std::string out = "<div class=\"scroll\"><table>\n";
    for (const auto& [name, value] : numbers) {
        const bool is_range = name.starts_with("range of ") && is_list(value) && value.list.size() == 2;
        out += "<tr><td>" + html_text(name) + "</td><td>" +
               (is_range ? cell_text(value.list[0]) + " to " + cell_text(value.list[1]) : cell_text(value)) +
               "</td></tr>\n";
    }
    return out + "</table></div>\n";
}

std::string rows_html(const Stage& stage) {
    if (stage.rows.empty()) return stage.rows_note.empty() ? "" : "<p>" + html_text(stage.rows_note) + "</p>\n";
    std::string out =
        "<details><summary>" + html_text(stage.rows_note) + "</summary><div class=\"scroll\"><table>\n<tr>";
    for (const std::string& column : stage.columns) out += "<th>" + html_text(column) + "</th>";
    out += "</tr>\n";
    for (const Cell::List& row : stage.rows) {
        out += "<tr>";
        for (const Cell& cell : row) out += "<td>" + cell_text(cell) + "</td>";
        out += "</tr>\n";
    }
    return out + "</table></div></details>\n";
}

/// A link to a picture opens it; one in the page itself is shown as large as it is by the browser.
std::string picture_html(const Picture& p, bool is_whole) {
    const std::string file = p.name + ".png", address = is_whole ? png_uri(p.canvas.pixels()) : file;
    const std::string image = format_text("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\">", address,
                                          p.canvas.width(), p.canvas.height(), html_text(p.caption));
    return "<figure>" + (is_whole ? image : "<a href=\"" + file + "\">" + image + "</a>") + "<figcaption>" +
           html_text(p.caption) + "</figcaption></figure>\n";
}

std::string table_link(const Stage& stage, bool is_whole) {
    const std::string name = stage.id + ".json";
    if (!is_whole) return "<a href=\"" + name + "\">" + name + "</a>";
    const std::string table = table_json(stage);
    return "<a download=\"" + name + "\" href=\"" + data_uri("application/json", std::as_bytes(std::span(table))) +
           "\">" + name + "</a>";
}

std::string stage_html(const Stage& stage, std::size_t number, bool is_whole) {
    std::string out = format_text("<section id=\"{}\">\n<h2>{}. {}</h2>\n<p>{}</p>\n", stage.id, number,
                                  html_text(stage.title), html_text(stage.text));
    out += stage.pictures.size() > 1 ? "<div class=\"pictures\">\n" : "";
    for (const Picture& p : stage.pictures) out += picture_html(p, is_whole);
    out += stage.pictures.size() > 1 ? "</div>\n" : "";
    return out + numbers_html(stage.numbers) + rows_html(stage) + "<p>" + table_link(stage, is_whole) +
           "</p>\n</section>\n";
}

Json json_of(const Cell& cell) {
    if (cell.kind == Cell::Kind::text) return cell.text;
    if (cell.kind == Cell::Kind::number) return cell.number;
    if (cell.kind == Cell::Kind::whole) return cell.whole;
    Json all = Json::array();
    for (const Cell& part : cell.list) all.push_back(json_of(part));
    return all;
}

}  // namespace

std::string table_json(const Stage& stage) {
    Json pictures = Json::array();
    for (const Picture& p : stage.pictures) pictures.push_back({{"file", p.name + ".png"}, {"caption", p.caption}});
    Json numbers = Json::object(), rows = Json::array();
    for (const auto& [name, value] : stage.numbers) numbers[name] = json_of(value);
    for (const Cell::List& row : stage.rows) rows.push_back(json_of(row));
    const Json whole = {
        {"schema", "rakelight.stages/1"}, {"stage", stage.id},  {"title", stage.title},     {"text", stage.text},
        {"pictures", pictures},           {"numbers", numbers}, {"columns", stage.columns}, {"rows", rows},
        {"rows_note", stage.rows_note}};
    return json_text(whole, 1);
}

std::string page(const std::string& model, const std::vector<Stage>& stages, bool is_whole, Context& context) {
    std::string out =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\">\n<title>" +
        html_text(model) + ": stages</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" + html_text(model) +
        ": from the model to the picture</h1>\n<p>Numbers and pictures are intermediate results of the soft engine "
        "itself; a stage that shows a textbook's method instead says so.</p>\n<nav><ol>\n";
    for (const Stage& s : stages) out += "<li><a href=\"#" + s.id + "\">" + html_text(s.title) + "</a></li>\n";
    out += "</ol></nav>\n<main>\n";
    for (std::size_t i = 0; i < stages.size(); ++i) {
        context.throw_if_cancelled();
        if (is_whole) context.progress("write", double(i) / double(stages.size()));
        out += stage_html(stages[i], i + 1, is_whole);
    }
    return out + "</main>\n</body>\n</html>\n";
}

}  // namespace rakelight::stages
