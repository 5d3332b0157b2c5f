// SPDX-License-Identifier: Apache-2.0
#include "prepare/normals/missing_normals.h"

#include <algorithm>
#include <set>

#include "geometry/input/face_vote.h"
#include "math/linear.h"
#include "prepare/variants.h"
#include "scene/charge_arrays.h"
#include "scene/is_normal.h"
#include "scene/validate_parts.h"

namespace rakelight {
namespace {

std::uint64_t count_used(std::size_t vertices, std::span<const std::uint32_t> indices) {
    std::vector<bool> is_used(vertices);
    for (const std::uint32_t v : indices) is_used[v] = true;
    return std::uint64_t(std::count(is_used.begin(), is_used.end(), true));
}

}  // namespace

NormalGaps normal_gaps(std::span<const vec3> normals, std::span<const std::uint32_t> indices) {
    NormalGaps gaps;
    if (std::all_of(normals.begin(), normals.end(), is_normal)) return gaps;
    gaps.at.assign(normals.size(), 0);
    bool has_normals = false;
    for (const std::uint32_t v : indices) {
        if (is_normal(normals[v]))
            has_normals = true;
        else if (gaps.at[v] == 0)
            gaps.at[v] = 1, ++gaps.count;
    }
    gaps.is_all = gaps.count > 0 && !has_normals;
    if (gaps.count == 0) gaps.at.clear();
    return gaps;
}

NormalGaps normal_gaps(const Mesh& mesh) { return normal_gaps(mesh.normals, mesh.indices); }

std::uint64_t count_missing_normals(const Scene& scene) {
    std::set<std::uint32_t> drawn;
    for (const Instance& instance : drawn_instances(scene)) drawn.insert(instance.mesh);
    std::uint64_t count = 0;
    for (const std::uint32_t m : drawn) {
        const Mesh& mesh = scene.meshes[m];
        count += mesh.normals.empty() ? count_used(mesh.positions.size(), mesh.indices) : normal_gaps(mesh).count;
    }
    return count;
}

bool lacks_normals(const Mesh& mesh) { return mesh.normals.empty() || normal_gaps(mesh).count > 0; }

NormalGaps drop_if_all_gaps(Mesh& mesh, std::vector<Finding>& findings) {
    NormalGaps gaps = normal_gaps(mesh);
    if (gaps.is_all) {
        findings.push_back({Remark::warning, "the normals are all zero or not finite: computed instead"});
        mesh.normals = {};
    } else if (gaps.count > 0) {
        findings.push_back({Remark::warning, "normals that are zero or not finite were replaced by computed ones"});
    }
    return gaps;
}

std::optional<Scene> without_useless_normals(const Scene& scene, Context& context) {
    std::optional<Scene> out;
    std::vector<bool> seen(scene.meshes.size(), false);
    for (const Instance& instance : drawn_instances(scene)) {
        const std::uint32_t number = instance.mesh;
        if (seen[number] || scene.meshes[number].normals.empty()) continue;
        seen[number] = true;
        if (normal_gaps(scene.meshes[number]).count == 0) continue;
        Mesh mesh = scene.meshes[number];
        std::vector<Finding> findings;
        drop_if_all_gaps(mesh, findings);
        for (const Finding& f : findings)
            context.report().add(f.remark, scene.source, Place{"mesh", number, mesh.name}.text(), f.message);
        if (!mesh.normals.empty()) continue;
        if (!out) out = charged_copy(scene, context);
        out->meshes[number] = std::move(mesh);
    }
    return out;
}

Block<std::uint8_t> authored_locks(std::span<const vec3> normals) {
    std::vector<std::uint8_t> locks;
    locks.reserve(normals.size());
    for (const vec3 n : normals) locks.push_back(is_normal(n) ? geometry::authored_lock : 0);
    return locks;
}

}  // namespace rakelight
