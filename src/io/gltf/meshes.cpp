// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/meshes.h"

#include <algorithm>

#include "base/format_text.h"
#include "io/gltf/influences.h"
#include "io/gltf/plausibility.h"
#include "io/gltf/topology.h"
#include "scene/charge_arrays.h"

namespace rakelight::io::gltf {
namespace {

constexpr std::uint32_t max_texcoord_sets = 8;
/// Bytes that later stages (normals, tangents, engines) need per vertex or corner. Charged for every mesh, so that
/// many primitives over one large array cannot exceed the budget.
constexpr std::uint64_t later_bytes_per_vertex = 48, later_bytes_per_corner = 8;

PrimitiveMode mode_of(const Value& primitive) {
    const std::uint64_t mode = primitive.count("mode", 4);
    if (mode > 6) primitive.fail(format_text("mode {} is unknown", mode));
    return PrimitiveMode(mode);
}

void check_targets_alike(const std::vector<Mesh>& meshes, const LoadedMesh& loaded, const Value& mesh) {
    for (const std::uint32_t m : loaded.meshes)
        if (meshes[m].targets.size() != meshes[loaded.meshes[0]].targets.size())
            mesh.fail("its primitives have different numbers of morph targets");
}

}  // namespace

const LoadedMesh& Meshes::load(std::uint32_t index, const Value& from) {
    if (const auto known = loaded_.find(index); known != loaded_.end()) return known->second;
    document().context().throw_if_cancelled();
    const Value mesh = document().element(mesh_kind, index, from);
    const Value primitives = mesh.list("primitives");
    LoadedMesh loaded;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
        const Value primitive = primitives.element(p, format_text("{}, primitive {}", mesh.place(), p));
        Mesh result;
        result.name = Document::name_of(mesh, mesh_kind, index);
        document().scene_charge().grow(sizeof(Mesh) + result.name.size(), "meshes");  // each has its own copy
        result.source_mesh = index;
        result.source_primitive = std::uint32_t(p);
        read_primitive(mesh, primitive, result);
        if (result.indices.empty()) continue;
        loaded.joints_used = std::max(loaded.joints_used, joints_used(result));
        loaded.meshes.push_back(std::uint32_t(scene_.meshes.size()));
        scene_.meshes.push_back(std::move(result));
    }
    check_targets_alike(scene_.meshes, loaded, mesh);
    const std::size_t targets = loaded.meshes.empty() ? 0 : scene_.meshes[loaded.meshes[0]].targets.size();
    std::vector<float> weights = mesh.reals("weights");
    if (weights.size() != targets && !weights.empty())
        document().remark(Remark::dropped, mesh.place(),
                          "its number of morph weights is not that of its targets; they are taken as 0");
    if (weights.size() != targets) weights.assign(targets, 0.0f);
    MemoryCharge charge(document().context().memory(), targets * sizeof(float), "morph weights");
    loaded.default_weights = {std::move(weights), std::move(charge)};
    return loaded_.emplace(index, std::move(loaded)).first->second;
}

void Meshes::read_primitive(const Value& mesh, const Value& primitive, Mesh& result) {
    const PrimitiveMode mode = mode_of(primitive);
    result.topology = topology_of(mode);
    result.material = materials_.load(primitive.index("material"), primitive);
    if (!primitive.object("attributes").has("POSITION")) {
        document().remark(Remark::dropped, primitive.place(), "a primitive without POSITION is left out");
        return;
    }
    // 1. vertices
    VertexData vertices(accessors_, cache_, primitive);
    result.positions = vertices.vec3s("POSITION");
    if (result.positions.empty()) {
        document().remark(Remark::dropped, primitive.place(), "a primitive without vertices is left out");
        return;
    }
    result.position_step = vertices.position_step();
    result.normals = vertices.vec3s("NORMAL");
    result.tangents = vertices.tangents();
    result.colors = vertices.colors();
    read_texcoords(vertices, primitive, result);
    Influences influences = read_influences(vertices, document(), primitive);
    result.influences = std::move(influences.first), result.more_influences = std::move(influences.next);
    read_targets(vertices, mesh, primitive, result);

    // 2. indices
    MemoryBudget& memory = document().context().memory();
    MemoryCharge corners_charge(memory);
    std::vector<std::uint32_t> corners = vertices.corners(corners_charge);
    MemoryCharge charge(memory, expanded_size(mode, corners.size()) * sizeof(std::uint32_t), "indices");
    document().scene_charge().grow(
        expanded_size(mode, corners.size()) * later_bytes_per_corner + vertices.vertex_count() * later_bytes_per_vertex,
        "vertex data");
    Expanded expanded = expand(mode, std::move(corners));
    if (expanded.left_over)
        document().remark(Remark::dropped, primitive.place(),
                          std::to_string(expanded.left_over) + " indices are too few for one more primitive");
    result.indices = {std::move(expanded.indices), std::move(charge)};
    if (result.indices.empty())
        document().remark(Remark::dropped, primitive.place(), "a primitive without corners is left out");

    // 3. remarks
    remark_on_quantization(document(), accessors_, primitive);
}

void Meshes::read_texcoords(VertexData& vertices, const Value& primitive, Mesh& result) {
    for (const std::string& name : primitive.object("attributes").names()) {
        const bool known = name == "POSITION" || name == "NORMAL" || name == "TANGENT" || name == "COLOR_0" ||
                           name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
        if (known) continue;
        std::uint32_t set = max_texcoord_sets;
        if (name.size() == 10 && name.starts_with("TEXCOORD_") && name[9] >= '0' && name[9] <= '9')
            set = std::uint32_t(name[9] - '0');
        if (name.starts_with('_')) {
            vertices.read_array(name, result);
            continue;
        }
        if (set >= max_texcoord_sets) {
            document().remark(Remark::note, primitive.place(),
                              "the vertex attribute " + one_line(name, 40) + " is not used");
            continue;
        }
        if (result.texcoords.size() <= set) result.texcoords.resize(set + 1);
        result.texcoords[set] = vertices.vec2s(name);
    }
    for (std::size_t set = 0; set < result.texcoords.size(); ++set) {
        if (!result.texcoords[set].empty()) continue;
        document().remark(Remark::guessed, primitive.place(),
                          format_text("TEXCOORD_{} is missing below a higher set; taken as 0", set));
        MemoryCharge charge(document().context().memory(), vertices.vertex_count() * sizeof(vec2), "vertex data");
        result.texcoords[set] = {std::vector<vec2>(std::size_t(vertices.vertex_count())), std::move(charge)};
    }
}

void Meshes::read_targets(VertexData& vertices, const Value& mesh, const Value& primitive, Mesh& result) {
    const Value targets = primitive.list("targets");
    const Value extras = mesh.has("extras") && targets ? mesh.part("extras") : Value();
    const Value names =
        extras.is_object() && extras.part("targetNames").is_list() ? extras.list("targetNames") : Value();
    std::vector<MorphTarget> read;
    for (std::size_t t = 0; t < targets.size(); ++t) {
        const Value target = targets.element(t, format_text("{}, target {}", primitive.place(), t));
        MorphTarget morph;
        morph.name = t < names.size() && names.is_text_at(t) ? names.text_at(t) : "target " + std::to_string(t);
        morph.positions = vertices.offsets(target, "POSITION");
        morph.normals = vertices.offsets(target, "NORMAL");
        morph.tangents = vertices.offsets(target, "TANGENT");
        for (const std::string& name : target.names())
            if (name != "POSITION" && name != "NORMAL" && name != "TANGENT")
                document().remark(Remark::dropped, target.place(),
                                  "morph targets of " + one_line(name, 40) + " are not supported");
        read.push_back(std::move(morph));
    }
    MemoryCharge charge(document().context().memory(), table_bytes(read), "morph targets");
    result.targets = {std::move(read), std::move(charge)};
}

}  // namespace rakelight::io::gltf
