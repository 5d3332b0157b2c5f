// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_changes.h"

#include <algorithm>
#include <cmath>

#include "io/same_attributes.h"

namespace rakelight::io::gltf {
namespace {

/// What is there is what would be written.
bool is_stored(float there, float made, ComponentType type) { return there == stored_value(made, type); }

/// What is there differs from what was computed by the rounding of sums in another order, or of numbers to their codes.
bool is_stored_to_rounding(float there, float made, ComponentType type) {
    return std::fabs(double(there) - double(made)) <= rounding + half_step(type);
}

/// Arrays that are one are the same, whatever their type.
template <class T, class Same>
bool all_same(const Block<T>& there, const Block<T>& made, ComponentType type, Same same) {
    const auto each = [&](const T& x, const T& y) {
        for (std::size_t c = 0; c < sizeof(T) / sizeof(float); ++c)
            if (!same((&x.x)[c], (&y.x)[c], type)) return false;
        return true;
    };
    return there == made || std::equal(there.begin(), there.end(), made.begin(), made.end(), each);
}

/// Those that are to be written, if any are, are among the numbers of the file's vertices, except for rounding.
bool has_bitangents_of(const Mesh& there, const Mesh& made) {
    if (made.bitangents.empty()) return true;
    for (const VertexArray& array : there.arrays)
        if (array.name == name_of(Direction::bitangent) && array.values.size() == 3 * made.bitangents.size())
            return std::equal(array.values.begin(), array.values.end(), &made.bitangents[0].x,
                              [](float p, float q) { return std::fabs(double(p) - double(q)) <= rounding; });
    return false;
}

/// Offsets that are not new are the file's own, or there are none.
template <class Same>
bool same_targets(const Mesh& there, const Mesh& made, const std::vector<DirectionTypes>& types, Same same) {
    for (std::size_t t = 0; t < std::min(there.targets.size(), made.targets.size()); ++t) {
        const MorphTarget &x = there.targets[t], &y = made.targets[t];
        if (!y.normals.empty() && !all_same(x.normals, y.normals, types[t][Direction::normal], same)) return false;
        if (!y.tangents.empty() && !all_same(x.tangents, y.tangents, types[t][Direction::tangent], same)) return false;
    }
    return true;
}

/// @param same  is_stored() or is_stored_to_rounding()
template <class Same>
bool is_same(std::uint32_t mesh, const Mesh& there, const Mesh& made, const DirectionStorage& storage, Same same) {
    const StoredDirections& stored = storage.stored(mesh);
    const auto type = [&](Direction direction) {
        return storage.is_kept(mesh, direction) ? stored.own[direction] : ComponentType::f32;
    };
    return same_corners(there, made) && all_same(there.normals, made.normals, type(Direction::normal), same) &&
           all_same(there.tangents, made.tangents, type(Direction::tangent), same) && has_bitangents_of(there, made) &&
           same_targets(there, made, stored.targets, same);
}

/// For each vertex of `after` beyond those of `before`, the vertex that it copies; found by the corners.
std::vector<std::uint32_t> copied_vertices(const Mesh& before, const Mesh& after) {
    const std::size_t old_count = before.positions.size();
    std::vector<std::uint32_t> copied(after.positions.size() - old_count, 0);
    for (std::size_t c = 0; c < after.indices.size(); ++c)
        if (after.indices[c] >= old_count) copied[after.indices[c] - old_count] = before.indices[c];
    return copied;
}

std::vector<MorphTarget> new_targets(const Mesh& before, const Mesh& after) {
    std::vector<MorphTarget> targets(after.targets.begin(), after.targets.end());
    for (std::size_t t = 0; t < std::min(targets.size(), before.targets.size()); ++t) {
        if (targets[t].normals == before.targets[t].normals) targets[t].normals = {};
        if (targets[t].tangents == before.targets[t].tangents) targets[t].tangents = {};
    }
    return targets;
}

}  // namespace

SceneChanges find_changes(const Scene& before, const Scene& after, const DirectionStorage& storage, bool keep_instances,
                          Context& context) {
    SceneChanges changes{.versions = mesh_versions(before, after, keep_instances, context),
                         .origin = origins(before, after),
                         .changed = std::vector<bool>(after.meshes.size(), false)};
    for (const MeshVersion& version : changes.versions) {
        ++changes.versions_of[version.source_mesh];
        changes.any = changes.any || !version.in_place;
        for (const std::uint32_t m : version.meshes) {
            const std::uint32_t was = changes.origin[m];
            const Mesh &there = before.meshes[was], &made = after.meshes[m];
            if (made.topology != Topology::triangles || made.normals.empty()) continue;
            changes.changed[m] = !is_same(was, there, made, storage, is_stored);
            changes.any = changes.any || !is_same(was, there, made, storage, is_stored_to_rounding);
        }
    }
    return changes;
}

PrimitiveChange change_of(std::uint32_t mesh, const Mesh& before, const Mesh& after, const DirectionStorage& storage) {
    const DirectionTypes stored = storage.stored(mesh).own;
    PrimitiveChange change{.copied = copied_vertices(before, after),
                           .targets = new_targets(before, after),
                           .types = storage.wanted(mesh),
                           .corners = !std::ranges::equal(before.indices, after.indices),
                           .tangents_removed = after.tangents.empty() && !before.tangents.empty()};
    const auto is_widened = [&](Direction direction) { return change.types[direction] != stored[direction]; };
    change.widened = is_widened(Direction::normal) || (!after.tangents.empty() && is_widened(Direction::tangent)) ||
                     (!after.bitangents.empty() && is_widened(Direction::bitangent));
    for (std::size_t t = 0; t < std::min(before.targets.size(), change.targets.size()); ++t)
        change.keeps_target_normals =
            change.keeps_target_normals || (!before.targets[t].normals.empty() && change.targets[t].normals.empty());
    return change;
}

void report_change(const PrimitiveChange& change, const std::string& source, const std::string& place, Report& report) {
    if (change.tangents_removed)
        report.add(Remark::dropped, source, place,
                   "tangents that belong to the old normals were removed (not wanted, or there are no texture "
                   "coordinates to compute new ones from)");
    if (change.keeps_target_normals)
        report.add(Remark::warning, source, place,
                   "the normals of morph targets are kept: they are offsets from the old normals");
    if (change.widened)
        report.add(Remark::changed, source, place,
                   "8-bit normals or tangents were converted to float: neighbors that are stored or rotated "
                   "otherwise would differ by a rounding step");
}

}  // namespace rakelight::io::gltf
