// SPDX-License-Identifier: Apache-2.0
#include "prepare/moving_placements.h"

#include <rakelight/prepare/prepare.h>

namespace rakelight {

bool follows_skin(const Scene& scene, const Node& node, const Mesh& mesh) {
    return node.skin != no_index && !mesh.influences.empty() && !scene.skins[node.skin].joints.empty();
}

std::vector<Instance> moving_placements(const Scene& scene) {
    std::vector<Instance> moving;
    for (std::uint32_t n = 0; n < scene.nodes.size(); ++n) {
        const Node& node = scene.nodes[n];
        for (std::uint32_t slot = 0; slot < node.meshes.size(); ++slot) {
            const Mesh& mesh = scene.meshes[node.meshes[slot]];
            if (!mesh.targets.empty() || follows_skin(scene, node, mesh))
                moving.push_back({n, slot, node.meshes[slot]});
        }
    }
    return moving;
}

bool is_posable(const Scene& scene) {
    if (scene.pose || !scene.skins.empty() || !scene.animations.empty()) return true;
    for (const Mesh& mesh : scene.meshes)
        if (!mesh.targets.empty() || !mesh.influences.empty()) return true;
    return false;
}

Scene with_own_meshes(Scene scene, Context& context) {
    const std::vector<Instance> moving = moving_placements(scene);
    if (moving.empty()) return scene;
    std::vector<std::uint32_t> uses(scene.meshes.size(), 0);
    for (const Node& node : scene.nodes)
        for (const std::uint32_t mesh : node.meshes) ++uses[mesh];
    AddedMeshes added(scene, context);
    for (const Instance& i : moving) {
        if (uses[i.mesh] == 1) continue;
        --uses[i.mesh];  // the last one keeps it
        const std::uint32_t own = added.add(scene.meshes[i.mesh]);
        scene.nodes[i.node].meshes[i.slot] = own;
    }
    return scene;
}

}  // namespace rakelight
