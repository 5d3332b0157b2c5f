// SPDX-License-Identifier: Apache-2.0
#include "prepare/bound_sides.h"

#include "math/linear.h"
#include "prepare/normals/bind_pose.h"
#include "prepare/variants.h"

namespace rakelight {

std::shared_ptr<const std::vector<geometry::NormalSides>> bound_sides(const Scene& scene, Context& context) {
    const auto is_asked = [&](const Mesh& mesh) {
        return !mesh.normals.empty() && mesh.material != no_index &&
               scene.materials[mesh.material].model == MaterialModel::classical;
    };
    std::vector<AttributeMesh> meshes;
    std::vector<std::uint32_t> numbers;
    std::vector<bool> seen(scene.meshes.size(), false);
    const std::vector<dmat4> place = bind_pose_matrices(scene);
    for (const Instance& i : drawn_instances(scene)) {  // at the first instance of each mesh
        const Mesh& mesh = scene.meshes[i.mesh];
        if (seen[i.mesh] || !is_asked(mesh)) continue;
        seen[i.mesh] = true;
        numbers.push_back(i.mesh);
        AttributeMesh& m = meshes.emplace_back();
        m.positions = mesh.positions, m.indices = mesh.indices, m.normals = mesh.normals;
        m.to_world = place[i.node] * translation(mesh.origin);
    }
    if (meshes.empty()) return nullptr;
    std::vector<geometry::NormalSides> found = geometry::find_normal_sides(meshes, context);
    auto sides = std::make_shared<std::vector<geometry::NormalSides>>(scene.meshes.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) (*sides)[numbers[i]] = std::move(found[i]);
    return sides;
}

}  // namespace rakelight
