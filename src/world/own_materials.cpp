// SPDX-License-Identifier: Apache-2.0
#include "world/own_materials.h"

namespace rakelight {

void OwnMaterials::take_own(std::uint32_t& mesh) {
    const std::uint32_t material = scene_.meshes[mesh].material;
    const std::size_t names = scene_.meshes[mesh].name.size() + scene_.materials[material].name.size();
    charge_.grow(sizeof(Mesh) + sizeof(Material) + names, "the materials of single objects");
    Mesh copy = scene_.meshes[mesh];
    copy.material = std::uint32_t(scene_.materials.size());
    scene_.materials.push_back(Material(scene_.materials[material]));
    mesh = std::uint32_t(scene_.meshes.size());
    scene_.meshes.push_back(std::move(copy));
}

std::vector<std::uint32_t> OwnMaterials::of(std::uint32_t node, const std::string& name) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t& mesh : scene_.nodes[node].meshes) {
        const std::uint32_t material = scene_.meshes[mesh].material;
        if (material == no_index || (name != "*" && scene_.materials[material].name != name)) continue;
        if (material < first_own_) take_own(mesh);
        found.push_back(scene_.meshes[mesh].material);
    }
    return found;
}

void OwnMaterials::finish() {
    if (charge_.bytes() > 0) scene_.charges.push_back(share(std::move(charge_)));
}

}  // namespace rakelight
