// SPDX-License-Identifier: Apache-2.0
// Scope model: every placement goes in at its place in the world. Scopes face and object do not look beyond the object,
// so a placement that only moves, turns, mirrors or scales evenly has the results of the first one of its kind: it is
// computed once, about its own origin, and instances stay shared to the bit. Under an uneven scale angles differ:
// computed apart.
#include "prepare/smooth_selection.h"

#include <cmath>

#include "math/linear.h"

namespace rakelight {
namespace {

/// For scope object: the first earlier node that lists the same meshes evenly placed too, or the node itself.
std::vector<std::uint32_t> alike_nodes(const Scene& scene, const std::vector<bool>& even) {
    std::vector<std::uint32_t> alike(scene.nodes.size());
    // Candidates by their first mesh: nodes that list the same meshes share it.
    std::vector<std::vector<std::uint32_t>> seen(scene.meshes.size());
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        alike[i] = i;
        const auto& meshes = scene.nodes[i].meshes;
        if (meshes.empty() || !even[i]) continue;
        auto& candidates = seen[meshes[0]];
        for (const std::uint32_t c : candidates)
            if (scene.nodes[c].meshes == meshes) alike[i] = c;
        if (alike[i] == i && candidates.size() < 64) candidates.push_back(i);
    }
    return alike;
}

}  // namespace

bool is_similarity(const dmat4& m) {
    const dvec3 a = m[0].xyz(), b = m[1].xyz(), c = m[2].xyz();
    const double size = dot(a, a), slack = 1e-9 * size;
    return size > 0 && std::fabs(dot(b, b) - size) <= slack && std::fabs(dot(c, c) - size) <= slack &&
           std::fabs(dot(a, b)) <= slack && std::fabs(dot(b, c)) <= slack && std::fabs(dot(c, a)) <= slack;
}

SmoothSelection select_instances(const Scene& scene, const SmoothRequest& request, const std::vector<dmat4>& world) {
    SmoothSelection s;
    for (const Instance& instance : drawn_instances(scene))
        if (scene.meshes[instance.mesh].normals.empty() ? request.attributes.normals : !request.only_missing)
            s.instances.push_back(instance);
    const Scope scope = request.attributes.scope;
    std::vector<bool> even(scene.nodes.size(), false);
    if (scope != Scope::model)
        for (std::size_t i = 0; i < even.size(); ++i) even[i] = scope == Scope::face || is_similarity(world[i]);
    const auto alike = scope == Scope::object ? alike_nodes(scene, even) : std::vector<std::uint32_t>{};
    // Where results can be shared: by mesh (face) or by leading node and slot (object).
    std::vector<std::size_t> by_mesh(scene.meshes.size(), none);
    std::vector<std::vector<std::size_t>> by_slot(scope == Scope::object ? scene.nodes.size() : 0);
    for (std::size_t i = 0; i < s.instances.size(); ++i) {
        const Instance& instance = s.instances[i];
        std::size_t* shared = nullptr;
        if (scope == Scope::face) shared = &by_mesh[instance.mesh];
        if (scope == Scope::object) {
            auto& slots = by_slot[alike[instance.node]];
            slots.resize(scene.nodes[instance.node].meshes.size(), none);
            shared = &slots[instance.slot];
        }
        if (!shared || *shared == none) {
            if (shared) *shared = s.computed.size();
            s.result_of.push_back(s.computed.size());
            s.computed.push_back(i);
            s.in_world.push_back(!even[instance.node]);
        } else {
            s.result_of.push_back(*shared);
        }
    }
    return s;
}

}  // namespace rakelight
