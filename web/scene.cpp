// SPDX-License-Identifier: Apache-2.0
// smoothSeams() of a document for JavaScript (npm/scene.js): its nodes and arrays are copied in, the program's own smoothing runs over
// them, and what changes is copied out, by meshes and primitives of the document.
#include <map>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include <emscripten.h>

#include <rakelight/base/report.h>

#include "base/format_text.h"
#include "io/gltf/write/save_changes.h"
#include "scene_input.h"
#include "tools/smooth/smooth_file_scene.h"

using namespace rakelight;
using namespace rakelight::web;
using io::gltf::Direction;

namespace {

using Numbers = std::vector<std::uint32_t>;
using Bytes = std::vector<std::byte>;

/// A mesh of the scene after, as JavaScript takes it.
struct ChangedMesh {
    Numbers
        head;  ///< primitive, changed; if so: types of normals, tangents, bitangents; with new corners; tangents removed
    Numbers copied, corners;
    std::vector<Bytes> directions{3};
    std::vector<std::array<Bytes, 2>> targets;  ///< offsets of normals and tangents, floats
};

struct Work {
    DocumentInput input;
    std::string error;
    std::vector<std::string> remarks;
    std::array<double, 12> report{};
    double made = 0;  ///< normals of primitives that had none
    std::vector<io::gltf::MeshVersion> versions;
    std::map<std::uint32_t, ChangedMesh> meshes;  ///< by scene mesh
};

Work& work() {
    static Work all;
    return all;
}

std::uint32_t index_of(double number) { return number < 0 ? no_index : std::uint32_t(number); }

template <class T>
Bytes bytes_of(const Block<T>& block, io::gltf::ComponentType type) {
    if (block.empty()) return {};
    constexpr std::uint32_t width = sizeof(T) / sizeof(float);
    return io::gltf::stored_bytes({&block[0].x, width * block.size()}, width, type, width * io::gltf::size_of(type));
}

ChangedMesh changed_mesh(const Mesh& mesh, const io::gltf::PrimitiveChange& change) {
    ChangedMesh out;
    const auto type = [&](Direction direction) { return std::uint32_t(change.types[direction]); };
    out.head = {mesh.source_primitive,      1,
                type(Direction::normal),    type(Direction::tangent),
                type(Direction::bitangent), change.corners,
                change.tangents_removed};
    out.copied = change.copied;
    if (change.corners) out.corners.assign(mesh.indices.begin(), mesh.indices.end());
    out.directions = {bytes_of(mesh.normals, change.types[Direction::normal]),
                      bytes_of(mesh.tangents, change.types[Direction::tangent]),
                      bytes_of(mesh.bitangents, change.types[Direction::bitangent])};
    for (const MorphTarget& target : change.targets)
        out.targets.push_back({bytes_of(target.normals, io::gltf::ComponentType::f32),
                               bytes_of(target.tangents, io::gltf::ComponentType::f32)});
    return out;
}

void take_changes(const InputScene& before, const Scene& after, bool keep_instances, Context& context) {
    const io::gltf::DirectionStorage storage(before.scene, before.stored);
    io::gltf::SceneChanges changes = io::gltf::find_changes(before.scene, after, storage, keep_instances, context);
    if (!changes.any) return;
    for (const io::gltf::MeshVersion& version : changes.versions)
        for (const std::uint32_t m : version.meshes) {
            const Mesh& mesh = after.meshes[m];
            if (work().meshes.contains(m)) continue;
            if (!changes.changed[m]) {
                work().meshes[m].head = {mesh.source_primitive, 0};
                continue;
            }
            const std::uint32_t was = changes.origin[m];
            const io::gltf::PrimitiveChange change = io::gltf::change_of(was, before.scene.meshes[was], mesh, storage);
            io::gltf::report_change(change, {}, place_of(mesh.name, mesh.source_primitive), context.report());
            if (before.scene.meshes[was].normals.empty())
                work().made += double(before.scene.meshes[was].positions.size());
            work().meshes[m] = changed_mesh(mesh, change);
        }
    work().versions = std::move(changes.versions);
}

void take_report(const SmoothedScene& after, Context& context) {
    const SeamReport seams = after.seams.value_or(SeamReport{});
    const MatchReport borders = after.borders.value_or(MatchReport{});
    work().report = {double(seams.normals),
                     double(seams.turned),
                     seams.max_deg,
                     seams.mean_deg,
                     double(seams.flat_pairs),
                     double(seams.crease_pairs),
                     double(seams.unusable),
                     after.seams ? double(after.missing_made) : work().made,
                     double(borders.turned),
                     borders.max_deg,
                     borders.mean_deg,
                     double(after.seams.has_value())};
    for (const ReportEntry& entry : context.report().entries())
        work().remarks.push_back(std::string(name_of(entry.remark)) + "\n" + std::to_string(entry.count) + "\n" +
                                 entry.place + "\n" + entry.message);
}

/// Room for what is copied in, or null: there is no memory.
template <class Make>
auto room(Make make) -> decltype(make()) {
    try {
        return make();
    } catch (const std::exception&) {
        return nullptr;
    }
}

struct Result {
    const void* data = nullptr;
    std::size_t bytes = 0;
};

Result of(const Numbers& numbers) { return {numbers.data(), numbers.size() * sizeof(std::uint32_t)}; }
Result of(const Bytes& bytes) { return {bytes.data(), bytes.size()}; }

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* rl_error() { return work().error.c_str(); }
EMSCRIPTEN_KEEPALIVE void rl_clear() { work() = {}; }

/// The next array. @returns where its elements go, each behind the other
EMSCRIPTEN_KEEPALIVE void* rl_array(int type, int components, int is_normalized, double count) {
    return room([&] {
        ArrayInput& array = work().input.arrays.emplace_back();
        array.type = io::gltf::ComponentType(type);
        array.components = std::uint32_t(components);
        array.is_normalized = is_normalized != 0;
        array.count = std::uint64_t(count);
        array.bytes.resize(std::size_t(count) * std::size_t(components) * io::gltf::size_of(array.type) + 1);
        return static_cast<void*>(array.bytes.data());
    });
}

EMSCRIPTEN_KEEPALIVE void rl_material(double anisotropy) {
    work().input.materials.emplace_back().metallic_roughness.anisotropy = float(anisotropy);
}

/// A texture of the last material to which tangents belong: 0 normals, 1 normals of the clearcoat, 2 anisotropy.
EMSCRIPTEN_KEEPALIVE void rl_texture(int what, int set, double u, double v, double scale_u, double scale_v,
                                     double rotation_rad) {
    Material& material = work().input.materials.back();
    TextureUse& use = what == 0   ? material.normal_texture
                      : what == 1 ? material.metallic_roughness.clearcoat_normal_texture
                                  : material.metallic_roughness.anisotropy_texture;
    use = {.texture = 0,
           .texcoord_set = std::uint32_t(set),
           .transform = {{float(u), float(v)}, {float(scale_u), float(scale_v)}, float(rotation_rad)}};
}

/// The next primitive. @returns where the name of its mesh goes, for messages: `length` bytes of UTF-8
EMSCRIPTEN_KEEPALIVE char* rl_primitive(int mesh, int primitive, int mode, double material, int length) {
    return room([&] {
        PrimitiveInput& next = work().input.primitives.emplace_back();
        next.mesh = std::uint32_t(mesh), next.primitive = std::uint32_t(primitive);
        next.mode = std::uint32_t(mode);
        next.material = index_of(material);
        next.name.resize(std::size_t(length) + 1);
        next.name.pop_back();
        return next.name.data();
    });
}

/// The next morph target of the last primitive. @returns where its name goes: `length` bytes of UTF-8
EMSCRIPTEN_KEEPALIVE char* rl_target(int length) {
    return room([&] { return work().input.primitives.back().targets.emplace_back(std::size_t(length), ' ').data(); });
}

/// An array of the last primitive. @param semantic  as the enumerators of Semantic  @param target  < 0: of the primitive itself
EMSCRIPTEN_KEEPALIVE void rl_attribute(int semantic, int set, double target, int array) {
    work().input.primitives.back().attributes.push_back(
        {Semantic(semantic), std::uint32_t(set), index_of(target), std::uint32_t(array)});
}

/// The next skin. @returns where its matrices go, 16 numbers for each joint
EMSCRIPTEN_KEEPALIVE double* rl_skin(int joints) {
    return room([&] {
        SkinInput& skin = work().input.skins.emplace_back();
        skin.joints.resize(std::size_t(joints) + 1);
        skin.joints.pop_back();
        skin.inverse_bind.resize(16 * skin.joints.size() + 1);
        return skin.inverse_bind.data();
    });
}
EMSCRIPTEN_KEEPALIVE std::uint32_t* rl_joints() { return work().input.skins.back().joints.data(); }

/// The next node. @returns where its 10 (translation, rotation, scale) or 16 numbers go
EMSCRIPTEN_KEEPALIVE double* rl_node(double parent, int source_node, double mesh, double skin, int is_matrix) {
    return room([&] {
        NodeInput& node = work().input.nodes.emplace_back();
        node = {index_of(parent), std::uint32_t(source_node), index_of(mesh), index_of(skin), is_matrix != 0};
        return node.place.data();
    });
}

/// @param replaced  1: all normals are new  @param tangents  as the enumerators of TangentChoice
/// @returns 0, or 1 with the text of the error
EMSCRIPTEN_KEEPALIVE int rl_smooth(int replaced, int scope, int weight, int creases, double crease_angle_rad,
                                   double weld_distance, double border_distance, int tangents, int tangent_mode,
                                   int bitangents, int keep_instances) {
    Context context({.threads = 1});
    try {
        SmoothFileOptions options;
        options.authored = replaced != 0 ? AuthoredNormals::replaced : AuthoredNormals::seams;
        options.attributes.scope = Scope(scope);
        options.attributes.weight = CornerWeight(weight);
        options.attributes.creases = Creasing(creases);
        options.attributes.crease_angle_rad = crease_angle_rad;
        options.attributes.weld_distance = weld_distance;
        options.attributes.tangent_mode = TangentMode(tangent_mode);
        options.border_distance = border_distance;
        options.tangents = TangentChoice(tangents);
        options.bitangents = bitangents != 0;
        options.keep_instances = keep_instances != 0;
        const InputScene before = make_scene(work().input, context);
        work().input = {};
        const SmoothedScene after = smooth_for_file(before.scene, options, context);
        take_changes(before, after.scene, options.keep_instances, context);
        take_report(after, context);
        return 0;
    } catch (const Error& error) {
        work().error = error.what();
    } catch (const std::exception&) {  // also of an array that is longer than a vector can be
        work().error = "not enough memory";
    }
    return 1;
}

/// Numbers of the report, see take_report().
EMSCRIPTEN_KEEPALIVE const double* rl_report() { return work().report.data(); }
EMSCRIPTEN_KEEPALIVE int rl_remark_count() { return int(work().remarks.size()); }
/// Kind, count, place and text, each on a line.
EMSCRIPTEN_KEEPALIVE const char* rl_remark(int number) { return work().remarks[std::size_t(number)].c_str(); }

EMSCRIPTEN_KEEPALIVE int rl_version_count() { return int(work().versions.size()); }
/// A mesh of the document as some nodes need it. @returns the mesh; whether it stays that mesh: 1, or else a copy
EMSCRIPTEN_KEEPALIVE int rl_version_mesh(int version) { return int(work().versions[std::size_t(version)].source_mesh); }
EMSCRIPTEN_KEEPALIVE int rl_version_is_in_place(int version) { return work().versions[std::size_t(version)].in_place; }
}

namespace {

/// 0 nodes and 1 meshes of a version; of a mesh: 2 head, 3 copied vertices, 4 corners, 5 to 7 directions, and of a target
/// 8 and 9 offsets.
Result result_of(int what, std::uint32_t number, std::size_t target) {
    if (what <= 1) {
        const io::gltf::MeshVersion& version = work().versions[number];
        return of(what == 0 ? version.nodes : version.meshes);
    }
    const ChangedMesh& mesh = work().meshes.at(number);
    switch (what) {
        case 2:
            return of(mesh.head);
        case 3:
            return of(mesh.copied);
        case 4:
            return of(mesh.corners);
        case 5:
        case 6:
        case 7:
            return of(mesh.directions[std::size_t(what - 5)]);
        default:
            return of(mesh.targets[target][std::size_t(what - 8)]);
    }
}

}  // namespace

extern "C" {
EMSCRIPTEN_KEEPALIVE const void* rl_result(int what, int number, int target) {
    return result_of(what, std::uint32_t(number), std::size_t(target)).data;
}
EMSCRIPTEN_KEEPALIVE int rl_target_count(int mesh) { return int(work().meshes.at(std::uint32_t(mesh)).targets.size()); }
EMSCRIPTEN_KEEPALIVE double rl_result_bytes(int what, int number, int target) {
    return double(result_of(what, std::uint32_t(number), std::size_t(target)).bytes);
}
}
