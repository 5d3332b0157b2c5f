// SPDX-License-Identifier: Apache-2.0
#include <rakelight/smooth_file.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "io/beside.h"
#include "io/file.h"
#include "io/glb_writer.h"
#include "io/gltf/save_gltf.h"
#include "io/obj/rewrite_normals.h"
#include "io/obj/write_obj.h"
#include "io/ply_writer.h"
#include "io/same_attributes.h"
#include "tools/smooth_file_scene.h"
#include "tools/smooth_file_world.h"

namespace rakelight {
namespace {

using Change = SmoothedMesh::Change;

enum class Way : std::uint8_t { gltf_in_place, obj_in_place, new_gltf, new_obj, new_ply };

std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return ending;
}

bool is_gltf(const std::string& ending) { return ending == ".glb" || ending == ".gltf"; }

Way way_of(const std::string& input, const std::string& output) {
    const std::string from = ending_of(input), to = ending_of(output);
    if (is_gltf(from) && is_gltf(to)) return Way::gltf_in_place;
    if (from == ".obj" && to == ".obj") return Way::obj_in_place;
    if (is_gltf(to)) return Way::new_gltf;
    if (to == ".obj") return Way::new_obj;
    if (to == ".ply") return Way::new_ply;
    const std::string name = one_line(std::filesystem::path(output).filename().string(), 80);
    if (to == ".stl")
        throw Error(ErrorCode::usage,
                    "cannot write '" + name + "': STL cannot store vertex normals, only one normal per triangle", {},
                    "write .glb or .ply");
    throw Error(ErrorCode::usage, "cannot write '" + name + "'", {}, "write .glb, .gltf, .obj or .ply");
}

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
        m.normals = change_of(before.normals, after.normals);
        m.tangents = change_of(before.tangents, after.tangents);
        return m;
    }
    m.normals = change_of(!before.normals.empty(), !after.normals.empty(), true);
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
    return std::equal(before.meshes.begin(), before.meshes.end(), after.meshes.begin(), after.meshes.end(), same);
}

}  // namespace

SmoothedFile smooth_file(const std::string& input, const std::string& wanted, const SmoothFileOptions& options,
                         Context& context) {
    std::error_code error;
    if (wanted.ends_with('/') || std::filesystem::is_directory(wanted, error))
        throw Error(ErrorCode::usage, "'" + one_line(wanted, 80) + "' is a folder", {}, "add a file name");
    const std::string output = io::behind_links(wanted);  // data, materials and pictures go beside the file itself
    const Way way = way_of(input, output);
    SmoothedFile result{.file = input, .output = output};
    SmoothFileOptions smoothing = options;
    std::shared_ptr<const io::KeptObj> kept;  // the OBJ file that is written back
    const io::ReadOptions reading{.allow_outside = options.load.allow_outside, .keep_obj = &kept};
    context.progress("load", 0);
    Scene before =
        way == Way::obj_in_place ? io::read_scene(input, reading, context) : load(input, options.load, context);
    if (way == Way::new_obj || way == Way::new_ply) {
        before = placed_in_world(before, way == Way::new_obj, context);
        if (options.attributes.weld_distance < 0) smoothing.attributes.weld_distance = world_rounding(before);
    }
    if (options.bitangents && way != Way::gltf_in_place && way != Way::new_gltf)
        throw Error(ErrorCode::usage, "only glTF can store separate bitangents", {}, "write .glb or .gltf");
    context.progress("smooth", 0);
    const auto [after, seams, borders] = smooth_for_file(before, smoothing, context);
    result.seams = seams, result.borders = borders;
    context.throw_if_cancelled();
    context.progress("write", 0);
    switch (way) {
        case Way::gltf_in_place:
            save_as_gltf(before, after, options, result, context);
            return result;
        case Way::obj_in_place:
            result.changed = io::rewrite_obj_normals(input, after, output, reading, context);
            break;
        case Way::new_gltf:
            io::write_glb(after, output, context);
            result.changed = true;
            break;
        case Way::new_obj:
            io::write_obj(after, output, context);
            result.changed = true;
            break;
        case Way::new_ply:
            result.changed = !has_these_normals(before, after) || ending_of(input) != ".ply";
            if (result.changed)
                io::write_ply(after, output, context);
            else
                io::write_file(output, *io::read_file(input, context));
            break;
    }
    describe_all(before, after, result);
    return result;
}

}  // namespace rakelight
