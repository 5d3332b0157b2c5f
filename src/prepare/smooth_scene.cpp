// SPDX-License-Identifier: Apache-2.0
// Normals and tangents of a scene by the door of <rakelight/attributes.h>: which placements go in, where the results go.
//
// Scope model: every placement goes in at its place in the world. Scopes face and object do not look beyond the object, so
// a placement that only moves, turns, mirrors or scales evenly has the results of the first one of its kind: it is computed
// once, about its own origin, and instances stay shared to the bit. Under an uneven scale angles differ: computed apart.
#include <cmath>
#include <string>

#include "math/linear.h"
#include "prepare/prepare.h"
#include "prepare/smooth_request.h"
#include "prepare/split_vertices.h"
#include "prepare/variants.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

/// Moves, turns, mirrors and scales evenly (to nine digits).
bool is_similarity(const dmat4& m) {
    const dvec3 a = m[0].xyz(), b = m[1].xyz(), c = m[2].xyz();
    const double size = dot(a, a), slack = 1e-9 * size;
    return size > 0 && std::fabs(dot(b, b) - size) <= slack && std::fabs(dot(c, c) - size) <= slack && std::fabs(dot(a, b)) <= slack &&
           std::fabs(dot(b, c)) <= slack && std::fabs(dot(c, a)) <= slack;
}

/// The placements that are computed, and for each placement which of them has its result.
struct Selection {
    std::vector<Instance> instances;
    std::vector<std::size_t> result_of;   ///< [instances] into `computed`
    std::vector<std::size_t> computed;    ///< into `instances`
    std::vector<bool> in_world;           ///< [computed] at its place in the world, else about its own origin
};

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

Selection select(const Scene& scene, const SmoothRequest& request, const std::vector<dmat4>& world) {
    Selection s;
    for (const Instance& instance : drawn_instances(scene))
        if (scene.meshes[instance.mesh].normals.empty() ? request.attributes.normals : !request.only_missing) s.instances.push_back(instance);
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

AttributeMesh attribute_mesh(const Scene& scene, const Instance& instance, const dmat4& place, const SmoothRequest& request) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    AttributeMesh out;
    out.object = instance.node;
    out.positions = mesh.positions;
    out.indices = mesh.indices;
    const std::uint32_t set = tangent_set(scene, mesh, request.tangents);
    if (set != none) out.texcoords = mesh.texcoords[set];
    if (!request.attributes.normals) out.normals = mesh.normals;
    if (request.groups && request.attributes.normals) {
        out.smoothing = mesh.smoothing;
        if (!mesh.smoothing.empty())
            out.group_kind = mesh.smoothing_kind == SmoothingKind::masks ? GroupKind::masks : GroupKind::numbers;
        out.smoothing_hint = mesh.smoothing_hint;
    }
    out.to_world = place * translation(mesh.origin);
    out.position_step = mesh.position_step;
    return out;
}

/// Results are vectors of our own making, but a file decides how many placements there are.
void check_memory(const std::vector<AttributeMesh>& meshes, Context& context) {
    std::uint64_t bytes = 0;
    for (const AttributeMesh& m : meshes)
        bytes += m.positions.size() * (sizeof(vec3) + (m.texcoords.empty() ? 0 : sizeof(vec4))) + m.indices.size() * sizeof(std::uint32_t);
    context.memory().check(bytes, "normals and tangents of all instances");
}

Mesh with_attributes(const Mesh& source, MeshAttributes&& attributes, bool new_normals, Context& context) {
    Mesh mesh = source;
    mesh.tangents = {};
    if (new_normals) mesh.normals = {};
    split_vertices(mesh, std::move(attributes.indices), attributes.source_vertex, context);
    if (new_normals) mesh.normals = std::move(attributes.normals);
    mesh.tangents = std::move(attributes.tangents);
    return mesh;
}

// Offsets from the old normals and tangents say nothing about the new ones. Positions of targets stay.
void refuse_target_directions(const Scene& scene, Mesh& mesh, std::uint32_t number, bool new_normals, Report& report) {
    bool refused = false;
    for (MorphTarget& target : mesh.targets) {
        refused = refused || (new_normals && !target.normals.empty()) || !target.tangents.empty();
        if (new_normals) target.normals = {};
        target.tangents = {};
    }
    if (refused)
        report.add(Remark::dropped, scene.source, "mesh " + std::to_string(number) + " '" + mesh.name + "'",
                   "normals and tangents of morph targets do not fit the new ones and are left out");
}

AttributeOptions options_for(const SmoothRequest& request, const std::vector<AttributeMesh>& meshes) {
    AttributeOptions options = request.attributes;
    options.tangents = false;
    for (const AttributeMesh& m : meshes) options.tangents = options.tangents || !m.texcoords.empty();
    return options;
}

void report_faults(const Scene& scene, const Selection& s, const std::vector<MeshAttributes>& results, Report& report) {
    for (std::size_t r = 0; r < results.size(); ++r) {
        const std::uint32_t number = s.instances[s.computed[r]].mesh;
        const Mesh& mesh = scene.meshes[number];
        // That all of them are degenerate is a warning of prepare's own check.
        if (results[r].degenerate_faces > 0 && results[r].degenerate_faces < mesh.triangle_count())
            report.add(Remark::note, scene.source, "mesh " + std::to_string(number) + " '" + mesh.name + "'",
                       std::to_string(results[r].degenerate_faces) + " triangles of no area have no say in the normals");
    }
}

}  // namespace

std::uint32_t tangent_set(const Scene& scene, const Mesh& mesh, TangentWish wish) {
    if (wish == TangentWish::none) return none;
    const auto has = [&](std::uint32_t set) { return set < mesh.texcoords.size() && !mesh.texcoords[set].empty(); };
    if (mesh.material != none) {
        const Material& m = scene.materials[mesh.material];
        for (const TextureUse* use : {&m.normal_texture, &m.height_texture})
            if (*use) return has(use->texcoord_set) ? use->texcoord_set : none;
    }
    if (wish == TangentWish::everywhere)
        for (std::uint32_t set = 0; set < mesh.texcoords.size(); ++set)
            if (has(set)) return set;
    return none;
}

Scene smooth_meshes(const Scene& scene, const SmoothRequest& request, Context& context) {
    const std::vector<dmat4> world = world_matrices(scene);
    const Selection s = select(scene, request, world);
    if (s.instances.empty()) return scene;
    std::vector<AttributeMesh> meshes;
    for (std::size_t r = 0; r < s.computed.size(); ++r) {
        const Instance& instance = s.instances[s.computed[r]];
        meshes.push_back(attribute_mesh(scene, instance, s.in_world[r] ? world[instance.node] : dmat4{}, request));
    }
    check_memory(meshes, context);
    std::vector<MeshAttributes> results = compute_attributes(meshes, options_for(request, meshes), context);
    report_faults(scene, s, results, context.report());

    Scene out = scene;
    MeshVariants variants(out);
    std::vector<std::uint32_t> placed(results.size(), none);  // the mesh that shows each result
    for (std::size_t i = 0; i < s.instances.size(); ++i) {
        const std::size_t r = s.result_of[i];
        if (placed[r] != none) {
            variants.share(s.instances[i], placed[r]);
        } else {
            const std::uint32_t number = s.instances[i].mesh;
            Mesh mesh = with_attributes(scene.meshes[number], std::move(results[r]), request.attributes.normals, context);
            refuse_target_directions(scene, mesh, number, request.attributes.normals, context.report());
            placed[r] = variants.place(s.instances[i], std::move(mesh));
        }
    }
    if (variants.copies() > 0)
        context.report().add(Remark::note, scene.source, {},
                             std::to_string(variants.copies()) + " instances got a mesh of their own: their normals differ by what they touch");
    return out;
}

namespace {

// The normals of the scene as it stands; the sums of the publication run over everything that is placed.
Scene add_published_tangents(const Scene& scene, const SmoothRequest& request, Context& context) {
    SmoothRequest all = request;
    all.attributes.normals = false;
    all.attributes.tangent_mode = TangentMode::published;
    if (all.attributes.scope == Scope::face) all.attributes.scope = Scope::model;
    all.only_missing = false;
    return smooth_meshes(scene, all, context);
}

}  // namespace

Scene add_missing_tangents(const Scene& scene, const SmoothRequest& request, Context& context) {
    if (request.tangents == TangentWish::none) return scene;
    if (request.kept_tangents == TangentMode::published) return add_published_tangents(scene, request, context);
    std::vector<std::uint32_t> numbers;
    std::vector<bool> seen(scene.meshes.size(), false);
    std::vector<AttributeMesh> meshes;
    SmoothRequest only = request;
    only.attributes.normals = false;
    only.attributes.tangent_mode = request.kept_tangents;
    only.attributes.scope = Scope::object;  // kept normals: each mesh by itself, so that instances stay shared
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (seen[instance.mesh] || mesh.normals.empty() || !mesh.tangents.empty()) continue;
        seen[instance.mesh] = true;
        if (tangent_set(scene, mesh, only.tangents) == none) continue;
        meshes.push_back(attribute_mesh(scene, instance, dmat4{}, only));
        meshes.back().object = instance.mesh;
        numbers.push_back(instance.mesh);
    }
    if (meshes.empty()) return scene;
    check_memory(meshes, context);
    std::vector<MeshAttributes> results = compute_attributes(meshes, options_for(only, meshes), context);
    Scene out = scene;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        out.meshes[numbers[i]] = with_attributes(scene.meshes[numbers[i]], std::move(results[i]), false, context);
    return out;
}

Scene smooth_scene(const Scene& scene, const SmoothSceneOptions& options, Context& context) {
    validate(scene);
    SmoothRequest request;
    request.attributes = options.attributes;
    request.tangents = options.attributes.tangents ? TangentWish::everywhere : TangentWish::none;
    request.only_missing = options.only_missing;
    if (options.tangents) request.attributes.tangent_mode = request.kept_tangents = *options.tangents;
    const bool published = request.attributes.tangent_mode == TangentMode::published;
    if (published) request.kept_tangents = TangentMode::published;
    Scene out = options.attributes.normals ? smooth_meshes(scene, request, context) : scene;
    if (request.tangents == TangentWish::none) return out;
    if (!options.attributes.normals && !options.only_missing)
        for (Mesh& mesh : out.meshes)
            if (tangent_set(out, mesh, request.tangents) != none) mesh.tangents = {};  // to be made anew
    return add_missing_tangents(out, request, context);
}

}  // namespace rakelight
