// SPDX-License-Identifier: Apache-2.0
#include "scene/charge_arrays.h"

namespace rakelight {
namespace {

/// Calls `visit` for each array of the meshes that no charge pays for.
template <class Visit>
void for_each_unpaid(const Scene& scene, const Visit& visit) {
    const auto look = [&](const auto& block) {
        if (!block.is_paid()) visit(block);
    };
    for (const Mesh& m : scene.meshes) {
        look(m.positions), look(m.indices), look(m.normals), look(m.tangents), look(m.colors);
        look(m.smoothing), look(m.smoothing_hint), look(m.polygons), look(m.influences);
        for (const Block<vec2>& set : m.texcoords) look(set);
        for (const MorphTarget& t : m.targets) look(t.positions), look(t.normals), look(t.tangents);
    }
}

}  // namespace

std::set<const void*> unpaid_arrays(const Scene& scene) {
    std::set<const void*> arrays;
    for_each_unpaid(scene, [&](const auto& block) { arrays.insert(block.identity()); });
    return arrays;
}

void charge_new_arrays(const Scene& made, const std::set<const void*>& own, Context& context) {
    for_each_unpaid(made, [&](const auto& block) {
        if (own.contains(block.identity())) return;
        block.pay(MemoryCharge(context.memory(), block.size() * sizeof(block[0]), "the prepared scene"));
    });
}

std::uint64_t table_bytes(const Scene& scene) {
    std::uint64_t bytes = scene.nodes.size() * sizeof(Node) + scene.meshes.size() * sizeof(Mesh);
    for (const Node& node : scene.nodes) bytes += node.meshes.size() * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace rakelight
