// SPDX-License-Identifier: Apache-2.0
#include "prepare/normals/morph_normals.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "geometry/faults/mesh_islands.h"
#include "math/linear.h"
#include "scene/charge_arrays.h"

namespace rakelight {
namespace {

/// Numbers of movements: targets by name and occurrence within a mesh, in the order of first appearance.
class MovementNumbers {
public:
    /// [targets] no_index: it gets no normals. Meshes that share a table of targets are looked at once.
    const std::vector<std::uint32_t>& of(const Mesh& mesh) {
        const auto [known, is_new] = tables_.try_emplace({mesh.targets.identity(), mesh.normals.empty()});
        std::vector<std::uint32_t>& numbers = known->second;
        if (!is_new) return numbers;
        std::map<std::string, std::size_t> before;
        for (const MorphTarget& target : mesh.targets) {
            const std::size_t occurrence = before[target.name]++;
            if (wants_normals(mesh, target))
                numbers.push_back(numbers_.try_emplace({target.name, occurrence}, count()).first->second);
            else
                numbers.push_back(no_index);
        }
        return numbers;
    }
    std::uint32_t count() const { return std::uint32_t(numbers_.size()); }

private:
    std::map<std::pair<const void*, bool>, std::vector<std::uint32_t>> tables_;
    std::map<std::pair<std::string, std::size_t>, std::uint32_t> numbers_;
};

std::vector<MorphPose> movements_of(const Scene& scene, std::span<const std::uint32_t> numbers) {
    std::vector<MorphPose> movements;
    MovementNumbers known;
    for (std::uint32_t i = 0; i < numbers.size(); ++i) {
        const std::vector<std::uint32_t>& of_targets = known.of(scene.meshes[numbers[i]]);
        movements.resize(known.count());
        for (std::uint32_t t = 0; t < of_targets.size(); ++t)
            if (of_targets[t] != no_index) movements[of_targets[t]].targets.emplace_back(i, t);
    }
    return movements;
}

std::vector<vec3> moved(const Block<vec3>& vectors, const Block<vec3>& offsets) {
    std::vector<vec3> result;
    result.reserve(vectors.size());
    for (std::size_t v = 0; v < vectors.size(); ++v) result.push_back(vectors[v] + offsets[v]);
    return result;
}

/// Differences of directions as charged arrays.
class Differences {
public:
    explicit Differences(Context& context) : memory_(context.memory()) {}

    template <class T>
    Block<vec3> between(const std::vector<T>& to, const std::vector<T>& from) {
        const auto turn = [&](std::size_t v) {
            return vec3{to[v].x - from[v].x, to[v].y - from[v].y, to[v].z - from[v].z};
        };
        std::size_t v = 0;
        while (v < to.size() && turn(v) == vec3{0, 0, 0}) ++v;
        if (v == to.size()) return zeros(to.size());
        MemoryCharge charge = charge_of(to.size());
        std::vector<vec3> result(to.size());
        for (std::size_t k = v; k < to.size(); ++k) result[k] = turn(k);
        return {std::move(result), std::move(charge)};
    }

private:
    MemoryCharge charge_of(std::size_t vertices) {
        return {memory_, vertices * sizeof(vec3) + bytes_beside_array, "normals of morph targets"};
    }
    const Block<vec3>& zeros(std::size_t vertices) {
        Block<vec3>& known = zeros_[vertices];
        if (known.empty()) known = {std::vector<vec3>(vertices), charge_of(vertices)};
        return known;
    }

    MemoryBudget& memory_;
    std::map<std::size_t, Block<vec3>> zeros_;  ///< by their number
};

/// [meshes] Tables without arrays. What is made of them is checked here, too: a table of targets for each mesh.
std::vector<TargetDirections> empty_tables(const Scene& scene, std::span<const std::uint32_t> numbers,
                                           Context& context) {
    std::uint64_t targets = 0;
    for (const std::uint32_t number : numbers) targets += scene.meshes[number].targets.size();
    constexpr std::uint64_t each = 2 * sizeof(MorphPose::targets[0]) + 2 * sizeof(Block<vec3>) + sizeof(MorphTarget);
    context.memory().check(targets * each, "normals of morph targets");
    std::vector<TargetDirections> tables(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        tables[i].normals.resize(scene.meshes[numbers[i]].targets.size());
        tables[i].tangents.resize(scene.meshes[numbers[i]].targets.size());
    }
    return tables;
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

namespace {

/// All of `in`, in their order.
std::vector<TargetDirections> all_directions(const Scene& scene, const MorphInputs& in, const AttributePlan& plan,
                                             std::span<const MeshAttributes> base, Context& context) {
    std::vector<TargetDirections> result = empty_tables(scene, in.numbers, context);
    Differences differences(context);
    for (const MorphPose& movement : morph_poses(scene, in.numbers, geometry::mesh_islands(plan))) {
        context.throw_if_cancelled();
        std::vector<AttributeMesh> pose(in.meshes.begin(), in.meshes.end());
        std::vector<std::vector<vec3>> moved_arrays;
        moved_arrays.reserve(2 * movement.targets.size());  // the spans point into it
        for (const auto& [i, t] : movement.targets) {
            const Mesh& mesh = scene.meshes[in.numbers[i]];
            pose[i].positions = moved_arrays.emplace_back(moved(mesh.positions, mesh.targets[t].positions));
            if (!pose[i].locked.empty() && !mesh.targets[t].normals.empty())
                pose[i].normals = moved_arrays.emplace_back(moved(mesh.normals, mesh.targets[t].normals));
        }
        const std::vector<MeshAttributes> posed = accumulate(plan, pose, context);
        for (const auto& [i, t] : movement.targets) {
            result[i].normals[t] = differences.between(posed[i].normals, base[i].normals);
            if (!scene.meshes[in.numbers[i]].targets[t].tangents.empty() && !posed[i].tangents.empty())
                result[i].tangents[t] = differences.between(posed[i].tangents, base[i].tangents);
        }
    }
    return result;
}

/// Inputs in an island with a result that is the first of its kind.
std::vector<std::size_t> inputs_needed(const MorphInputs& in, const AttributePlan& plan) {
    const std::vector<std::uint32_t> islands = geometry::mesh_islands(plan);
    std::vector<bool> is_needed(islands.size(), false);
    for (std::size_t r = 0; r < in.alike.size(); ++r)
        if (in.alike[r] == r) is_needed[islands[r]] = true;
    std::vector<std::size_t> needed;
    for (std::size_t i = 0; i < islands.size(); ++i)
        if (is_needed[islands[i]]) needed.push_back(i);
    return needed;
}

}  // namespace

std::vector<TargetDirections> target_directions(const Scene& scene, const MorphInputs& in, const AttributePlan& plan,
                                                std::span<const MeshAttributes> base, Context& context) {
    const std::vector<std::size_t> needed = inputs_needed(in, plan);
    if (needed.size() == in.meshes.size()) return all_directions(scene, in, plan, base, context);
    std::vector<std::uint32_t> numbers;
    std::vector<AttributeMesh> meshes;
    for (const std::size_t i : needed) numbers.push_back(in.numbers[i]), meshes.push_back(in.meshes[i]);
    const AttributePlan own = group(meshes, in.options, context);
    const std::vector<MeshAttributes> own_base = accumulate(own, meshes, context);
    for (std::size_t k = 0; k < needed.size(); ++k)
        if (own_base[k].source_vertex != base[needed[k]].source_vertex ||
            own_base[k].indices != base[needed[k]].indices)  // the rounding of those left out had joined or parted some
            return all_directions(scene, in, plan, base, context);
    std::vector<TargetDirections> some =
        all_directions(scene, {numbers, meshes, in.options, {}}, own, own_base, context);
    std::vector<TargetDirections> result(in.meshes.size());
    for (std::size_t k = 0; k < needed.size(); ++k) result[needed[k]] = std::move(some[k]);
    return result;
}

}  // namespace rakelight
