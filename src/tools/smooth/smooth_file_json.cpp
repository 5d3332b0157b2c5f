// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include <rakelight/tools/rows.h>
#include <rakelight/tools/smooth_file.h>

#include "base/format_text.h"
#include "prepare/normals/repair_borders.h"
#include "prepare/normals/repair_seams.h"
#include "tools/report_json.h"

namespace rakelight {
namespace {

const char* name_of(SmoothedMesh::Change change) {
    switch (change) {
        case SmoothedMesh::Change::none:
            return "none";
        case SmoothedMesh::Change::kept:
            return "kept";
        case SmoothedMesh::Change::made:
            return "made";
        case SmoothedMesh::Change::replaced:
            return "replaced";
        case SmoothedMesh::Change::removed:
            return "removed";
        case SmoothedMesh::Change::turned:
            return "turned";
    }
    return "";
}

Json number_or_null(std::uint32_t n) { return n == no_index ? Json() : Json(n); }

Json json_of(const SmoothedMesh& m) {
    return {{"name", m.name},
            {"mesh", number_or_null(m.mesh)},
            {"primitive", number_or_null(m.primitive)},
            {"vertices", m.vertices},
            {"vertices_split", m.vertices_split},
            {"normals", name_of(m.normals)},
            {"tangents", name_of(m.tangents)}};
}

Json json_of(const SeamReport& s) {
    return {{"normals", s.normals},   {"turned", s.turned},         {"max_deg", s.max_deg},
            {"mean_deg", s.mean_deg}, {"flat_pairs", s.flat_pairs}, {"crease_pairs", s.crease_pairs},
            {"unusable", s.unusable}};
}

Json json_of(const MatchReport& b) {
    return {{"leading", b.leading}, {"following", b.following}, {"turned", b.turned},
            {"max_deg", b.max_deg}, {"mean_deg", b.mean_deg},   {"vertices_not_searched", b.vertices_not_searched}};
}

std::uint64_t split_of(const SmoothedFile& result) {
    std::uint64_t split = 0;
    for (const SmoothedMesh& m : result.meshes) split += m.vertices_split;
    return split;
}

}  // namespace

std::string to_json(std::span<const SmoothedFileRow> rows) {
    Json array = Json::array();
    for (const SmoothedFileRow& r : rows) {
        Json row = {{"file", r.file}};
        if (r.error) row["error"] = error_json(*r.error);
        if (r.result) {
            row["output"] = r.result->output;
            row["changed"] = r.result->changed;
            row["vertices_split"] = split_of(*r.result);
            row["meshes_added"] = r.result->meshes_added;
            if (!r.result->together.empty()) row["together"] = r.result->together;
            row["missing_made"] = r.result->missing_made;
            Json meshes = Json::array();
            for (const SmoothedMesh& m : r.result->meshes) meshes.push_back(json_of(m));
            row["meshes"] = std::move(meshes);
            if (r.result->seams) row["seams"] = json_of(*r.result->seams);
            if (r.result->borders) row["borders"] = json_of(*r.result->borders);
        }
        row["remarks"] = remarks_json(r.remarks);
        row["remarks_left_out"] = r.remarks_left_out;
        array.push_back(std::move(row));
    }
    return document("rakelight.smooth/1", std::move(array));
}

std::string summary_of_all(const SmoothedFile& result) {
    const std::string seams = result.seams ? describe(*result.seams, result.missing_made) : "";
    const std::string borders = result.borders ? describe(*result.borders) : "";
    return seams + (seams.empty() || borders.empty() ? "" : ", ") + borders;
}

std::string summary(const SmoothedFile& result) {
    using Change = SmoothedMesh::Change;
    const bool is_alone = result.together.empty();
    const std::string all = is_alone ? summary_of_all(result) : "";
    if (!result.changed)
        return result.output + ": nothing to change" +
               (!is_alone ? "" : ", " + (result.seams ? all : "the normals and tangents are already the same"));
    std::uint64_t normals = 0, tangents = 0;
    for (const SmoothedMesh& m : result.meshes) {
        const auto is_written = [&](Change change) {
            return change == Change::made || change == Change::replaced || (!is_alone && change == Change::turned);
        };
        normals += is_written(m.normals), tangents += is_written(m.tangents);
    }
    std::string text = all;
    if (!result.seams || normals + tangents > 0 || text.empty())
        text += (text.empty() ? "" : ", ") +
                format_text("normals of {} meshes and tangents of {} written, {} vertices split", normals, tangents,
                            split_of(result));
    return format_text("{}: {}, {} meshes added", result.output, text, result.meshes_added);
}

}  // namespace rakelight
