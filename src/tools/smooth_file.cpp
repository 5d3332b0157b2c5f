// SPDX-License-Identifier: Apache-2.0
#include <rakelight/smooth_file.h>

#include <algorithm>

#include "io/beside.h"
#include "io/file.h"
#include "io/glb_writer.h"
#include "io/gltf/save_gltf.h"
#include "io/obj/rewrite_normals.h"
#include "io/obj/write_obj.h"
#include "io/ply_writer.h"
#include "io/same_attributes.h"
#include "prepare/missing_normals.h"
#include "tools/smooth_file_scene.h"
#include "world/placed_in_world.h"

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
    if (models.size() == 1) return {models[0].before, {MergeOffsets{}}};
    std::vector<ScenePart> parts;
    for (const ModelRewrite& model : models) parts.push_back({model.before, {}, false, false});
    return merge_scenes(parts, context);
}

/// Whether any is one: files may hold zeros.
bool has_normals(const Mesh& mesh) { return !mesh.normals.empty() && !normal_gaps(mesh).is_all; }

/// @param before  the mesh that `after` came from
SmoothedMesh describe(const Mesh& before, const Mesh& after, bool changed, bool is_repair) {
    SmoothedMesh m;
    m.name = before.name;
    m.vertices = before.positions.size();
    if (!changed) {  // what the file has stays, and it is what was computed
        m.normals = before.normals.empty() ? Change::none : Change::kept;
        m.tangents = before.tangents.empty() ? Change::none : Change::kept;
        return m;
    }
    m.vertices_split = after.positions.size() - before.positions.size();
    if (is_repair) {
        m.normals = has_normals(before) ? change_of(before.normals, after.normals) : Change::made;
        m.tangents = change_of(before.tangents, after.tangents);
        return m;
    }
    m.normals = change_of(has_normals(before), !after.normals.empty(), true);
    m.tangents = change_of(!before.tangents.empty(), !after.tangents.empty(), true);
    return m;
}

/// [meshes of `after`] the mesh of `before`, by the nodes that show them.
std::vector<std::uint32_t> shown_before(const Scene& before, const Scene& after) {
    std::vector<std::uint32_t> origin(after.meshes.size(), no_index);
    for (std::size_t n = 0; n < after.nodes.size(); ++n)
        for (std::size_t slot = 0; slot < after.nodes[n].meshes.size(); ++slot)
            origin[after.nodes[n].meshes[slot]] = before.nodes[n].meshes[slot];
    return origin;
}

void describe_all(const Scene& before, const Scene& after, SmoothedFile& result) {
    const std::vector<std::uint32_t> origin = shown_before(before, after);
    for (std::size_t i = 0; i < origin.size(); ++i)
        if (origin[i] != no_index)
            result.meshes.push_back(
                describe(before.meshes[origin[i]], after.meshes[i], result.changed, result.seams.has_value()));
}

void save_as_gltf(const Scene& before, const Scene& after, const SmoothFileOptions& options, SmoothedFile& result,
                  Context& context) {
    const io::GltfSaveOptions save{
        {.allow_outside = options.load.allow_outside}, options.keep_instances, options.keep_unused};
    const io::GltfSaveResult done = io::save_gltf(result.file, before, after, result.output, save, context);
    result.changed = done.changed;
    result.meshes_added = done.meshes_added;
    const std::vector<std::uint32_t> origin = shown_before(before, after);
    for (const io::SavedPrimitive& p : done.primitives) {
        if (origin[p.scene_mesh] == no_index) continue;
        SmoothedMesh m = describe(before.meshes[origin[p.scene_mesh]], after.meshes[p.scene_mesh], p.changed,
                                  result.seams.has_value());
        m.mesh = p.mesh;
        m.primitive = p.primitive;
        result.meshes.push_back(std::move(m));
    }
}

/// A PLY file has these normals at every corner; how its vertices are numbered does not count.
bool has_these_normals(const Scene& before, const Scene& after) {
    const auto same = [](const Mesh& a, const Mesh& b) {
        if (a.topology != Topology::triangles) return true;
        if (a.indices.size() != b.indices.size() || (a.normals.empty() && !a.indices.empty())) return false;
        for (std::size_t c = 0; c < a.indices.size(); ++c)
            if (!io::is_near(a.normals[a.indices[c]], b.normals[b.indices[c]])) return false;
        return true;
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

}  // namespace

std::vector<SmoothedFile> smooth_files(std::span<const FileToSmooth> files, const SmoothFileOptions& options,
                                       Context& context) {
    if (files.empty()) return {};
    const std::vector<ModelRewrite> models = begin_all(files, options, context);
    SmoothFileOptions smoothing = options;
    choose_weld_distance(models, smoothing.attributes);
    context.progress("smooth", 0);
    const MergedScene whole = merged(models, context);
    const auto [after, seams, borders] = smooth_for_file(whole.scene, smoothing, context);
    std::vector<SmoothedFile> results;
    io::HeldOutputs outputs;
    for (std::size_t i = 0; i < models.size(); ++i) {
        const ModelRewrite& model = models[i];
        SmoothedFile& result = results.emplace_back();
        result.file = model.input, result.output = model.output;
        result.seams = seams, result.borders = borders;
        finish_rewrite(
            model,
            models.size() == 1 ? after : part_of(after, model.before, whole.offsets[i], whole.scene.meshes.size()),
            options, result, context);
    }
    outputs.commit();
    return results;
}

SmoothedFile smooth_file(const std::string& input, const std::string& output, const SmoothFileOptions& options,
                         Context& context) {
    const FileToSmooth file{input, output};
    return smooth_files({&file, 1}, options, context).front();
}

}  // namespace rakelight
