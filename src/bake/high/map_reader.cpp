// SPDX-License-Identifier: Apache-2.0
#include "bake/high/map_reader.h"

#include <algorithm>
#include <cmath>

#include "image/decode.h"
#include "scene/materials/wrapped_texel.h"
#include "shading/materials.h"

namespace rakelight::bake {
namespace {

double in_range(double v) { return v > -1e5 && v < 1e5 ? v : 0; }

dvec3 color(const MipChain& chain, const MipLevel& level, int x, int y) {
    const std::size_t i = std::size_t(y) * std::size_t(level.width) + std::size_t(x);
    if (chain.is_float || chain.is_srgb) return cast<double>(linear_texel(chain, level, i));
    const std::uint32_t c = level.rgba8[i];
    return dvec3{double(c & 255u), double(c >> 8 & 255u), double(c >> 16 & 255u)} / 255.0;
}

}  // namespace

MapReader::MapReader(std::shared_ptr<const MipChain> chain, const TextureUse& use, const Sampler& sampler)
    : chain_(std::move(chain)),
      transform_(shading::uv_transform(use)),
      wrap_u_(sampler.wrap_u),
      wrap_v_(sampler.wrap_v),
      set_(use.texcoord_set) {}

dvec2 MapReader::place(dvec2 uv) const {
    const shading::UvTransform& t = transform_;
    return {in_range(double(t.uu) * uv.x + double(t.uv) * uv.y + double(t.u0)),
            in_range(double(t.vu) * uv.x + double(t.vv) * uv.y + double(t.v0))};
}

dvec3 MapReader::operator()(dvec2 uv, std::size_t number) const {
    const MipLevel& level = chain_->levels[std::min(number, chain_->levels.size() - 1)];
    const dvec2 at = place(uv);
    const double x = at.x * level.width - 0.5, y = at.y * level.height - 0.5;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    const auto read = [&](int column, int row) {
        return color(*chain_, level, wrapped_texel(column, level.width, wrap_u_),
                     wrapped_texel(row, level.height, wrap_v_));
    };
    const double tx = x - x0, ty = y - y0;
    const dvec3 upper = read(x0, y0) * (1 - tx) + read(x0 + 1, y0) * tx;
    const dvec3 lower = read(x0, y0 + 1) * (1 - tx) + read(x0 + 1, y0 + 1) * tx;
    return upper * (1 - ty) + lower * ty;
}

std::size_t MapReader::level_for(double texels) const {
    std::size_t level = 0;
    for (; texels > 2 && level + 1 < chain_->levels.size(); texels /= 4) ++level;
    return level;
}

std::shared_ptr<const MipChain> MapChains::chain_of(const Texture& texture, const char* what, Context& context) {
    const auto [entry, is_new] = chains_.try_emplace(texture.image.get());
    if (is_new) try {
            auto chain =
                std::make_shared<const MipChain>(make_mip_chain(decode(*texture.image, context), space_, context));
            if (!chain->levels.empty()) entry->second = std::move(chain);
        } catch (const Error& error) {
            context.throw_if_cancelled();
            context.report().add(Remark::warning, texture.image->file, texture.image->name,
                                 std::string(what) + " is left out: " + error.reason());
        }
    return entry->second;
}

}  // namespace rakelight::bake
