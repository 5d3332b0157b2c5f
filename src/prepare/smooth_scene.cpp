// SPDX-License-Identifier: Apache-2.0
// Computes normals and tangents of a scene by compute_attributes(): inputs, and placement of the results.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>

#include "base/format_text.h"
#include "geometry/attribute_input.h"
#include "geometry/mesh_islands.h"
#include "math/linear.h"
#include "prepare/bind_pose.h"
#include "prepare/moving_placements.h"
#include "prepare/normal_rule.h"
#include "prepare/place_results.h"
#include "prepare/prepare.h"
#include "prepare/smooth_request.h"
#include "prepare/smooth_selection.h"
#include "prepare/split_vertices.h"
#include "prepare/tangent_report.h"
#include "scene/charge_arrays.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

AttributeMesh attribute_mesh(const Scene& scene, const Instance& instance, const dmat4& place,
                             const SmoothRequest& request) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    AttributeMesh out;
    out.object = instance.node;
    out.positions = mesh.positions;
    out.indices = mesh.indices;
    const std::uint32_t set = tangent_set(scene, mesh, request.tangents);
    if (set != no_index) out.texcoords = mesh.texcoords[set];
    if (!request.attributes.normals) out.normals = mesh.normals;
    NormalRule rule{.groups = request.groups};
    if (request.source) rule = normal_rule(scene, mesh, *request.source);
    out.crease_angle_rad = rule.crease_angle_rad;
    if (rule.groups && request.attributes.normals) {
        out.smoothing = mesh.smoothing;
        if (!mesh.smoothing.empty())
            out.group_kind = mesh.smoothing_kind == SmoothingKind::masks ? GroupKind::masks : GroupKind::numbers;
        out.smoothing_hint = mesh.smoothing_hint;
    }
    out.to_world = place * translation(mesh.origin);
    out.position_step = mesh.position_step;
    return out;
}

/// Charges results, because their size depends on the number of instances in the file.
void check_memory(const std::vector<AttributeMesh>& meshes, Context& context) {
    std::uint64_t bytes = meshes.size() * (sizeof(AttributeMesh) + 2 * sizeof(MeshAttributes));
    for (const AttributeMesh& m : meshes)
        bytes += m.positions.size() * (sizeof(vec3) + (m.texcoords.empty() ? 0 : sizeof(vec4))) +
                 m.indices.size() * sizeof(std::uint32_t);
    context.memory().check(bytes, "normals and tangents of all instances");
}

/// Total size of all meshes that get new vertices, normals or tangents.
/// @param numbers mesh indices, in the order of `results`
void check_split(const Scene& scene, const std::vector<std::uint32_t>& numbers,
                 const std::vector<MeshAttributes>& results, Context& context) {
    std::uint64_t bytes = 0;
    for (std::size_t r = 0; r < results.size(); ++r) {
        const Mesh& mesh = scene.meshes[numbers[r]];
        const std::uint64_t added = results[r].source_vertex.size(), all = mesh.positions.size() + added;
        bytes += results[r].normals.size() * sizeof(vec3) + results[r].tangents.size() * sizeof(vec4) +
                 results[r].indices.size() * sizeof(std::uint32_t);
        if (added > 0) bytes += all * vertex_bytes(mesh);
    }
    context.memory().check(bytes, "vertices with normals of their own");
}

AttributeOptions options_for(const SmoothRequest& request, const std::vector<AttributeMesh>& meshes) {
    AttributeOptions options = request.attributes;
    options.tangents = false;
    for (const AttributeMesh& m : meshes) options.tangents = options.tangents || !m.texcoords.empty();
    return options;
}

/// [computed] whether skinned or morphed.
std::vector<bool> moving(const Scene& scene, const SmoothSelection& s) {
    std::vector<bool> result;
    for (const std::size_t i : s.computed) {
        const Mesh& mesh = scene.meshes[s.instances[i].mesh];
        result.push_back(!mesh.targets.empty() || follows_skin(scene, scene.nodes[s.instances[i].node], mesh));
    }
    return result;
}

/// In two steps, and stores the first; GeneratedAttributes::numbers are set later.
Computed compute_to_keep(const Scene& scene, const SmoothSelection& s, std::vector<AttributeMesh> meshes,
                         const AttributeOptions& options, std::vector<GeneratedAttributes>& made, Context& context) {
    Computed computed;
    const AttributePlan plan = group(meshes, options, context);
    computed.attributes = accumulate(plan, meshes, context);
    std::vector<std::uint32_t> islands = geometry::mesh_islands(plan);
    made.push_back({.plan = plan, .meshes = std::move(meshes), .islands = std::move(islands)});
    GeneratedAttributes& kept = made.back();
    for (const std::size_t i : s.computed) {
        kept.sources.push_back(scene.meshes[s.instances[i].mesh]);
        kept.nodes.push_back(s.instances[i].node);
    }
    kept.in_world = s.in_world;
    kept.moves = moving(scene, s);
    return computed;
}

/// In two steps if there are morph targets, so that unmoved vertices have offsets of exactly 0.
Computed compute(const Scene& scene, const std::vector<std::uint32_t>& numbers,
                 const std::vector<AttributeMesh>& meshes, const AttributeOptions& options, Context& context) {
    bool has_targets = false;
    for (const std::uint32_t number : numbers)
        for (const MorphTarget& target : scene.meshes[number].targets)
            has_targets = has_targets || wants_normals(scene.meshes[number], target);
    Computed computed;
    if (!has_targets || !options.normals) {
        computed.attributes = compute_attributes(meshes, options, context);
        return computed;
    }
    const AttributePlan plan = group(meshes, options, context);
    computed.attributes = accumulate(plan, meshes, context);
    computed.targets = target_directions(scene, numbers, meshes, plan, computed.attributes, context);
    return computed;
}

/// @param numbers  [results] their meshes
void report_faults(const Scene& scene, const std::vector<std::uint32_t>& numbers,
                   const std::vector<MeshAttributes>& results, const AttributeOptions& options, Report& report) {
    InvertedMaps inverted;
    for (std::size_t r = 0; r < results.size(); ++r) {
        const std::uint32_t number = numbers[r];
        const Mesh& mesh = scene.meshes[number];
        // If all of them are degenerate, prepare_scene() warns.
        if (options.normals && results[r].degenerate_faces > 0 && results[r].degenerate_faces < mesh.triangle_count())
            report.add(Remark::note, scene.source, format_text("mesh {} '{}'", number, mesh.name),
                       format_text("{} triangles of no area have no say in the normals", results[r].degenerate_faces));
        if (results[r].inverted_faces > 0 && inverted.first_mesh == no_index) inverted.first_mesh = number;
        inverted.triangles += results[r].inverted_faces;
        if (!results[r].tangents.empty()) inverted.of += mesh.triangle_count();
        if (options.measure_orthogonality && !results[r].tangents.empty())
            report_orthogonality(scene, number, results[r].orthogonality_loss_max_deg,
                                 results[r].orthogonality_loss_mean_deg, report);
    }
    report_inverted(scene, inverted, options.tangent_mode, report);
}

/// Whether parts have their own crease angles.
void note_creases(const Scene& scene, const SmoothRequest& request, const std::vector<AttributeMesh>& meshes,
                  Report& report) {
    if (!request.source || request.every_scope || request.attributes.scope != Scope::model) return;
    const geometry::CreaseRange creases = geometry::crease_range(meshes, request.attributes);
    if (!request.attributes.normals || creases.least == creases.most) return;
    char angles[64];
    std::snprintf(angles, sizeof angles, "%g to %g", degrees(creases.least), degrees(creases.most));
    report.add(Remark::note, scene.source, {},
               "parts that are smoothed together have crease angles of their own (" + std::string(angles) +
                   " degrees): where two of them meet, the smaller angle rules");
}

}  // namespace

std::uint32_t tangent_set(const Scene& scene, const Mesh& mesh, TangentNeed need) {
    if (need == TangentNeed::none) return no_index;
    const auto has = [&](std::uint32_t set) { return set < mesh.texcoords.size() && !mesh.texcoords[set].empty(); };
    if (mesh.material != no_index) {
        const Material& m = scene.materials[mesh.material];
        const MetallicRoughnessParameters& p = m.metallic_roughness;
        for (const TextureUse* use :
             {&m.normal_texture, &m.height_texture, &p.clearcoat_normal_texture, &p.anisotropy_texture})
            if (*use) return has(use->texcoord_set) ? use->texcoord_set : no_index;
        if (needs_tangents(m)) need = TangentNeed::everywhere;
    }
    if (need == TangentNeed::everywhere)
        for (std::uint32_t set = 0; set < mesh.texcoords.size(); ++set)
            if (has(set)) return set;
    return no_index;
}

Scene smooth_meshes(Scene scene, const SmoothRequest& request, Context& context) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    const SmoothSelection s = select_instances(scene, request, world);
    if (s.instances.empty()) return scene;
    std::vector<std::uint32_t> numbers;
    Computed computed;
    bool keeps_plan = false;
    {
        std::vector<AttributeMesh> meshes;
        numbers.reserve(s.computed.size()), meshes.reserve(s.computed.size());
        for (std::size_t r = 0; r < s.computed.size(); ++r) {
            const Instance& instance = s.instances[s.computed[r]];
            numbers.push_back(instance.mesh);
            meshes.push_back(attribute_mesh(scene, instance, s.in_world[r] ? world[instance.node] : dmat4{}, request));
        }
        check_memory(meshes, context);
        note_creases(scene, request, meshes, context.report());
        const AttributeOptions options = options_for(request, meshes);
        keeps_plan = request.made && options.normals && std::ranges::any_of(moving(scene, s), std::identity());
        computed = keeps_plan ? compute_to_keep(scene, s, std::move(meshes), options, *request.made, context)
                              : compute(scene, numbers, meshes, options, context);
    }
    check_split(scene, numbers, computed.attributes, context);
    report_faults(scene, numbers, computed.attributes, request.attributes, context.report());
    if (request.attributes.normals) warn_of_parting_vertices(scene, s.instances, world, context);
    ResultPlacer placer(scene, request, s, numbers, context);
    placer.place(computed);
    placer.report();
    if (keeps_plan)
        for (const std::size_t i : s.computed)
            request.made->back().numbers.push_back(scene.nodes[s.instances[i].node].meshes[s.instances[i].slot]);
    return scene;
}

namespace {

// Existing normals of the scene; the sums of the published modes include all instances.
Scene add_published_tangents(Scene scene, const SmoothRequest& request, Context& context) {
    SmoothRequest all = request;
    all.attributes.normals = false;
    all.attributes.tangent_mode = request.kept_tangents;
    all.only_missing = false;
    if (!request.source) {
        if (all.attributes.scope == Scope::face && !request.attributes.normals) all.attributes.scope = Scope::model;
        return smooth_meshes(std::move(scene), all, context);
    }
    for (const Scope scope : {Scope::face, Scope::object, Scope::model}) {
        all.attributes.scope = scope;
        scene = smooth_meshes(std::move(scene), all, context);
    }
    return scene;
}

}  // namespace

Scene add_missing_tangents(Scene scene, const SmoothRequest& request, Context& context) {
    if (request.tangents == TangentNeed::none) return scene;
    if (is_published(request.kept_tangents)) return add_published_tangents(std::move(scene), request, context);
    std::vector<std::uint32_t> numbers;
    std::vector<bool> seen(scene.meshes.size(), false);
    std::vector<AttributeMesh> meshes;
    SmoothRequest only = request;
    only.attributes.normals = false;
    only.attributes.tangent_mode = request.kept_tangents;
    only.attributes.scope = Scope::object;  // kept normals: each mesh separately, so that instances stay shared
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (seen[instance.mesh] || mesh.normals.empty() || !mesh.tangents.empty()) continue;
        seen[instance.mesh] = true;
        if (tangent_set(scene, mesh, only.tangents) == no_index) continue;
        meshes.push_back(attribute_mesh(scene, instance, dmat4{}, only));
        meshes.back().object = instance.mesh;
        numbers.push_back(instance.mesh);
    }
    if (meshes.empty()) return scene;
    check_memory(meshes, context);
    std::vector<MeshAttributes> results = compute_attributes(meshes, options_for(only, meshes), context);
    report_faults(scene, numbers, results, only.attributes, context.report());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        scene.meshes[numbers[i]] = with_attributes(scene.meshes[numbers[i]], std::move(results[i]), false, context);
    return scene;
}

Scene smooth_scene(const Scene& scene, const SmoothSceneOptions& options, Context& context) {
    SmoothRequest request;
    request.attributes = options.attributes;
    request.tangents = options.attributes.tangents ? TangentNeed::everywhere : TangentNeed::none;
    request.only_missing = options.only_missing;
    if (options.tangents) request.attributes.tangent_mode = request.kept_tangents = *options.tangents;
    if (is_published(request.attributes.tangent_mode)) request.kept_tangents = request.attributes.tangent_mode;
    Scene out = options.attributes.normals ? smooth_meshes(scene, request, context) : scene;
    if (request.tangents != TangentNeed::none) {
        if (!options.attributes.normals && !options.only_missing)
            for (Mesh& mesh : out.meshes)
                if (tangent_set(out, mesh, request.tangents) != no_index) mesh.tangents = {};  // to be recomputed
        out = add_missing_tangents(std::move(out), request, context);
    }
    charge_new_arrays(out, unpaid_arrays(scene), context);
    return out;
}

}  // namespace rakelight
