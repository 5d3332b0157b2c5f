// SPDX-License-Identifier: Apache-2.0
#include "bake/high/mapped_normals.h"

#include "bake/low/tangent_frame.h"
#include "scene/materials/material_conversion.h"

namespace rakelight::bake {

MappedNormals::MappedNormals(const Scene& scene, Context& context) : materials_(scene.materials) {
    MapChains chains(ColorSpace::linear);
    for (std::uint32_t i = 0; i < materials_.size(); ++i) {
        const Material& m = materials_[i];
        if (!m.normal_texture || bump_of(m, Bump::automatic) != Bump::normal) continue;
        const Texture& texture = scene.textures[m.normal_texture.texture];
        if (auto chain = chains.chain_of(texture, "a normal map", context))
            maps_.emplace(i, MapReader(std::move(chain), m.normal_texture, texture.sampler));
    }
}

dvec3 MappedNormals::at(const dmat4& to_world, const Mesh& mesh, std::uint32_t triangle, const double (&weight)[3],
                        dvec3 normal) const {
    const auto found = maps_.find(mesh.material);
    if (found == maps_.end() || mesh.tangents.empty()) return normal;
    const Material& m = materials_[mesh.material];
    const std::uint32_t set = m.normal_texture.texcoord_set;
    if (set >= mesh.texcoords.size() || mesh.texcoords[set].empty()) return normal;
    dvec2 uv{};
    dvec3 tangent{};
    double handedness = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.indices[3 * std::size_t(triangle) + k];
        const vec2 at = mesh.texcoords[set][v];
        const vec4 t = mesh.tangents[v];
        uv = uv + dvec2{double(at.x), double(at.y)} * weight[k];
        tangent = tangent + normalize_or(upper_left(to_world) * cast<double>(t.xyz()), dvec3{}) * weight[k];
        handedness = double(t.w);
    }
    if (determinant(upper_left(to_world)) < 0) handedness = -handedness;
    const dvec3 code = found->second(uv);
    dvec3 mapped = m.centered_normals ? (code * 255.0 - dvec3{128, 128, 128}) / 127.0 : code * 2.0 - dvec3{1, 1, 1};
    mapped = {mapped.x * double(m.normal_scale), mapped.y * double(m.normal_scale) * (m.green_down ? -1 : 1), mapped.z};
    const TangentFrame frame = unit_frame(normal, tangent, handedness);
    return normalize_or(frame.tangent * mapped.x + frame.bitangent * mapped.y + frame.normal * mapped.z, normal);
}

}  // namespace rakelight::bake
