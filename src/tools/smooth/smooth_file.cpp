// SPDX-License-Identifier: Apache-2.0
#include <rakelight/tools/smooth_file.h>

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/format_text.h"
#include "io/files/beside.h"
#include "io/files/held_outputs.h"
#include "prepare/normals/repair_borders.h"
#include "prepare/normals/repair_seams.h"
#include "scene/charge_arrays.h"
#include "scene/merge_scenes.h"
#include "tools/report_json.h"
#include "tools/smooth/model_rewrite.h"
#include "tools/smooth/smooth_file_scene.h"
#include "world/placed_in_world.h"
#include "world/z_up.h"

namespace rakelight {
namespace {

/// Two outputs must not be one file, by whatever name.
void check_outputs(const std::vector<ModelRewrite>& models) {
    for (std::size_t i = 0; i < models.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (io::is_same_place(models[i].output, models[j].output))
                throw Error(ErrorCode::usage,
                            "'" + one_line(models[j].input, 80) + "' and '" + one_line(models[i].input, 80) +
                                "' would both be written to '" + one_line(models[i].output, 80) + "'",
                            {}, "give each file an output of its own");
}

/// They are one model: if only some were turned, they would not fit together.
void turn_all_or_none(std::vector<ModelRewrite>& models, Report& report) {
    if (std::ranges::all_of(models, &ModelRewrite::has_z_up)) return;
    for (ModelRewrite& model : models)
        if (std::exchange(model.has_z_up, false)) warn_of_lying(model.input, {}, beside_y_up, report);
}

std::vector<ModelRewrite> begin_all(std::span<const FileToSmooth> files, const SmoothFileOptions& options,
                                    Context& context) {
    std::vector<ModelRewrite> models;
    for (const FileToSmooth& file : files) try {
            models.push_back(begin_rewrite(file.input, file.output, options.load, context));
            const RewriteWay way = models.back().way;
            if (options.bitangents && way != RewriteWay::gltf_in_place && way != RewriteWay::new_gltf)
                throw Error(ErrorCode::usage, "only glTF can store separate bitangents", {}, "write .glb or .gltf");
        } catch (const Error& error) {
            if (files.size() == 1) throw;
            throw error.with_file(file.input);
        }
    check_outputs(models);
    turn_all_or_none(models, context.report());
    return models;
}

/// Positions that were rounded on the way into the world count as equal again.
void choose_weld_distance(const std::vector<ModelRewrite>& models, AttributeOptions& attributes) {
    if (attributes.weld_distance >= 0) return;
    for (const ModelRewrite& model : models)
        if (model.way == RewriteWay::new_obj || model.way == RewriteWay::new_ply)
            attributes.weld_distance = std::max(attributes.weld_distance, world_rounding(model.before));
}

MergedScene merged(const std::vector<ModelRewrite>& models, Context& context) {
    std::vector<ScenePart> parts;
    for (const ModelRewrite& model : models) parts.push_back({model.before, {}, false, false});
    return merge_scenes(parts, context);
}

/// One model's scene with the meshes that it has in the smoothed whole. Copies of meshes follow the meshes of all models there.
Scene part_of(const Scene& whole, const Scene& before, const MergeOffsets& at, std::size_t all_meshes) {
    Scene part = before;
    const auto taken = [&](std::uint32_t mesh, std::uint32_t was) {
        Mesh out = whole.meshes[mesh];
        out.material = before.meshes[was].material;
        return out;
    };
    for (std::size_t m = 0; m < before.meshes.size(); ++m)
        part.meshes[m] = taken(std::uint32_t(at.meshes + m), std::uint32_t(m));
    for (std::size_t n = 0; n < part.nodes.size(); ++n) {
        const std::vector<std::uint32_t>& shown = whole.nodes[at.nodes + n].meshes;
        for (std::size_t slot = 0; slot < shown.size(); ++slot) {
            if (shown[slot] < all_meshes) {
                part.nodes[n].meshes[slot] = shown[slot] - at.meshes;
                continue;
            }
            part.meshes.push_back(taken(shown[slot], before.nodes[n].meshes[slot]));
            part.nodes[n].meshes[slot] = std::uint32_t(part.meshes.size() - 1);
        }
    }
    return part;
}

// What is written of a result.

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

SmoothFileOptions smooth_options_for(const PictureRequest& request) {
    const PrepareOptions& prepare = request.prepare;
    SmoothFileOptions options;
    options.attributes.crease_angle_rad = prepare.crease_angle_rad;
    options.attributes.creases = prepare.creases;
    options.attributes.weight = prepare.weight;
    options.border_distance = prepare.border_distance;
    options.keep_instances = prepare.keep_instances;
    options.load = request.load;
    return options;
}

std::vector<SmoothedFile> smooth_files(std::span<const FileToSmooth> files, const SmoothFileOptions& options,
                                       Context& context) {
    if (files.empty()) return {};
    const std::vector<ModelRewrite> models = begin_all(files, options, context);
    SmoothFileOptions smoothing = options;
    choose_weld_distance(models, smoothing.attributes);
    context.progress("smooth", 0);
    const std::optional<MergedScene> joined = models.size() > 1 ? std::optional(merged(models, context)) : std::nullopt;
    const Scene& whole = joined ? joined->scene : models[0].before;
    const auto [after, seams, missing_made, borders] = smooth_for_file(whole, smoothing, context);
    std::vector<SmoothedFile> results;
    io::HeldOutputs outputs;
    for (std::size_t i = 0; i < models.size(); ++i) {
        const ModelRewrite& model = models[i];
        SmoothedFile& result = results.emplace_back();
        result.file = model.input, result.output = model.output;
        for (std::size_t other = 0; other < models.size(); ++other)
            if (other != i) result.together.push_back(models[other].input);
        result.seams = seams, result.borders = borders, result.missing_made = missing_made;
        std::optional<Scene> part;
        const MemoryCharge charge(context.memory(), joined ? table_bytes(model.before) : 0, "the smoothed scene");
        if (joined) part = part_of(after, model.before, joined->offsets[i], whole.meshes.size());
        finish_rewrite(model, part ? *part : after, options, result, context);
    }
    outputs.commit();
    return results;
}

SmoothedFile smooth_file(const std::string& input, const std::string& output, const SmoothFileOptions& options,
                         Context& context) {
    const FileToSmooth file{input, output};
    return smooth_files({&file, 1}, options, context).front();
}

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
