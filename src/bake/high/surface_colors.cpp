// SPDX-License-Identifier: Apache-2.0
#include "bake/high/surface_colors.h"

#include <cmath>

namespace rakelight::bake {
namespace {

dvec3 texture_color(const MapReader& map, const Block<vec2>& coordinates, const std::uint32_t* corner,
                    const double (&weight)[3], double samples) {
    dvec2 uv{}, place[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const dvec2 at{double(coordinates[corner[k]].x), double(coordinates[corner[k]].y)};
        uv = uv + at * weight[k];
        place[k] = map.place(at);
    }
    const dvec2 a = place[1] - place[0], b = place[2] - place[0];
    const double texels = 0.5 * std::fabs(a.x * b.y - a.y * b.x) * map.width() * map.height();
    return map(uv, map.level_for(texels / samples));
}

}  // namespace

SurfaceColors::SurfaceColors(const Scene& scene, Context& context) : materials_(scene.materials) {
    MapChains chains(ColorSpace::srgb);
    for (std::uint32_t i = 0; i < materials_.size(); ++i) {
        const TextureUse& use = materials_[i].base_color_texture;
        if (!use) continue;
        const Texture& texture = scene.textures[use.texture];
        if (auto chain = chains.chain_of(texture, "a picture", context))
            maps_.emplace(i, MapReader(std::move(chain), use, texture.sampler));
    }
}

dvec3 SurfaceColors::at(const Mesh& mesh, const std::uint32_t* corner, const double (&weight)[3],
                        double samples) const {
    dvec3 color = cast<double>(materials_[mesh.material].base_color.xyz());
    if (const auto map = maps_.find(mesh.material); map != maps_.end()) {
        const std::uint32_t set = map->second.texcoord_set();
        if (set < mesh.texcoords.size() && !mesh.texcoords[set].empty())
            color = color * texture_color(map->second, mesh.texcoords[set], corner, weight, samples);
    }
    if (mesh.colors.empty()) return color;
    dvec3 paint{};
    for (std::size_t k = 0; k < 3; ++k) paint = paint + cast<double>(mesh.colors[corner[k]].xyz()) * weight[k];
    return color * paint;
}

}  // namespace rakelight::bake
