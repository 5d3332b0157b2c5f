// SPDX-License-Identifier: Apache-2.0
#include "prepare/normals/turned_normals.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "base/cancel_check.h"
#include "base/format_text.h"
#include "math/linear.h"
#include "scene/motion/change_targets.h"

namespace rakelight {
namespace {

/// A copy of an array with some entries replaced.
/// @param turned  (old entry, vertex, place in `seams`) -> new entry
template <class T, class Turned>
Block<T> with_turned(const Block<T>& old, const MeshSeams& seams, const Turned& turned) {
    if (old.empty()) return old;
    std::vector<T> values(old.begin(), old.end());
    for (std::size_t i = 0; i < seams.vertices.size(); ++i) {
        const std::uint32_t v = seams.vertices[i];
        values[v] = turned(values[v], v, i);
    }
    return values;
}

/// [vertices] The given tangent; w = 0: rotate it with its normal.
vec4 tangent_of(const MeshSeams& seams, std::size_t i) { return seams.tangents.empty() ? vec4{} : seams.tangents[i]; }

/// Shared arrays stay shared.
struct SharedArrays {
    std::map<const void*, Block<vec3>> normals;   ///< by the old ones
    std::map<const void*, Block<vec4>> tangents;  ///< by the old ones
};

/// The mesh with rotated normals, tangents and targets.
/// @param shared of meshes with equal rotated normals; or null
Mesh with_turned(const Mesh& mesh, const MeshSeams& seams, SharedArrays* shared, Context& context) {
    Mesh out = mesh;
    const Block<vec3>& from = mesh.normals;
    Block<vec3> normals;
    Block<vec4> tangents;
    Block<vec3>& new_normals = shared ? shared->normals[mesh.normals.identity()] : normals;
    Block<vec4>& new_tangents = shared ? shared->tangents[mesh.tangents.identity()] : tangents;
    if (new_normals.empty())
        new_normals =
            with_turned(mesh.normals, seams, [&](vec3, std::uint32_t, std::size_t i) { return seams.normals[i]; });
    if (new_tangents.empty())
        new_tangents = with_turned(mesh.tangents, seams, [&](vec4 tangent, std::uint32_t v, std::size_t i) {
            const vec4 own = tangent_of(seams, i);
            return own.w != 0 ? own : turned_tangent(tangent, from[v], seams.normals[i]);
        });
    out.normals = new_normals;
    out.tangents = new_tangents;
    out.shape.reset();  // the analytic shape has the old normals
    const auto along = [&](vec3 offset, std::uint32_t v, std::size_t i) {
        return turned_along(offset, from[v], seams.normals[i]);
    };
    change_targets(
        out,
        [&](MorphTarget& target, std::size_t) {
            target.normals = with_turned(target.normals, seams, along);
            target.tangents = with_turned(target.tangents, seams, along);
        },
        context);
    return out;
}

/// Meshes of several materials often share one vertex array and use different vertices. One new array is enough unless
/// two instances need different normals for one vertex.
class ArraySharing {
public:
    ArraySharing(const Scene& scene, const PlacedParts& parts, std::vector<MeshSeams>& turned, Context& context)
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
    using Wanted = std::map<std::uint32_t, std::pair<vec3, vec4>>;  ///< changed vertices: normals and tangents

    const Mesh& mesh(std::uint32_t placement) const { return scene_.meshes[parts_.instances[placement].mesh]; }

    void unite(const std::vector<std::uint32_t>& placements) {
        Wanted wanted;
        for (const std::uint32_t i : placements)
            for (std::size_t k = 0; k < turned_[i].vertices.size(); ++k) {
                const std::pair directions{turned_[i].normals[k], tangent_of(turned_[i], k)};
                if (wanted.try_emplace(turned_[i].vertices[k], directions).first->second != directions) return;
            }
        if (wanted.empty()) return;
        for (const std::uint32_t i : placements)
            if (!is_fine(i, wanted)) return;
        MeshSeams all;
        for (const auto& [vertex, directions] : wanted) {
            all.vertices.push_back(vertex);
            all.normals.push_back(directions.first), all.tangents.push_back(directions.second);
        }
        for (const std::uint32_t i : placements) {
            turned_[i] = all;
            group_[i] = std::uint32_t(arrays_.size());
        }
        arrays_.emplace_back();
    }

    /// Whether this instance itself changes all vertices of `wanted` that it uses.
    bool is_fine(std::uint32_t i, const Wanted& wanted) {
        const std::vector<std::uint32_t>& own = turned_[i].vertices;
        for (const std::uint32_t v : mesh(i).indices) {
            check_();
            if (wanted.contains(v) && !std::binary_search(own.begin(), own.end(), v)) return false;
        }
        return true;
    }

    const Scene& scene_;
    const PlacedParts& parts_;
    std::vector<MeshSeams>& turned_;
    CancelCheck check_;
    std::vector<std::uint32_t> group_;  ///< [placements] into `arrays_`, or `no_index`
    std::vector<SharedArrays> arrays_;
};

/// Size of the arrays of changed meshes; arrays shared between instances count repeatedly.
void check_arrays(const Scene& scene, const PlacedParts& parts, const std::vector<MeshSeams>& seams, Context& context) {
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < seams.size(); ++i) {
        if (seams[i].vertices.empty()) continue;
        const Mesh& mesh = scene.meshes[parts.instances[i].mesh];
        bytes += mesh.normals.size() * sizeof(vec3) + mesh.tangents.size() * sizeof(vec4);
        for (const MorphTarget& t : mesh.targets) bytes += (t.normals.size() + t.tangents.size()) * sizeof(vec3);
    }
    context.memory().check(bytes, "normals that turn where meshes meet");
}

void report_instances(const Scene& scene, const MeshVariants& variants, Report& report) {
    if (variants.kept() > 0)
        report.add(Remark::warning, scene.source, {},
                   format_text("{} instances that touch other things keep the normals of the first of their mesh: kept "
                               "shared as asked",
                               variants.kept()));
    if (variants.copies() > 0)
        report.add(Remark::note, scene.source, {},
                   format_text("{} instances got a mesh of their own: their normals differ by what they touch",
                               variants.copies()));
}

}  // namespace

void PlacedParts::add(const Instance& instance, const Mesh& mesh, const dmat4& place) {
    AttributeMesh& m = meshes.emplace_back();
    m.object = instance.node;
    m.positions = mesh.positions;
    m.indices = mesh.indices;
    m.normals = mesh.normals;
    m.to_world = place * translation(mesh.origin);
    m.position_step = mesh.position_step;
    instances.push_back(instance);
}

void PlacedParts::check_memory(Context& context) const {
    context.memory().check(meshes.size() * (sizeof(AttributeMesh) + sizeof(MeshSeams) + sizeof(Instance)),
                           "the seams of all instances");
}

Scene with_turned_normals(Scene scene, const PlacedParts& parts, std::vector<MeshSeams> turned, bool keep_instances,
                          Context& context) {
    if (std::ranges::all_of(turned, [](const MeshSeams& seams) { return seams.vertices.empty(); })) return scene;
    check_arrays(scene, parts, turned, context);
    ArraySharing sharing(scene, parts, turned, context);
    const std::vector<Mesh> originals = scene.meshes;  // the arrays are shared
    MeshVariants variants(scene, context, keep_instances);
    for (std::uint32_t i = 0; i < turned.size(); ++i) {
        const Instance& instance = parts.instances[i];
        const Mesh& mesh = originals[instance.mesh];
        variants.place(instance,
                       turned[i].vertices.empty() ? mesh : with_turned(mesh, turned[i], sharing.of(i), context));
    }
    report_instances(scene, variants, context.report());
    return scene;
}

}  // namespace rakelight
