// SPDX-License-Identifier: Apache-2.0
// Normals and tangents of a scene by the door of <rakelight/attributes.h>: what goes in, and where the results go.
#include <map>
#include <string>

#include "math/linear.h"
#include "prepare/bind_pose.h"
#include "prepare/morph_normals.h"
#include "prepare/normal_rule.h"
#include "prepare/prepare.h"
#include "prepare/smooth_request.h"
#include "prepare/smooth_selection.h"
#include "prepare/split_vertices.h"
#include "prepare/tangent_report.h"
#include "prepare/variants.h"
#include "scene/charge_arrays.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

AttributeMesh attribute_mesh(const Scene& scene, const Instance& instance, const dmat4& place, const SmoothRequest& request) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    AttributeMesh out;
    out.object = instance.node;
    out.positions = mesh.positions;
    out.indices = mesh.indices;
    const std::uint32_t set = tangent_set(scene, mesh, request.tangents);
    if (set != none) out.texcoords = mesh.texcoords[set];
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

/// Results are vectors of our own making, but a file decides how many placements there are.
void check_memory(const std::vector<AttributeMesh>& meshes, Context& context) {
    std::uint64_t bytes = meshes.size() * (sizeof(AttributeMesh) + 2 * sizeof(MeshAttributes));
    for (const AttributeMesh& m : meshes)
        bytes += m.positions.size() * (sizeof(vec3) + (m.texcoords.empty() ? 0 : sizeof(vec4))) + m.indices.size() * sizeof(std::uint32_t);
    context.memory().check(bytes, "normals and tangents of all instances");
}

/// All meshes that get vertices of their own, with normals and tangents that they had none of, together.
/// @param numbers  of the meshes, as `results` has them
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

Mesh with_attributes(const Mesh& source, MeshAttributes&& attributes, bool new_normals, Context& context) {
    Mesh mesh = source;
    mesh.tangents = {};
    if (new_normals) mesh.normals = {};
    split_vertices(mesh, std::move(attributes.indices), attributes.source_vertex, context);
    if (new_normals) mesh.normals = std::move(attributes.normals);
    mesh.tangents = std::move(attributes.tangents);
    return mesh;
}

/// A mesh with what with_attributes() made of another one that had the same arrays.
Mesh with_arrays_of(const Mesh& made, const Mesh& own) {
    Mesh mesh = own;
    mesh.positions = made.positions, mesh.indices = made.indices, mesh.normals = made.normals;
    mesh.tangents = made.tangents, mesh.texcoords = made.texcoords, mesh.colors = made.colors;
    mesh.influences = made.influences;
    return mesh;
}

/// Offsets from the old normals and tangents say nothing about the new ones. Positions of targets stay.
/// @param directions  of the new normals, or null: none were made
void set_target_directions(const Scene& scene, Mesh& mesh, std::uint32_t number, bool new_normals, TargetDirections* directions,
                           Report& report) {
    bool refused = false;
    for (std::size_t t = 0; t < mesh.targets.size(); ++t) {
        MorphTarget& target = mesh.targets[t];
        std::vector<vec3> normals, tangents;
        if (directions) {
            normals = std::move(directions->normals[t]);
            tangents = std::move(directions->tangents[t]);
        }
        refused = refused || (new_normals && !target.normals.empty() && normals.empty()) || (!target.tangents.empty() && tangents.empty());
        if (new_normals) target.normals = std::move(normals);
        target.tangents = std::move(tangents);
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

struct Computed {
    std::vector<MeshAttributes> attributes;
    std::vector<TargetDirections> targets;  ///< [attributes], or none: no target gets new normals
};

/// In two steps where there are morph targets, so that what does not move has offsets of exactly 0.
Computed compute(const Scene& scene, const std::vector<std::uint32_t>& numbers, const std::vector<AttributeMesh>& meshes,
                 const AttributeOptions& options, Context& context) {
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
void report_faults(const Scene& scene, const std::vector<std::uint32_t>& numbers, const std::vector<MeshAttributes>& results,
                   const AttributeOptions& options, Report& report) {
    InvertedMaps inverted;
    for (std::size_t r = 0; r < results.size(); ++r) {
        const std::uint32_t number = numbers[r];
        const Mesh& mesh = scene.meshes[number];
        // That all of them are degenerate is a warning of prepare's own check.
        if (options.normals && results[r].degenerate_faces > 0 && results[r].degenerate_faces < mesh.triangle_count())
            report.add(Remark::note, scene.source, "mesh " + std::to_string(number) + " '" + mesh.name + "'",
                       std::to_string(results[r].degenerate_faces) + " triangles of no area have no say in the normals");
        if (results[r].inverted_faces > 0 && inverted.first_mesh == none) inverted.first_mesh = number;
        inverted.triangles += results[r].inverted_faces;
        if (!results[r].tangents.empty()) inverted.of += mesh.triangle_count();
        if (options.measure_orthogonality && !results[r].tangents.empty())
            report_orthogonality(scene, number, results[r].orthogonality_loss_max_deg, results[r].orthogonality_loss_mean_deg, report);
    }
    report_inverted(scene, inverted, options.tangent_mode, report);
}

}  // namespace

std::uint32_t tangent_set(const Scene& scene, const Mesh& mesh, TangentWish wish) {
    if (wish == TangentWish::none) return none;
    const auto has = [&](std::uint32_t set) { return set < mesh.texcoords.size() && !mesh.texcoords[set].empty(); };
    if (mesh.material != none) {
        const Material& m = scene.materials[mesh.material];
        const MetallicRoughnessParameters& p = m.metallic_roughness;
        for (const TextureUse* use :
             {&m.normal_texture, &m.height_texture, &p.clearcoat_normal_texture, &p.anisotropy_texture})
            if (*use) return has(use->texcoord_set) ? use->texcoord_set : none;
        if (wants_tangents(m)) wish = TangentWish::everywhere;
    }
    if (wish == TangentWish::everywhere)
        for (std::uint32_t set = 0; set < mesh.texcoords.size(); ++set)
            if (has(set)) return set;
    return none;
}

namespace {

/// Puts the results into the scene. What several results are made of keeps its first form until all are.
class ResultPlacer {
public:
    /// @param numbers  [selection.computed] the meshes that were computed
    ResultPlacer(Scene& scene, const SmoothRequest& request, const SmoothSelection& selection,
                 const std::vector<std::uint32_t>& numbers, Context& context)
        : scene_(scene),
          request_(request),
          s_(selection),
          numbers_(numbers),
          context_(context),
          variants_(scene, request.keep_instances),
          uses_(scene.meshes.size(), 0) {
        for (const std::uint32_t number : numbers_) ++uses_[number];
        for (std::size_t i = 0; i < s_.instances.size(); ++i)
            if (const std::uint32_t mesh = s_.instances[i].mesh; mesh != numbers_[s_.result_of[i]]) ++uses_[mesh];
    }

    void place(Computed& computed) {
        const bool new_normals = request_.attributes.normals;
        std::vector<std::uint32_t> placed(computed.attributes.size(), none);  // the mesh that shows each result
        for (std::size_t i = 0; i < s_.instances.size(); ++i) {
            const std::size_t r = s_.result_of[i];
            const std::uint32_t number = s_.instances[i].mesh;
            if (placed[r] != none && number == numbers_[r]) {
                variants_.share(s_.instances[i], placed[r]);
            } else if (placed[r] != none) {
                variants_.place(s_.instances[i], with_arrays_of(scene_.meshes[placed[r]], source(number)));
            } else {
                Mesh mesh = with_attributes(source(number), std::move(computed.attributes[r]), new_normals, context_);
                set_target_directions(scene_, mesh, number, new_normals,
                                      computed.targets.empty() ? nullptr : &computed.targets[r], context_.report());
                placed[r] = variants_.place(s_.instances[i], std::move(mesh));
            }
        }
    }

    void report() const {
        if (variants_.kept() > 0)
            context_.report().add(Remark::warning, scene_.source, {},
                                  std::to_string(variants_.kept()) +
                                      " instances that touch other things keep the normals of the first of their mesh: "
                                      "kept shared as asked");
        if (variants_.copies() > 0)
            context_.report().add(Remark::note, scene_.source, {},
                                  std::to_string(variants_.copies()) +
                                      " instances got a mesh of their own: their normals differ by what they touch");
    }

private:
    const Mesh& source(std::uint32_t number) {
        if (uses_[number] == 1) return scene_.meshes[number];
        return originals_.try_emplace(number, scene_.meshes[number]).first->second;
    }

    Scene& scene_;
    const SmoothRequest& request_;
    const SmoothSelection& s_;
    const std::vector<std::uint32_t>& numbers_;
    Context& context_;
    MeshVariants variants_;
    std::vector<std::uint32_t> uses_;  ///< [meshes] how many results are made of each, at most
    std::map<std::uint32_t, Mesh> originals_;
};

}  // namespace

Scene smooth_meshes(Scene scene, const SmoothRequest& request, Context& context) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    const SmoothSelection s = select_instances(scene, request, world);
    if (s.instances.empty()) return scene;
    std::vector<std::uint32_t> numbers;
    Computed computed;
    {
        std::vector<AttributeMesh> meshes;
        numbers.reserve(s.computed.size()), meshes.reserve(s.computed.size());
        for (std::size_t r = 0; r < s.computed.size(); ++r) {
            const Instance& instance = s.instances[s.computed[r]];
            numbers.push_back(instance.mesh);
            meshes.push_back(attribute_mesh(scene, instance, s.in_world[r] ? world[instance.node] : dmat4{}, request));
        }
        check_memory(meshes, context);
        computed = compute(scene, numbers, meshes, options_for(request, meshes), context);
    }
    check_split(scene, numbers, computed.attributes, context);
    report_faults(scene, numbers, computed.attributes, request.attributes, context.report());
    if (request.attributes.normals) warn_of_parting_vertices(scene, s.instances, world, context.report());
    ResultPlacer placer(scene, request, s, numbers, context);
    placer.place(computed);
    placer.report();
    return scene;
}

namespace {

// The normals of the scene as it stands; the sums of the publication run over everything that is placed.
Scene add_published_tangents(Scene scene, const SmoothRequest& request, Context& context) {
    SmoothRequest all = request;
    all.attributes.normals = false;
    all.attributes.tangent_mode = request.kept_tangents;
    all.only_missing = false;
    if (!request.source) {
        if (all.attributes.scope == Scope::face) all.attributes.scope = Scope::model;
        return smooth_meshes(std::move(scene), all, context);
    }
    for (const Scope scope : {Scope::object, Scope::model}) {
        all.attributes.scope = scope;
        scene = smooth_meshes(std::move(scene), all, context);
    }
    return scene;
}

}  // namespace

Scene add_missing_tangents(Scene scene, const SmoothRequest& request, Context& context) {
    if (request.tangents == TangentWish::none) return scene;
    if (is_published(request.kept_tangents)) return add_published_tangents(std::move(scene), request, context);
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
    report_faults(scene, numbers, results, only.attributes, context.report());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        scene.meshes[numbers[i]] = with_attributes(scene.meshes[numbers[i]], std::move(results[i]), false, context);
    return scene;
}

Scene smooth_scene(const Scene& scene, const SmoothSceneOptions& options, Context& context) {
    SmoothRequest request;
    request.attributes = options.attributes;
    request.tangents = options.attributes.tangents ? TangentWish::everywhere : TangentWish::none;
    request.only_missing = options.only_missing;
    if (options.tangents) request.attributes.tangent_mode = request.kept_tangents = *options.tangents;
    if (is_published(request.attributes.tangent_mode)) request.kept_tangents = request.attributes.tangent_mode;
    Scene out = options.attributes.normals ? smooth_meshes(scene, request, context) : scene;
    if (request.tangents != TangentWish::none) {
        if (!options.attributes.normals && !options.only_missing)
            for (Mesh& mesh : out.meshes)
                if (tangent_set(out, mesh, request.tangents) != none) mesh.tangents = {};  // to be made anew
        out = add_missing_tangents(std::move(out), request, context);
    }
    charge_new_arrays(out, unpaid_arrays(scene), context);
    return out;
}

}  // namespace rakelight
