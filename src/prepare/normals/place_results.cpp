// SPDX-License-Identifier: Apache-2.0
#include "prepare/normals/place_results.h"

#include <algorithm>
#include <string>

#include <rakelight/geometry/seams.h>

#include "base/format_text.h"
#include "prepare/split_vertices.h"
#include "scene/is_normal.h"
#include "scene/motion/change_targets.h"

namespace rakelight {
namespace {

/// A mesh with the result of with_attributes() for another mesh with the same arrays.
Mesh with_arrays_of(const Mesh& made, const Mesh& own) {
    Mesh mesh = own;
    mesh.positions = made.positions, mesh.indices = made.indices, mesh.normals = made.normals;
    mesh.tangents = made.tangents, mesh.bitangents = made.bitangents, mesh.texcoords = made.texcoords,
    mesh.colors = made.colors;
    mesh.influences = made.influences, mesh.more_influences = made.more_influences, mesh.arrays = made.arrays;
    return mesh;
}

/// Offsets of old normals and tangents do not apply to the new ones. Target positions are kept.
/// @param directions target directions of the new normals, or null
void set_target_directions(const Scene& scene, Mesh& mesh, std::uint32_t number, bool new_normals,
                           TargetDirections* directions, Context& context) {
    bool refused = false;
    const auto set = [&](MorphTarget& target, std::size_t t) {
        const Block<vec3> normals = directions ? directions->normals[t] : Block<vec3>(),
                          tangents = directions ? directions->tangents[t] : Block<vec3>();
        refused = refused || (new_normals && !target.normals.empty() && normals.empty()) ||
                  (!target.tangents.empty() && tangents.empty());
        if (new_normals) target.normals = normals;
        target.tangents = tangents;
    };
    change_targets(mesh, set, context);
    if (refused)
        context.report().add(Remark::dropped, scene.source, format_text("mesh {} '{}'", number, mesh.name),
                             "normals and tangents of morph targets do not fit the new ones and are left out");
}

/// The mesh with the normals of its gaps: split vertices are appended, all that the file has stays. Tangents at gaps are
/// made perpendicular.
/// @param directions  target directions of the new normals, or null
Mesh with_gaps_filled(const Mesh& source, MeshAttributes&& made, const TargetDirections* directions, Context& context) {
    Mesh mesh = source;
    split_vertices(mesh, std::move(made.indices), made.source_vertex, context);
    std::vector<std::uint32_t> gaps;
    for (std::uint32_t v = 0; v < mesh.normals.size(); ++v)
        if (!is_normal(mesh.normals[v])) gaps.push_back(v);
    const auto with_gaps = [&](auto& block, const auto& value_at) {
        if (block.empty()) return;
        std::vector values(block.begin(), block.end());
        for (const std::uint32_t v : gaps) values[v] = value_at(v);
        block = std::move(values);
    };
    with_gaps(mesh.normals, [&](std::uint32_t v) { return made.normals[v]; });
    const Block<vec4> tangents = mesh.tangents;
    with_gaps(mesh.tangents,
              [&](std::uint32_t v) { return turned_tangent(tangents[v], mesh.normals[v], mesh.normals[v]); });
    if (directions)
        change_targets(
            mesh,
            [&](MorphTarget& target, std::size_t t) {
                const Block<vec3>& normals = directions->normals[t];
                if (!normals.empty()) with_gaps(target.normals, [&](std::uint32_t v) { return normals[v]; });
            },
            context);
    return mesh;
}

}  // namespace

Mesh with_attributes(const Mesh& source, MeshAttributes&& attributes, bool new_normals, Context& context) {
    Mesh mesh = source;
    mesh.tangents = {}, mesh.bitangents = {};
    if (new_normals) mesh.normals = {};
    split_vertices(mesh, std::move(attributes.indices), attributes.source_vertex, context);
    if (new_normals) mesh.normals = std::move(attributes.normals);
    mesh.tangents = std::move(attributes.tangents);
    mesh.bitangents = std::move(attributes.bitangents);
    return mesh;
}

ResultPlacer::ResultPlacer(Scene& scene, const SmoothRequest& request, const SmoothSelection& selection,
                           const std::vector<std::uint32_t>& numbers, Context& context)
    : scene_(scene),
      request_(request),
      s_(selection),
      numbers_(numbers),
      context_(context),
      variants_(scene, context, request.keep_instances),
      uses_(scene.meshes.size(), 0) {
    for (const std::uint32_t number : numbers_) ++uses_[number];
    for (std::size_t i = 0; i < s_.instances.size(); ++i)
        if (const std::uint32_t mesh = s_.instances[i].mesh; mesh != numbers_[s_.result_of[i]]) ++uses_[mesh];
}

void ResultPlacer::place(Computed& computed) {
    std::vector<std::uint32_t> placed(computed.attributes.size(), no_index);  // the mesh that shows each result
    for (std::size_t i = 0; i < s_.instances.size(); ++i) {
        const std::size_t own = s_.result_of[i], r = computed.alike.empty() ? own : computed.alike[own];
        const std::uint32_t number = s_.instances[i].mesh;
        if (placed[r] != no_index && number == numbers_[r]) {
            variants_.share(s_.instances[i], placed[r]);
        } else if (placed[r] != no_index) {
            variants_.place(s_.instances[i], with_arrays_of(scene_.meshes[placed[r]], source(number)));
        } else {
            TargetDirections* const targets = computed.targets.empty() ? nullptr : &computed.targets[r];
            placed[r] = variants_.place(s_.instances[i], made_mesh(number, computed.attributes[r], targets));
        }
    }
}

Mesh ResultPlacer::made_mesh(std::uint32_t number, MeshAttributes& made, TargetDirections* targets) {
    const Mesh& from = source(number);
    const bool new_normals = request_.attributes.normals;
    if (new_normals && request_.only_missing && !from.normals.empty())
        return with_gaps_filled(from, std::move(made), targets, context_);
    if (!keeps_bitangents(from)) made.bitangents = {};
    Mesh mesh = with_attributes(from, std::move(made), new_normals, context_);
    if (targets || has_directions(from.targets, new_normals))
        set_target_directions(scene_, mesh, number, new_normals, targets, context_);
    return mesh;
}

bool ResultPlacer::has_directions(const Block<MorphTarget>& targets, bool with_normals) {
    const auto [known, is_new] = has_directions_.try_emplace(targets.identity(), false);
    if (is_new)
        known->second = std::ranges::any_of(targets, [&](const MorphTarget& target) {
            return (with_normals && !target.normals.empty()) || !target.tangents.empty();
        });
    return known->second;
}

bool ResultPlacer::keeps_bitangents(const Mesh& mesh) const {
    return request_.bitangents && mesh.targets.empty() && mesh.influences.empty();  // posing does not transform them
}

void ResultPlacer::report() const {
    if (variants_.kept() > 0)
        context_.report().add(Remark::warning, scene_.source, {},
                              format_text("{} instances that touch other things keep the normals of the first of their "
                                          "mesh: kept shared as asked",
                                          variants_.kept()));
    if (variants_.copies() > 0)
        context_.report().add(
            Remark::note, scene_.source, {},
            format_text("{} instances got a mesh of their own: their normals differ by what they touch",
                        variants_.copies()));
}

const Mesh& ResultPlacer::source(std::uint32_t number) {
    if (uses_[number] == 1) return scene_.meshes[number];
    return originals_.try_emplace(number, scene_.meshes[number]).first->second;
}

}  // namespace rakelight
