// SPDX-License-Identifier: Apache-2.0
#include "prepare/normals/tangent_coordinates.h"

#include "scene/materials/material_conversion.h"
#include "scene/materials/material_table.h"

namespace rakelight {

TangentCoordinates tangent_coordinates(const Scene& scene, const Mesh& mesh, TangentNeed need) {
    if (need == TangentNeed::none) return {};
    if (mesh.material != no_index) {
        const Material& m = scene.materials[mesh.material];
        if (const TextureUse* const use = tangent_texture(m)) {
            if (!has_coordinates(mesh, use->texcoord_set)) return {};
            return {use->texcoord_set, uv_matrix(use->transform)};
        }
        if (needs_tangents(m)) need = TangentNeed::everywhere;
    }
    if (need == TangentNeed::everywhere)
        for (std::uint32_t set = 0; set < mesh.texcoords.size(); ++set)
            if (has_coordinates(mesh, set)) return {set, {}};
    return {};
}

Block<vec2> tangent_texcoords(const Mesh& mesh, const TangentCoordinates& coordinates) {
    if (!coordinates.exist()) return {};
    const Block<vec2>& set = mesh.texcoords[coordinates.set];
    if (coordinates.matrix == UvMatrix{}) return set;
    std::vector<vec2> values;
    values.reserve(set.size());
    for (const vec2 uv : set) {
        const dvec2 at = coordinates.matrix * dvec2{double(uv.x), double(uv.y)};
        values.push_back({float(at.x), float(at.y)});
    }
    return values;
}

}  // namespace rakelight
