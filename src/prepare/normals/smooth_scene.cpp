// SPDX-License-Identifier: Apache-2.0
// Computes normals and tangents of a scene by compute_attributes(): inputs, and placement of the results.
#include <rakelight/base/report.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <string>

#include "base/format_text.h"
#include "geometry/faults/mesh_islands.h"
#include "geometry/input/attribute_input.h"
#include "math/linear.h"
#include "prepare/moving_placements.h"
#include "prepare/normals/bind_pose.h"
#include "prepare/normals/missing_normals.h"
#include "prepare/normals/normal_rule.h"
#include "prepare/normals/place_results.h"
#include "prepare/normals/smooth_scene.h"
#include "prepare/normals/smooth_selection.h"
#include "prepare/normals/tangent_report.h"
#include "prepare/prepare_scene.h"
#include "prepare/split_vertices.h"
#include "scene/charge_arrays.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

/// The inputs of group() with the arrays into which they point.
struct Inputs {
    std::vector<AttributeMesh> meshes;
    std::vector<std::uint32_t> numbers;      ///< [meshes] their meshes
    std::vector<Block<vec2>> texcoords;      ///< [meshes]
    std::vector<Block<std::uint8_t>> locks;  ///< [meshes]

    void add(const Scene& scene, const Instance& instance, const dmat4& place, const SmoothRequest& request,
             Block<std::uint8_t> locked = {}) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        numbers.push_back(instance.mesh);
        locks.push_back(std::move(locked));
        texcoords.push_back(locks.back().empty()
                                ? tangent_texcoords(mesh, tangent_coordinates(scene, mesh, request.tangents))
                                : Block<vec2>{});  // its tangents are kept, too
        AttributeMesh& out = meshes.emplace_back();
        out.object = instance.node;
        out.positions = mesh.positions;
        out.indices = mesh.indices;
        out.texcoords = texcoords.back();
        out.locked = locks.back();
        if (!request.attributes.normals || !out.locked.empty()) out.normals = mesh.normals;
        out.to_world = place * translation(mesh.origin);
        out.position_step = mesh.position_step;
        set_rule(out, scene, mesh, request);
    }

private:
    static void set_rule(AttributeMesh& out, const Scene& scene, const Mesh& mesh, const SmoothRequest& request) {
        NormalRule rule{.groups = request.groups, .crease_angle_rad = own_crease_angle(mesh)};
        if (request.source) rule = normal_rule(scene, mesh, *request.source);
        out.crease_angle_rad = rule.crease_angle_rad;
        if (!rule.groups || !request.attributes.normals) return;
        out.smoothing = mesh.smoothing;
        if (!mesh.smoothing.empty())
            out.group_kind = mesh.smoothing_kind == SmoothingKind::masks ? GroupKind::masks : GroupKind::numbers;
        out.smoothing_hint = mesh.smoothing_hint;
    }
};

/// Of a selection; meshes of several placements share their locks.
Inputs inputs_of(const Scene& scene, const SmoothSelection& s, const std::vector<dmat4>& world,
                 const SmoothRequest& request) {
    Inputs in;
    const std::vector<Instance> instances = s.inputs();
    in.meshes.reserve(instances.size()), in.numbers.reserve(instances.size());
    std::map<std::uint32_t, Block<std::uint8_t>> locks;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const Mesh& mesh = scene.meshes[instances[i].mesh];
        Block<std::uint8_t> locked;
        if (request.only_missing && request.attributes.normals && !mesh.normals.empty()) {
            Block<std::uint8_t>& known = locks[instances[i].mesh];
            if (known.empty()) known = authored_locks(mesh.normals);
            locked = known;
        }
        in.add(scene, instances[i], s.in_world[i] ? world[instances[i].node] : dmat4{}, request, std::move(locked));
    }
    return in;
}

/// Before they are made: the number of instances in a file may be large.
void check_inputs(const SmoothSelection& s, Context& context) {
    const std::uint64_t each = sizeof(AttributeMesh) + 2 * sizeof(MeshAttributes) +
                               4 * sizeof(std::uint64_t) +  // the other arrays of Inputs, which grow
                               2 * sizeof(Instance);
    context.memory().check((s.computed.size() + s.beside.size()) * each, "normals and tangents of all instances");
}

/// With the results.
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

/// [inputs] whether skinned or morphed.
std::vector<bool> moving(const Scene& scene, const std::vector<Instance>& inputs) {
    std::vector<bool> result;
    for (const Instance& instance : inputs) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        result.push_back(!mesh.targets.empty() || follows_skin(scene, scene.nodes[instance.node], mesh));
    }
    return result;
}

/// In two steps, and stores the first; GeneratedAttributes::numbers are set later.
Computed compute_to_keep(const Scene& scene, const SmoothSelection& s, Inputs in, const AttributeOptions& options,
                         std::vector<GeneratedAttributes>& made, Context& context) {
    Computed computed;
    const AttributePlan plan = group(in.meshes, options, context);
    computed.attributes = accumulate(plan, in.meshes, context);
    std::vector<std::uint32_t> islands = geometry::mesh_islands(plan);
    made.push_back({.plan = plan,
                    .meshes = std::move(in.meshes),
                    .computed = s.computed.size(),
                    .texcoords = std::move(in.texcoords),
                    .locks = std::move(in.locks),
                    .islands = std::move(islands)});
    GeneratedAttributes& kept = made.back();
    const std::vector<Instance> inputs = s.inputs();
    for (const Instance& instance : inputs) {
        kept.sources.push_back(scene.meshes[instance.mesh]);
        kept.nodes.push_back(instance.node);
    }
    kept.in_world = s.in_world;
    kept.moves = moving(scene, inputs);
    return computed;
}

/// In two steps if there are morph targets, so that unmoved vertices have offsets of exactly 0.
/// @param count  how many of the inputs are computed
Computed compute(const Scene& scene, const std::vector<std::uint32_t>& numbers,
                 const std::vector<AttributeMesh>& meshes, std::size_t count, const AttributeOptions& options,
                 Context& context) {
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
    computed.alike = first_alike(std::span(numbers).first(count), std::span(computed.attributes).first(count));
    computed.targets =
        target_directions(scene, {numbers, meshes, options, computed.alike}, plan, computed.attributes, context);
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
    if (!request.attributes.normals || creases.has_rule || creases.least == creases.most) return;
    char angles[64];
    std::snprintf(angles, sizeof angles, "%g to %g", degrees(creases.least), degrees(creases.most));
    report.add(Remark::note, scene.source, {},
               "parts that are smoothed together have crease angles of their own (" + std::string(angles) +
                   " degrees): where two of them meet, the smaller angle rules");
}

}  // namespace

Scene smooth_meshes(Scene scene, const SmoothRequest& request, Context& context) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    const SmoothSelection s = select_instances(scene, request, world);
    if (s.instances.empty()) return scene;
    check_inputs(s, context);
    std::vector<std::uint32_t> numbers;
    Computed computed;
    bool keeps_plan = false;
    {
        Inputs in = inputs_of(scene, s, world, request);
        numbers = in.numbers;
        check_memory(in.meshes, context);
        note_creases(scene, request, in.meshes, context.report());
        const AttributeOptions options = options_for(request, in.meshes);
        keeps_plan = request.made && options.normals && std::ranges::any_of(moving(scene, s.inputs()), std::identity());
        computed = keeps_plan ? compute_to_keep(scene, s, std::move(in), options, *request.made, context)
                              : compute(scene, numbers, in.meshes, s.computed.size(), options, context);
    }
    numbers.resize(s.computed.size());
    computed.attributes.resize(s.computed.size());
    check_split(scene, numbers, computed.attributes, context);
    report_faults(scene, numbers, computed.attributes, request.attributes, context.report());
    if (request.attributes.normals) warn_of_parting_vertices(scene, s.instances, world, context);
    ResultPlacer placer(scene, request, s, numbers, context);
    placer.place(computed);
    placer.report();
    if (keeps_plan)
        for (const Instance& instance : s.inputs())
            request.made->back().numbers.push_back(scene.nodes[instance.node].meshes[instance.slot]);
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
    std::vector<bool> seen(scene.meshes.size(), false);
    Inputs in;
    SmoothRequest only = request;
    only.attributes.normals = false;
    only.attributes.tangent_mode = request.kept_tangents;
    only.attributes.scope = Scope::object;  // kept normals: each mesh separately, so that instances stay shared
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (seen[instance.mesh] || mesh.normals.empty() || !mesh.tangents.empty()) continue;
        seen[instance.mesh] = true;
        if (!tangent_coordinates(scene, mesh, only.tangents).exist()) continue;
        in.add(scene, instance, dmat4{}, only);
        in.meshes.back().object = instance.mesh;
    }
    if (in.meshes.empty()) return scene;
    check_memory(in.meshes, context);
    std::vector<MeshAttributes> results = compute_attributes(in.meshes, options_for(only, in.meshes), context);
    report_faults(scene, in.numbers, results, only.attributes, context.report());
    for (std::size_t i = 0; i < in.numbers.size(); ++i)
        scene.meshes[in.numbers[i]] =
            with_attributes(scene.meshes[in.numbers[i]], std::move(results[i]), false, context);
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
                if (tangent_coordinates(out, mesh, request.tangents).exist()) mesh.tangents = {};  // to be recomputed
        out = add_missing_tangents(std::move(out), request, context);
    }
    charge_new_arrays(out, unpaid_arrays(scene), context);
    return out;
}

}  // namespace rakelight
