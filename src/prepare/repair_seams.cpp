// SPDX-License-Identifier: Apache-2.0
#include "prepare/repair_seams.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include <rakelight/validate.h>

#include "base/cancel_check.h"
#include "math/linear.h"
#include "prepare/bind_pose.h"
#include "prepare/normal_rule.h"
#include "prepare/prepare.h"
#include "prepare/variants.h"
#include "scene/charge_arrays.h"

namespace rakelight {
namespace {

/// The placements that take part.
struct SeamParts {
    std::vector<Instance> instances;
    std::vector<AttributeMesh> meshes;  ///< [instances] in the world, skinned ones in bind pose
};

SeamParts parts_of(const Scene& scene, const SeamRequest& request, const std::vector<dmat4>& world) {
    SeamParts parts;
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        NormalRule rule;
        if (request.source) rule = normal_rule(scene, mesh, *request.source);
        if (mesh.normals.empty() || (request.source && !rule.joins_seams)) continue;
        AttributeMesh& m = parts.meshes.emplace_back();
        m.object = instance.node;
        m.positions = mesh.positions;
        m.indices = mesh.indices;
        m.normals = mesh.normals;
        m.to_world = world[instance.node] * translation(mesh.origin);
        m.position_step = mesh.position_step;
        m.crease_angle_rad = rule.crease_angle_rad;
        parts.instances.push_back(instance);
    }
    return parts;
}

/// A copy of an array in which some entries are others.
template <class T, class Turned>
Block<T> with_turned(const Block<T>& old, const MeshSeams& seams, const Turned& turned) {
    if (old.empty()) return old;
    std::vector<T> values(old.begin(), old.end());
    for (std::size_t i = 0; i < seams.vertices.size(); ++i) {
        const std::uint32_t v = seams.vertices[i];
        values[v] = turned(values[v], v, seams.normals[i]);
    }
    return values;
}

/// Arrays that several meshes share go on being shared.
struct SharedArrays {
    std::map<const void*, Block<vec3>> normals;   ///< by the old ones
    std::map<const void*, Block<vec4>> tangents;  ///< by the old ones
};

/// The mesh with the turned normals, and what turns along with them.
/// @param shared  of meshes whose turned normals are the same; or null
Mesh with_turned(const Mesh& mesh, const MeshSeams& seams, SharedArrays* shared) {
    Mesh out = mesh;
    const Block<vec3>& from = mesh.normals;
    Block<vec3> normals;
    Block<vec4> tangents;
    Block<vec3>& new_normals = shared ? shared->normals[mesh.normals.identity()] : normals;
    Block<vec4>& new_tangents = shared ? shared->tangents[mesh.tangents.identity()] : tangents;
    if (new_normals.empty())
        new_normals = with_turned(mesh.normals, seams, [](vec3, std::uint32_t, vec3 to) { return to; });
    if (new_tangents.empty())
        new_tangents = with_turned(mesh.tangents, seams, [&](vec4 tangent, std::uint32_t v, vec3 to) {
            return turned_tangent(tangent, from[v], to);
        });
    out.normals = new_normals;
    out.tangents = new_tangents;
    const auto along = [&](vec3 offset, std::uint32_t v, vec3 to) { return turned_along(offset, from[v], to); };
    for (MorphTarget& target : out.targets) {
        target.normals = with_turned(target.normals, seams, along);
        target.tangents = with_turned(target.tangents, seams, along);
    }
    return out;
}

/// Meshes of several materials often lie in one array of vertices, of which each uses its own: one new array serves all, unless
/// two placements want different normals of one vertex.
class ArraySharing {
public:
    ArraySharing(const Scene& scene, const SeamParts& parts, std::vector<MeshSeams>& turned, Context& context)
        : scene_(scene), parts_(parts), turned_(turned), check_(context), group_(turned.size(), no_index) {
        std::map<const void*, std::vector<std::uint32_t>> by_array;
        for (std::uint32_t i = 0; i < turned.size(); ++i) by_array[mesh(i).normals.identity()].push_back(i);
        for (const auto& [array, placements] : by_array)
            if (placements.size() > 1) unite(placements);
    }
    SharedArrays* of(std::uint32_t placement) {
        return group_[placement] == no_index ? nullptr : &arrays_[group_[placement]];
    }

private:
    const Mesh& mesh(std::uint32_t placement) const { return scene_.meshes[parts_.instances[placement].mesh]; }

    void unite(const std::vector<std::uint32_t>& placements) {
        std::map<std::uint32_t, vec3> wanted;  // the turned vertices
        for (const std::uint32_t i : placements)
            for (std::size_t k = 0; k < turned_[i].vertices.size(); ++k)
                if (wanted.try_emplace(turned_[i].vertices[k], turned_[i].normals[k]).first->second !=
                    turned_[i].normals[k])
                    return;
        if (wanted.empty()) return;
        for (const std::uint32_t i : placements)
            if (!is_fine(i, wanted)) return;
        MeshSeams all;
        for (const auto& [vertex, normal] : wanted) all.vertices.push_back(vertex), all.normals.push_back(normal);
        for (const std::uint32_t i : placements) {
            turned_[i] = all;
            group_[i] = std::uint32_t(arrays_.size());
        }
        arrays_.emplace_back();
    }

    /// Whatever of `wanted` this placement uses it turns itself.
    bool is_fine(std::uint32_t i, const std::map<std::uint32_t, vec3>& wanted) {
        const std::vector<std::uint32_t>& own = turned_[i].vertices;
        for (const std::uint32_t v : mesh(i).indices) {
            check_();
            if (wanted.contains(v) && !std::binary_search(own.begin(), own.end(), v)) return false;
        }
        return true;
    }

    const Scene& scene_;
    const SeamParts& parts_;
    std::vector<MeshSeams>& turned_;
    CancelCheck check_;
    std::vector<std::uint32_t> group_;  ///< [placements] into `arrays_`, or `no_index`
    std::vector<SharedArrays> arrays_;
};

void check_memory(const SeamParts& parts, Context& context) {
    context.memory().check(parts.meshes.size() * (sizeof(AttributeMesh) + sizeof(MeshSeams) + sizeof(Instance)),
                           "the seams of all instances");
}

/// Arrays of the meshes that change; what is shared with another placement is counted again.
void check_arrays(const Scene& scene, const SeamParts& parts, const std::vector<MeshSeams>& seams, Context& context) {
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < seams.size(); ++i) {
        if (seams[i].vertices.empty()) continue;
        const Mesh& mesh = scene.meshes[parts.instances[i].mesh];
        bytes += mesh.normals.size() * sizeof(vec3) + mesh.tangents.size() * sizeof(vec4);
        for (const MorphTarget& t : mesh.targets) bytes += (t.normals.size() + t.tangents.size()) * sizeof(vec3);
    }
    context.memory().check(bytes, "normals that are joined where meshes meet");
}

void report_instances(const Scene& scene, const MeshVariants& variants, Report& report) {
    if (variants.kept() > 0)
        report.add(Remark::warning, scene.source, {},
                   std::to_string(variants.kept()) +
                       " instances that touch other things keep the normals of the first of their mesh: kept shared as "
                       "asked");
    if (variants.copies() > 0)
        report.add(Remark::note, scene.source, {},
                   std::to_string(variants.copies()) +
                       " instances got a mesh of their own: their normals differ by what they touch");
}

}  // namespace

Scene join_seams(Scene scene, const SeamRequest& request, SeamReport& seams, Context& context) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    const SeamParts parts = parts_of(scene, request, world);
    check_memory(parts, context);
    std::vector<MeshSeams> turned = join_seams(parts.meshes, request.options, seams, context);
    if (seams.turned == 0) return scene;
    check_arrays(scene, parts, turned, context);
    ArraySharing sharing(scene, parts, turned, context);
    const std::vector<Mesh> originals = scene.meshes;  // the arrays are shared
    MeshVariants variants(scene, context, request.keep_instances);
    for (std::uint32_t i = 0; i < turned.size(); ++i) {
        const Instance& instance = parts.instances[i];
        const Mesh& mesh = originals[instance.mesh];
        variants.place(instance, turned[i].vertices.empty() ? mesh : with_turned(mesh, turned[i], sharing.of(i)));
    }
    report_instances(scene, variants, context.report());
    warn_of_parting_vertices(scene, parts.instances, world, context);
    return scene;
}

Scene repair_seams(const Scene& scene, const SeamOptions& options, Context& context, SeamReport* seams,
                   bool keep_instances) {
    validate(scene);
    SeamReport unread;
    Scene out =
        join_seams(scene, {.options = options, .keep_instances = keep_instances}, seams ? *seams : unread, context);
    charge_new_arrays(out, unpaid_arrays(scene), context);
    return out;
}

std::string describe(const SeamReport& seams) {
    char text[200];
    std::string out = std::to_string(seams.turned) + " of " + std::to_string(seams.normals) + " authored normals turn";
    if (seams.turned > 0) {
        std::snprintf(text, sizeof text, " (at most %.3g degrees, %.3g on average)", seams.max_deg, seams.mean_deg);
        out += text;
    }
    if (seams.flat_pairs > 0)
        out += ", " + std::to_string(seams.flat_pairs) + " pairs of flat faces at borders keep their edge";
    if (seams.unusable > 0) out += ", " + std::to_string(seams.unusable) + " that are zero or not finite stay so";
    return out;
}

}  // namespace rakelight
