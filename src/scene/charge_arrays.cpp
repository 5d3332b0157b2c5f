// SPDX-License-Identifier: Apache-2.0
#include "scene/charge_arrays.h"

#include <algorithm>

namespace rakelight {
namespace {

/// [bytes] approximate size of an allocation with the allocator's overhead.
std::uint64_t allocated(std::uint64_t bytes) { return bytes == 0 ? 0 : std::max<std::uint64_t>(32, bytes + 16); }

template <class T>
std::uint64_t array_bytes(const std::vector<T>& array) {
    return allocated(array.size() * sizeof(T));
}

/// Short strings are stored inline.
std::uint64_t name_bytes(const std::string& name) {
    static const std::size_t short_size = std::string().capacity();
    return name.size() <= short_size ? 0 : allocated(name.size() + 1);
}

template <class T>
std::uint64_t block_bytes(const Block<T>& block) {
    return block.size() * sizeof(T);
}
std::uint64_t block_bytes(const Block<MorphTarget>& targets) { return table_bytes(targets.span()); }

/// Calls `visit` for each array of the mesh without a memory charge. A table of targets that was visited before, as
/// `visit` says, is not entered: many meshes share it.
template <class Visit>
void for_each_unpaid(const Mesh& m, const Visit& visit) {
    const auto look = [&](const auto& block) {
        if (!block.is_charged()) visit(block);
    };
    look(m.positions), look(m.indices), look(m.normals), look(m.tangents), look(m.bitangents), look(m.colors);
    look(m.smoothing), look(m.smoothing_hint), look(m.polygons), look(m.influences);
    look(m.more_influences);
    for (const Block<vec2>& set : m.texcoords) look(set);
    for (const VertexArray& a : m.arrays) look(a.values);
    if (!m.targets.is_charged() && visit(m.targets))
        for (const MorphTarget& t : m.targets) look(t.positions), look(t.normals), look(t.tangents);
}

void charge_new_arrays(const Mesh& made, const std::set<const void*>& own, Context& context) {
    for_each_unpaid(made, [&](const auto& block) {
        if (own.contains(block.identity())) return false;
        const std::uint64_t bytes = block_bytes(block) + bytes_beside_array;
        block.attach_charge(MemoryCharge(context.memory(), bytes, "the prepared scene"));
        return true;
    });
}

void collect_unpaid(const Mesh& mesh, std::set<const void*>& arrays) {
    for_each_unpaid(mesh, [&](const auto& block) { return arrays.insert(block.identity()).second; });
}

}  // namespace

std::set<const void*> unpaid_arrays(const Scene& scene) {
    std::set<const void*> arrays;
    for (const Mesh& mesh : scene.meshes) collect_unpaid(mesh, arrays);
    return arrays;
}

void charge_new_arrays(const Scene& made, const std::set<const void*>& own, Context& context) {
    for (const Mesh& mesh : made.meshes) charge_new_arrays(mesh, own, context);
}

void charge_new_arrays(const Mesh& made, const Mesh& source, Context& context) {
    std::set<const void*> own;
    collect_unpaid(source, own);
    charge_new_arrays(made, own, context);
}

std::uint64_t table_bytes(const Node& node) {
    return sizeof(Node) + name_bytes(node.name) + array_bytes(node.meshes) +
           (node.local.matrix ? allocated(sizeof(dmat4)) : 0);
}

std::uint64_t table_bytes(const Mesh& mesh) {
    return sizeof(Mesh) + name_bytes(mesh.name) + array_bytes(mesh.texcoords);
}

std::uint64_t table_bytes(std::span<const MorphTarget> targets) {
    std::uint64_t bytes = targets.size() * sizeof(MorphTarget);
    for (const MorphTarget& target : targets) bytes += name_bytes(target.name);
    return bytes;
}

std::uint64_t table_bytes(const Scene& scene) {
    std::uint64_t bytes = 0;
    for (const Node& node : scene.nodes) bytes += table_bytes(node);
    for (const Mesh& mesh : scene.meshes) bytes += table_bytes(mesh);
    for (const Material& m : scene.materials) bytes += sizeof m + name_bytes(m.name);
    for (const Texture& t : scene.textures) bytes += sizeof t + name_bytes(t.name);
    for (const Light& light : scene.lights) bytes += sizeof light + name_bytes(light.name);
    for (const Camera& camera : scene.cameras) bytes += sizeof camera + name_bytes(camera.name);
    for (const Skin& skin : scene.skins) bytes += sizeof skin + name_bytes(skin.name) + array_bytes(skin.joints);
    for (const Animation& a : scene.animations) bytes += sizeof a + name_bytes(a.name) + array_bytes(a.channels);
    return bytes;
}

Scene charged_copy(const Scene& scene, Context& context) {
    SharedCharge charge = share(MemoryCharge(context.memory(), table_bytes(scene), "a copy of the scene"));
    Scene copy = scene;
    copy.charges.push_back(std::move(charge));
    return copy;
}

std::uint32_t AddedMeshes::add(Mesh mesh) {
    if (!charge_) {
        charge_ = std::make_shared<MemoryCharge>(context_.memory());
        scene_.charges.push_back(charge_);
    }
    if (scene_.meshes.size() == scene_.meshes.capacity()) make_room();
    charge_->grow(table_bytes(mesh) - sizeof(Mesh), "the table of meshes");
    scene_.meshes.push_back(std::move(mesh));
    return std::uint32_t(scene_.meshes.size() - 1);
}

void AddedMeshes::make_room() {
    const std::size_t room = std::max<std::size_t>(16, 2 * scene_.meshes.size());
    charge_->grow(room * sizeof(Mesh), "the table of meshes");
    scene_.meshes.reserve(room);
    charge_->shrink(room_bytes_ + first_ * sizeof(Mesh));  // the previous table
    room_bytes_ = (room - first_) * sizeof(Mesh);
}

}  // namespace rakelight
