// SPDX-License-Identifier: Apache-2.0
// Comparisons as a table, and as the program's JSON, schema rakelight.compare/1: fields are added, never renamed.
#include <nlohmann/json.hpp>

#include <rakelight/tools/rows.h>

#include "tools/compare/compare_numbers.h"
#include "tools/report_json.h"
#include "tools/text_table.h"

namespace rakelight {
namespace {

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

void add(Json& row, const PictureComparison& c, const ComparisonRow& r) {
    row["width"] = c.width;
    row["height"] = c.height;
    row["equal"] = c.is_equal();  // tells a PSNR without end, null, from a RMSE without end, which is null too
    row["max_error"] = finite_or_null(c.max_error);
    row["rmse"] = finite_or_null(c.rmse);
    row["psnr_db"] = finite_or_null(c.psnr_db);
    row["ssim"] = c.ssim ? Json(*c.ssim) : Json();
    row["flip"] = c.flip;
    row["pixels_per_degree"] = r.options.pixels_per_degree;
    row["tolerance"] = r.options.tolerance;
    row["differing_pixels"] = c.differing_pixels;
    row["differing_share"] = c.differing_share;
    Json failures = Json::array();
    for (const CheckFailure& f : r.failures) failures.push_back({{"limit", f.limit}, {"message", f.message}});
    row["check"] = {{"passed", r.failures.empty()}, {"failures", failures}};
    if (!r.output.empty()) row["output"] = r.output;
}

}  // namespace

std::string title_of(const std::string& name, const std::string& engine) {
    return one_line(name) + (engine.empty() ? "" : " (" + one_line(engine, 40) + ")");
}

std::string to_text(std::span<const ComparisonRow> rows) {
    std::vector<std::string> head = {"A", "B"};
    for (const auto& [name, value] : numbers_of({})) head.push_back(">" + name);
    TextTable table(head);
    for (const ComparisonRow& r : rows) {
        if (!r.comparison) continue;
        std::vector<std::string> cells = {title_of(r.a, r.engine_a), title_of(r.b, r.engine_b)};
        for (auto& [name, value] : numbers_of(*r.comparison)) cells.push_back(value);
        table.add(std::move(cells));
    }
    return table.empty() ? std::string() : table.text("");
}

std::string to_json(std::span<const ComparisonRow> rows) {
    Json list = Json::array();
    for (const ComparisonRow& r : rows) {
        Json row = {{"a", r.a}, {"b", r.b}};
        if (!r.engine_a.empty()) row["engine_a"] = r.engine_a;
        if (!r.engine_b.empty()) row["engine_b"] = r.engine_b;
        if (r.error) row["error"] = error_json(*r.error);
        if (r.comparison) add(row, *r.comparison, r);
        row["remarks"] = remarks_json(r.remarks);
        row["remarks_left_out"] = r.remarks_left_out;
        list.push_back(std::move(row));
    }
    return document("rakelight.compare/1", std::move(list));
}

}  // namespace rakelight
