// SPDX-License-Identifier: Apache-2.0
#include "radiosity/mean_colors.h"

#include <algorithm>

#include "image/decode.h"
#include "image/maps/mip_chain.h"
#include "math/linear.h"
#include "shading/materials.h"

namespace rakelight::radiosity {
namespace {

bool has_coordinates(const Mesh& mesh, const TextureUse& use) {
    return use.texcoord_set < mesh.texcoords.size() && !mesh.texcoords[use.texcoord_set].empty();
}

}  // namespace

ColorMaps::ColorMaps(const Scene& scene, const std::vector<bool>& is_used, Context& context)
    : charge_(context.memory()) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (!is_used[i]) continue;
        const Material& m = scene.materials[i];
        add(scene, m.base_color_texture, ColorSpace::srgb, context);
        add(scene, m.emission_texture, ColorSpace::srgb, context);
        if (m.model == MaterialModel::metallic_roughness)
            for (const TextureUse& use : {m.metallic_roughness.texture, m.metallic_roughness.transmission_texture})
                add(scene, use, ColorSpace::linear, context);
    }
}

void ColorMaps::add(const Scene& scene, const TextureUse& use, ColorSpace space, Context& context) {
    if (!use || maps_.contains(use.texture)) return;
    const Texture& texture = scene.textures[use.texture];
    try {
        const MipChain chain = make_mip_chain(decode(*texture.image, context), space, context);
        if (chain.levels.empty()) return;
        charge_.grow(shading::MeanMap::bytes_for(chain.levels[0].width, chain.levels[0].height),
                     "the means of a texture");
        maps_.emplace(use.texture, Map{shading::MeanMap(chain), texture.sampler});
    } catch (const Error&) {
        context.throw_if_cancelled();
    }
}

double ColorMaps::diffuse_share(const Material& m, const Mesh& mesh, const std::uint32_t* corner) const {
    if (m.model != MaterialModel::metallic_roughness) return 1;
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    const double metallic = double(p.metallic) * mean(p.texture, mesh, corner).z;
    const double transmission = double(p.transmission) * mean(p.transmission_texture, mesh, corner).x;
    return (1 - metallic) * (1 - transmission);
}

dvec3 ColorMaps::mean(const TextureUse& use, const Mesh& mesh, const std::uint32_t* corner) const {
    const auto found = use ? maps_.find(use.texture) : maps_.end();
    if (found == maps_.end()) return {1, 1, 1};
    const shading::UvTransform t = shading::uv_transform(use);
    shading::UvBox box;
    for (std::size_t k = 0; k < 3; ++k) {
        const vec2 uv = has_coordinates(mesh, use) ? mesh.texcoords[use.texcoord_set][corner[k]] : vec2{0, 0};
        const vec2 at{t.uu * uv.x + t.uv * uv.y + t.u0, t.vu * uv.x + t.vv * uv.y + t.v0};
        box.low = k == 0 ? at : vec2{std::min(box.low.x, at.x), std::min(box.low.y, at.y)};
        box.high = k == 0 ? at : vec2{std::max(box.high.x, at.x), std::max(box.high.y, at.y)};
    }
    return found->second.means.mean(box, found->second.sampler.wrap_u, found->second.sampler.wrap_v);
}

}  // namespace rakelight::radiosity
