// SPDX-License-Identifier: Apache-2.0
// Pictures as the program's JSON, schema rakelight.render/1: fields are added, never renamed.
#include <rakelight/tools/rows.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "tools/report_json.h"

namespace rakelight {

namespace {

void add_result(Json& row, const PictureResult& r) {
    row["width"] = r.width;
    row["height"] = r.height;
    row["triangles"] = r.triangles;
    row["objects"] = r.objects;
    row["engine"] = r.engine;
    row["isa"] = r.isa;
    row["threads"] = r.threads;
    row["load_ms"] = r.load_ms;
    row["prepare_ms"] = r.prepare_ms;
    row["render_ms"] = r.render_ms;
    row["write_ms"] = r.write_ms;
    row["black_pixels"] = r.black_pixels;
    row["white_pixels"] = r.white_pixels;
    row["channel_files"] = r.channel_files;
    const ChannelRange& range = r.channel_range;
    row["view_range"] = {
        {"depth_m", {range.depth_low, range.depth_high}},
        {"position_m", {{range.low.x, range.low.y, range.low.z}, {range.high.x, range.high.y, range.high.z}}}};
    row["stats"] = stats_json(r.stats);
}

Json reference_json(const ReferenceResult& r) {
    Json json = {{"file", r.reference},
                 {"measure", reference_measure_words[std::size_t(r.measure)].name},
                 {"value", r.value && std::isfinite(*r.value) ? Json(*r.value) : Json()},
                 {"threshold", r.threshold},
                 {"passed", r.passed}};
    if (!r.difference.empty()) json["difference"] = r.difference;
    return json;
}

}  // namespace

std::string to_json(std::span<const PictureRow> rows) {
    Json list = Json::array();
    for (const PictureRow& r : rows) {
        Json row = {{"file", r.result.file}, {"output", r.result.output}};
        if (r.frame) {
            row["frame"] = r.frame->frame;
            row["time_s"] = r.frame->time_s;
            row["skipped"] = r.frame->is_skipped;
        }
        if (r.movie_pictures > 0) row["movie_pictures"] = r.movie_pictures;
        if (r.error)
            row["error"] = error_json(*r.error);
        else if (r.movie_pictures == 0 && !(r.frame && r.frame->is_skipped))
            add_result(row, r.result);
        if (r.reference) row["reference"] = reference_json(*r.reference);
        row["remarks"] = remarks_json(r.remarks);
        row["remarks_left_out"] = r.remarks_left_out;
        list.push_back(std::move(row));
    }
    return document("rakelight.render/1", std::move(list));
}

}  // namespace rakelight
