// SPDX-License-Identifier: Apache-2.0
#include "tools/smooth/model_rewrite.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <rakelight/io/world.h>
#include <rakelight/world/world_request.h>
#include <rakelight_internal/base/file_ending.h>

#include "io/files/beside.h"
#include "io/files/file.h"
#include "io/files/output_file.h"
#include "io/gltf/write/glb_writer.h"
#include "io/gltf/write/save_gltf.h"
#include "io/obj/write/rewrite_normals.h"
#include "io/obj/write/write_obj.h"
#include "io/ply/ply_writer.h"
#include "io/same_attributes.h"
#include "prepare/normals/missing_normals.h"
#include "world/placed_in_world.h"
#include "world/z_up.h"

namespace rakelight {
namespace {

using Change = SmoothedMesh::Change;

bool is_gltf(const std::string& ending) { return ending == "glb" || ending == "gltf"; }

Change change_of(bool had, bool has, bool changed) {
    if (!has) return had ? Change::removed : Change::none;
    return !had ? Change::made : changed ? Change::replaced : Change::kept;
}

/// Of arrays that stay except for what turns.
template <class T>
Change change_of(const Block<T>& before, const Block<T>& after) {
    if (before == after) return before.empty() ? Change::none : Change::kept;
    return before.empty() ? Change::made : after.empty() ? Change::removed : Change::turned;
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

void save_as_gltf(const ModelRewrite& model, const Scene& after, const SmoothFileOptions& options, SmoothedFile& result,
                  Context& context) {
    const Scene& before = model.before;
    const io::GltfSaveOptions save{
        {.allow_outside = model.load.allow_outside}, options.keep_instances, options.keep_unused};
    const io::GltfSaveResult done = io::save_gltf(model.input, before, after, model.output, save, context);
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
    return std::equal(before.meshes.begin(), before.meshes.end(), after.meshes.begin(), after.meshes.end(), same);
}

void refuse_folder(const std::string& output) {
    std::error_code error;
    if (output.ends_with('/') || std::filesystem::is_directory(output, error))
        throw Error(ErrorCode::usage, "'" + one_line(output, 80) + "' is a folder", {}, "add a file name");
}

/// A PLY file whose normals stay is copied.
bool write_ply(const ModelRewrite& model, const Scene& after, Context& context) {
    const bool is_changed = !has_these_normals(model.before, after) || file_ending(model.input) != "ply" ||
                            !is_one_file(model.input, model.load);
    if (is_changed)
        io::write_ply(after, model.output, context);
    else
        io::write_file(model.output, *io::read_file(model.input, context));
    return is_changed;
}

/// As the output has it: glTF has Y up, and most programs with Z up turn the OBJ files that they write. PLY files keep coordinates.
Scene turned_for_output(const ModelRewrite& model, const Scene& after, Report& report) {
    if (!model.has_z_up) return after;
    if (model.way != RewriteWay::new_ply) return with_y_up(after, model.output, report);
    warn_of_z_up(model.output, report);
    return after;
}

/// Z: by the format, or because [render] of a world file says so.
bool has_z_up(const ModelRewrite& model, Context& context) {
    const std::string& source = model.before.source;
    if (!is_world_file(source)) return is_z_up(source, model.load.joined);
    const RenderOverrides axis{.accepts = [](std::string_view key) { return key == "up"; }};
    const std::optional<dvec3> up = read_world_request(source, model.load, axis, context).picture.view.world_up;
    const bool is_z = up == dvec3{0, 0, 1};
    if (up && !is_z && *up != dvec3{0, 1, 0})
        context.report().add(Remark::warning, model.output, {},
                             "the model keeps its coordinates, but the world file has another axis up than Y", {"up"});
    return is_z;
}

}  // namespace

bool is_one_file(const std::string& input, const LoadOptions& load) {
    return load.joined.empty() &&
           std::ranges::find(load.memory_files, input, &MemoryFile::name) == load.memory_files.end();
}

RewriteWay way_of(const std::string& input, const std::string& output, const LoadOptions& load) {
    const std::string from = is_one_file(input, load) ? file_ending(input) : "", to = file_ending(output);
    if (is_gltf(from) && is_gltf(to)) return RewriteWay::gltf_in_place;
    if (from == "obj" && to == "obj") return RewriteWay::obj_in_place;
    if (is_gltf(to)) return RewriteWay::new_gltf;
    if (to == "obj") return RewriteWay::new_obj;
    if (to == "ply") return RewriteWay::new_ply;
    const std::string name = one_line(std::filesystem::path(output).filename().string(), 80);
    if (to == "stl")
        throw Error(ErrorCode::usage,
                    "cannot write '" + name + "': STL cannot store vertex normals, only one normal per triangle", {},
                    "write .glb or .ply");
    throw Error(ErrorCode::usage, "cannot write '" + name + "'", {}, "write .glb, .gltf, .obj or .ply");
}

ModelRewrite begin_rewrite(const std::string& input, const std::string& wanted, const LoadOptions& options,
                           Context& context) {
    refuse_folder(wanted);
    const std::string output = io::behind_links(wanted);  // data, materials and pictures go beside the file itself
    ModelRewrite model{input, output, way_of(input, output, options), options, {}};
    context.progress("load", 0);
    if (model.way == RewriteWay::obj_in_place)
        model.before =
            io::read_scene(input, {.allow_outside = options.allow_outside, .keep_obj = &model.kept}, context);
    else
        model.before = load(input, options, context);
    model.has_z_up = has_z_up(model, context);
    if (const auto lying = lying_file(input, options.joined)) warn_of_lying(*lying, {}, beside_y_up, context.report());
    if (model.way == RewriteWay::new_obj || model.way == RewriteWay::new_ply)
        model.before = placed_in_world(model.before, model.way == RewriteWay::new_obj, context);
    return model;
}

void finish_rewrite(const ModelRewrite& model, const Scene& after, const SmoothFileOptions& options,
                    SmoothedFile& result, Context& context) {
    context.throw_if_cancelled();
    context.progress("write", 0);
    const auto turned = [&] { return turned_for_output(model, after, context.report()); };
    std::shared_ptr<const io::KeptObj> kept = model.kept;
    result.changed = true;
    switch (model.way) {
        case RewriteWay::gltf_in_place:
            return save_as_gltf(model, after, options, result, context);
        case RewriteWay::obj_in_place:
            result.changed =
                io::rewrite_obj_normals(model.input, after, model.output,
                                        {.allow_outside = model.load.allow_outside, .keep_obj = &kept}, context);
            break;
        case RewriteWay::new_gltf:
            io::write_glb(turned(), model.output, context);
            break;
        case RewriteWay::new_obj:
            io::write_obj(turned(), model.output, context);
            break;
        case RewriteWay::new_ply:
            result.changed = write_ply(model, turned(), context);
            break;
    }
    describe_all(model.before, after, result);
}

}  // namespace rakelight
