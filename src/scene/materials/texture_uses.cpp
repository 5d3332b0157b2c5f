// SPDX-License-Identifier: Apache-2.0
#include "scene/materials/texture_uses.h"

#include <rakelight/base/report.h>

#include <algorithm>

#include "scene/materials/material_table.h"

namespace rakelight {

void for_each_texture_use(Material& m, const std::function<void(TextureUse&)>& f) {
    for (const TextureRole& role : texture_roles()) f(role.in(m));
}

void drop_emission(Material& m, Report& report, const std::string& file, const std::string& place) {
    m.emission_texture = {};
    if (m.emission == vec3{0, 0, 0}) return;
    m.emission = {0, 0, 0};
    report.add(Remark::dropped, file, place, "the emission texture is missing: there is no emission");
}

void name_default_material(Scene& scene) {
    const auto has_none = [](const Mesh& m) { return m.material == no_index; };
    if (std::none_of(scene.meshes.begin(), scene.meshes.end(), has_none)) return;
    scene.materials.emplace_back().name = "default";
    for (Mesh& mesh : scene.meshes)
        if (has_none(mesh)) mesh.material = std::uint32_t(scene.materials.size() - 1);
}

}  // namespace rakelight
