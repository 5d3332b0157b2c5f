// SPDX-License-Identifier: Apache-2.0
#include "io/vertex_colors.h"

namespace rakelight::io {
namespace {

/// k_a of classical materials is k_d where the file does not give it.
void make_white(Material& m) {
    const vec3 invented = m.base_color.xyz(), white{1, 1, 1};
    m.base_color = {1, 1, 1, m.base_color.w};
    if (m.classical.ambient == invented) m.classical.ambient = white;
}

struct Users {
    bool with_colors = false, without = false;
    std::uint32_t white = no_index;  ///< the material of those with colors
};

}  // namespace

void show_vertex_colors(Scene& scene, const std::vector<bool>& is_invented, Context& context) {
    std::vector<Users> users(is_invented.size());
    const auto users_of = [&](const Mesh& mesh) -> Users* {
        return mesh.material < is_invented.size() && is_invented[mesh.material] ? &users[mesh.material] : nullptr;
    };
    for (const Mesh& mesh : scene.meshes)
        if (Users* u = users_of(mesh)) (mesh.colors.empty() ? u->without : u->with_colors) = true;
    MemoryCharge charge(context.memory());
    for (std::uint32_t m = 0; m < users.size(); ++m) {
        if (!users[m].with_colors) continue;
        users[m].white = m;
        if (users[m].without) {
            charge.grow(sizeof(Material) + scene.materials[m].name.size(), "the materials of vertex colors");
            users[m].white = std::uint32_t(scene.materials.size());
            scene.materials.push_back(Material(scene.materials[m]));
        }
        make_white(scene.materials[users[m].white]);
    }
    for (Mesh& mesh : scene.meshes)
        if (const Users* u = users_of(mesh); u && !mesh.colors.empty()) mesh.material = u->white;
    scene.charges.push_back(share(std::move(charge)));
}

}  // namespace rakelight::io
