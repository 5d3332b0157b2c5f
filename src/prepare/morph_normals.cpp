// SPDX-License-Identifier: Apache-2.0
#include "prepare/morph_normals.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "geometry/mesh_islands.h"
#include "math/linear.h"

namespace rakelight {
namespace {

/// Targets by name and occurrence within a mesh, in the order of first appearance.
std::vector<MorphPose> movements_of(const Scene& scene, std::span<const std::uint32_t> numbers) {
    std::vector<MorphPose> movements;
    std::map<std::pair<std::string, std::size_t>, std::size_t> known;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Mesh& mesh = scene.meshes[numbers[i]];
        std::map<std::string, std::size_t> before;
        for (std::size_t t = 0; t < mesh.targets.size(); ++t) {
            const MorphTarget& target = mesh.targets[t];
            const std::size_t occurrence = before[target.name]++;
            if (!wants_normals(mesh, target)) continue;
            const auto [at, is_new] = known.try_emplace({target.name, occurrence}, movements.size());
            if (is_new) movements.emplace_back();
            movements[at->second].targets.emplace_back(i, t);
        }
    }
    return movements;
}

std::vector<vec3> moved(const Block<vec3>& vectors, const Block<vec3>& offsets) {
    std::vector<vec3> result;
    result.reserve(vectors.size());
    for (std::size_t v = 0; v < vectors.size(); ++v) result.push_back(vectors[v] + offsets[v]);
    return result;
}

template <class T>
std::vector<vec3> difference(const std::vector<T>& to, const std::vector<T>& from) {
    std::vector<vec3> result;
    result.reserve(to.size());
    for (std::size_t v = 0; v < to.size(); ++v)
        result.push_back({to[v].x - from[v].x, to[v].y - from[v].y, to[v].z - from[v].z});
    return result;
}

void check_memory(const std::vector<MorphPose>& poses, std::span<const MeshAttributes> base, Context& context) {
    std::uint64_t bytes = 0;
    for (const MorphPose& movement : poses)
        for (const auto& [i, t] : movement.targets) bytes += 2 * sizeof(vec3) * std::uint64_t(base[i].normals.size());
    context.memory().check(bytes, "normals of morph targets");
}

}  // namespace

bool wants_normals(const Mesh& mesh, const MorphTarget& target) {
    return !target.positions.empty() && (!target.normals.empty() || mesh.normals.empty());
}

std::vector<MorphPose> morph_poses(const Scene& scene, std::span<const std::uint32_t> numbers,
                                   std::span<const std::uint32_t> islands) {
    std::vector<MorphPose> poses;
    std::vector<std::size_t> next(numbers.size(), 0);  // [islands] the first pose without movement in the island
    for (const MorphPose& movement : movements_of(scene, numbers)) {
        std::size_t pose = 0;
        for (const auto& [i, t] : movement.targets) pose = std::max(pose, next[islands[i]]);
        for (const auto& [i, t] : movement.targets) next[islands[i]] = pose + 1;
        if (pose == poses.size()) poses.emplace_back();
        poses[pose].targets.insert(poses[pose].targets.end(), movement.targets.begin(), movement.targets.end());
    }
    return poses;
}

std::vector<TargetDirections> target_directions(const Scene& scene, std::span<const std::uint32_t> numbers,
                                                std::span<const AttributeMesh> meshes, const AttributePlan& plan,
                                                std::span<const MeshAttributes> base, Context& context) {
    std::vector<TargetDirections> result(meshes.size());
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        result[i].normals.resize(scene.meshes[numbers[i]].targets.size());
        result[i].tangents.resize(scene.meshes[numbers[i]].targets.size());
    }
    const std::vector<MorphPose> poses = morph_poses(scene, numbers, geometry::mesh_islands(plan));
    check_memory(poses, base, context);
    for (const MorphPose& movement : poses) {
        context.throw_if_cancelled();
        std::vector<AttributeMesh> pose(meshes.begin(), meshes.end());
        std::vector<std::vector<vec3>> moved_arrays;
        moved_arrays.reserve(2 * movement.targets.size());  // the spans point into it
        for (const auto& [i, t] : movement.targets) {
            const Mesh& mesh = scene.meshes[numbers[i]];
            pose[i].positions = moved_arrays.emplace_back(moved(mesh.positions, mesh.targets[t].positions));
            if (!pose[i].locked.empty() && !mesh.targets[t].normals.empty())
                pose[i].normals = moved_arrays.emplace_back(moved(mesh.normals, mesh.targets[t].normals));
        }
        const std::vector<MeshAttributes> posed = accumulate(plan, pose, context);
        for (const auto& [i, t] : movement.targets) {
            result[i].normals[t] = difference(posed[i].normals, base[i].normals);
            if (!scene.meshes[numbers[i]].targets[t].tangents.empty() && !posed[i].tangents.empty())
                result[i].tangents[t] = difference(posed[i].tangents, base[i].tangents);
        }
    }
    return result;
}

}  // namespace rakelight
