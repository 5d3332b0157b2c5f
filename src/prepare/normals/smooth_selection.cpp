// SPDX-License-Identifier: Apache-2.0
// Scope model: every instance is an input in world space. Scopes face and object depend only on the object, so a
// placement that only moves, turns, mirrors or scales evenly has the results of the first one of its kind: it is
// computed once, about its own origin, and instances stay shared to the bit (so do copies of a mesh that share its
// arrays). Under non-uniform scale angles differ, so instances are computed separately.
#include "prepare/normals/smooth_selection.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "prepare/normals/missing_normals.h"
#include "prepare/normals/normal_rule.h"

#include "math/linear.h"

namespace rakelight {
namespace {

bool have_same_arrays(const Mesh& a, const Mesh& b) {
    return a.topology == b.topology && a.origin == b.origin && a.position_step == b.position_step &&
           a.positions == b.positions && a.indices == b.indices && a.normals == b.normals && a.tangents == b.tangents &&
           a.texcoords == b.texcoords && a.colors == b.colors && a.smoothing == b.smoothing &&
           a.smoothing_kind == b.smoothing_kind && a.smoothing_hint == b.smoothing_hint &&
           a.influences == b.influences && a.more_influences == b.more_influences && a.targets.empty() &&
           b.targets.empty();
}

/// [meshes] The first mesh with an equal result, or the mesh itself: a file used several times in a world gives several
/// meshes with the same arrays.
std::vector<std::uint32_t> first_alike(const Scene& scene, const SmoothRequest& request) {
    constexpr std::size_t searched = 64;
    std::vector<std::uint32_t> first(scene.meshes.size());
    std::map<const void*, std::vector<std::uint32_t>> seen;  // by the positions
    for (std::uint32_t m = 0; m < first.size(); ++m) {
        const Mesh& mesh = scene.meshes[m];
        first[m] = m;
        auto& candidates = seen[mesh.positions.identity()];
        for (const std::uint32_t c : candidates) {
            const Mesh& other = scene.meshes[c];
            const bool moves_alone = request.made && !mesh.influences.empty();  // see GeneratedAttributes
            if (first[m] == m && !moves_alone && have_same_arrays(mesh, other) &&
                mesh.normal_choice == other.normal_choice &&
                tangent_coordinates(scene, mesh, request.tangents) ==
                    tangent_coordinates(scene, other, request.tangents))
                first[m] = c;
        }
        if (first[m] == m && candidates.size() < searched) candidates.push_back(m);
    }
    return first;
}

/// For scope object: the first earlier node with the same meshes and a similarity transform, or the node itself.
/// @param first  [meshes] of first_alike()
std::vector<std::uint32_t> alike_nodes(const Scene& scene, const std::vector<std::uint32_t>& first,
                                       const std::vector<bool>& even) {
    std::vector<std::uint32_t> alike(scene.nodes.size());
    const auto lists_the_same = [&](const Node& a, const Node& b) {
        return std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(),
                          [&](std::uint32_t x, std::uint32_t y) { return first[x] == first[y]; });
    };
    // Candidates by their first mesh.
    std::vector<std::vector<std::uint32_t>> seen(scene.meshes.size());
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        alike[i] = i;
        const auto& meshes = scene.nodes[i].meshes;
        if (meshes.empty() || !even[i]) continue;
        auto& candidates = seen[first[meshes[0]]];
        for (const std::uint32_t c : candidates)
            if (lists_the_same(scene.nodes[c], scene.nodes[i])) alike[i] = c;
        if (alike[i] == i && candidates.size() < 64) candidates.push_back(i);
    }
    return alike;
}

/// Tangents for normals of the file are averaged over the model; gaps in them are closed over the model.
bool is_of_scope(const Scene& scene, const Mesh& mesh, const SmoothRequest& request) {
    if (!request.source || request.every_scope) return true;
    if (request.only_missing && !mesh.normals.empty()) return request.attributes.scope == Scope::model;
    const NormalRule rule = normal_rule(scene, mesh, *request.source);
    const bool is_kept = !request.attributes.normals && rule.keeps_given && rule.scope == Scope::face;
    return (is_kept ? Scope::model : rule.scope) == request.attributes.scope;
}

/// [meshes] Whether their normals are to be made, all or some of them.
std::vector<bool> wanting(const Scene& scene, const std::vector<Instance>& drawn, const SmoothRequest& request) {
    std::vector<bool> wants(scene.meshes.size(), false), seen(scene.meshes.size(), false);
    for (const Instance& instance : drawn) {
        if (seen[instance.mesh]) continue;
        seen[instance.mesh] = true;
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (!request.attributes.normals)
            wants[instance.mesh] = !mesh.normals.empty() && !request.only_missing;
        else
            wants[instance.mesh] = !request.only_missing || lacks_normals(mesh);
    }
    return wants;
}

/// The drawn instances whose normals are kept: over the model all of them, else those of nodes that have a computed one.
void add_beside(SmoothSelection& s, const Scene& scene, const std::vector<Instance>& drawn,
                const std::vector<bool>& wants, const SmoothRequest& request) {
    const Scope scope = request.attributes.scope;
    if (!request.only_missing || !request.attributes.normals || request.every_scope || scope == Scope::face) return;
    std::vector<char> place(scene.nodes.size(), scope == Scope::model ? 'w' : '-');  // of a node's computed ones
    for (std::size_t r = 0; r < s.computed.size(); ++r)
        place[s.instances[s.computed[r]].node] = s.in_world[r] ? 'w' : 'o';
    for (const Instance& instance : s.computed.empty() ? std::vector<Instance>{} : drawn) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (wants[instance.mesh] || mesh.normals.empty() || place[instance.node] == '-') continue;
        if (request.source && !normal_rule(scene, mesh, *request.source).keeps_given) continue;
        s.beside.push_back(instance);
        s.in_world.push_back(place[instance.node] == 'w');
    }
}

}  // namespace

std::vector<Instance> SmoothSelection::inputs() const {
    std::vector<Instance> all;
    all.reserve(computed.size() + beside.size());
    for (const std::size_t i : computed) all.push_back(instances[i]);
    all.insert(all.end(), beside.begin(), beside.end());
    return all;
}

bool is_similarity(const dmat4& m) {
    const dvec3 a = m[0].xyz(), b = m[1].xyz(), c = m[2].xyz();
    const double size = dot(a, a), slack = 1e-9 * size;
    return size > 0 && std::fabs(dot(b, b) - size) <= slack && std::fabs(dot(c, c) - size) <= slack &&
           std::fabs(dot(a, b)) <= slack && std::fabs(dot(b, c)) <= slack && std::fabs(dot(c, a)) <= slack;
}

SmoothSelection select_instances(const Scene& scene, const SmoothRequest& request, const std::vector<dmat4>& world) {
    SmoothSelection s;
    const std::vector<Instance> drawn = drawn_instances(scene);
    const std::vector<bool> wants = wanting(scene, drawn, request);
    for (const Instance& instance : drawn)
        if (wants[instance.mesh] && is_of_scope(scene, scene.meshes[instance.mesh], request))
            s.instances.push_back(instance);
    const Scope scope = request.attributes.scope;
    std::vector<bool> even(scene.nodes.size(), false);
    if (scope != Scope::model)
        for (std::size_t i = 0; i < even.size(); ++i) even[i] = scope == Scope::face || is_similarity(world[i]);
    const auto first = scope == Scope::model ? std::vector<std::uint32_t>{} : first_alike(scene, request);
    const auto alike = scope == Scope::object ? alike_nodes(scene, first, even) : std::vector<std::uint32_t>{};
    // Keys for sharing results: mesh (face), or leading node and slot (object).
    std::vector<std::size_t> by_mesh(scene.meshes.size(), no_index);
    std::vector<std::vector<std::size_t>> by_slot(scope == Scope::object ? scene.nodes.size() : 0);
    for (std::size_t i = 0; i < s.instances.size(); ++i) {
        const Instance& instance = s.instances[i];
        std::size_t* shared = nullptr;
        if (scope == Scope::face) shared = &by_mesh[first[instance.mesh]];
        if (scope == Scope::object) {
            auto& slots = by_slot[alike[instance.node]];
            slots.resize(scene.nodes[instance.node].meshes.size(), no_index);
            shared = &slots[instance.slot];
        }
        if (!shared || *shared == no_index) {
            if (shared) *shared = s.computed.size();
            s.result_of.push_back(s.computed.size());
            s.computed.push_back(i);
            s.in_world.push_back(!even[instance.node]);
        } else {
            s.result_of.push_back(*shared);
        }
    }
    add_beside(s, scene, drawn, wants, request);
    return s;
}

}  // namespace rakelight
