// SPDX-License-Identifier: Apache-2.0
#include "prepare/refine/height_field.h"

#include <algorithm>
#include <cmath>

#include "image/decode.h"
#include "math/functions.h"
#include "scene/materials/wrapped_texel.h"

namespace rakelight {
namespace {

float texel(const MipChain& chain, const MipLevel& level, int x, int y) {
    const std::size_t i = std::size_t(y) * std::size_t(level.width) + std::size_t(x);
    return chain.is_float ? level.rgba32f[i].x : float(level.rgba8[i] & 255u) / 255.0f;
}

/// Clamps texture coordinates of a file to a range with valid texel indices.
float in_range(float v) { return v > -1e5f && v < 1e5f ? v : 0.0f; }

}  // namespace

HeightField::HeightField(std::shared_ptr<const MipChain> chain, const TextureUse& use, const Sampler& sampler)
    : chain_(std::move(chain)), wrap_u_(sampler.wrap_u), wrap_v_(sampler.wrap_v), offset_(use.transform.offset) {
    const float c = float(math::cos(double(use.transform.rotation_rad))),
                s = float(math::sin(double(use.transform.rotation_rad)));
    row_u_ = {c * use.transform.scale.x, s * use.transform.scale.y};  // as in KHR_texture_transform
    row_v_ = {-s * use.transform.scale.x, c * use.transform.scale.y};
    const MipLevel& full = chain_->levels[0];
    square_widths_ = std::abs(double(use.transform.scale.x) * double(use.transform.scale.y)) * full.height / full.width;
}

double HeightField::texels(vec2 d) const {
    const MipLevel& full = chain_->levels[0];
    const double x = double(row_u_.x * d.x + row_u_.y * d.y) * full.width,
                 y = double(row_v_.x * d.x + row_v_.y * d.y) * full.height;
    return std::sqrt(x * x + y * y);
}

float HeightField::at(vec2 uv, float level) const {
    const vec2 map{in_range(row_u_.x * uv.x + row_u_.y * uv.y + offset_.x),
                   in_range(row_v_.x * uv.x + row_v_.y * uv.y + offset_.y)};
    const float in = std::clamp(level, 0.0f, float(chain_->levels.size() - 1));
    const auto fine = std::size_t(in);
    const float rest = in - float(fine), height = at_level(map, fine);
    return rest > 0 ? height + (at_level(map, fine + 1) - height) * rest : height;
}

double HeightField::deviation(int number) const {
    const MipLevel& level = chain_->levels[std::min(std::size_t(number), chain_->levels.size() - 1)];
    const double count = double(level.width) * level.height;
    double sum = 0, squares = 0;
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x) {
            const double h = double(texel(*chain_, level, x, y));
            sum += h, squares += h * h;
        }
    return std::sqrt(std::max(squares / count - (sum / count) * (sum / count), 0.0));
}

/// @param map  the map's own coordinates
float HeightField::at_level(vec2 map, std::size_t number) const {
    const MipLevel& level = chain_->levels[number];
    const double x = double(map.x) * level.width - 0.5, y = double(map.y) * level.height - 0.5;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    const float tx = float(x - x0), ty = float(y - y0);
    const auto read = [&](int column, int row) {
        return texel(*chain_, level, wrapped_texel(column, level.width, wrap_u_),
                     wrapped_texel(row, level.height, wrap_v_));
    };
    const float upper = read(x0, y0) + (read(x0 + 1, y0) - read(x0, y0)) * tx;
    const float lower = read(x0, y0 + 1) + (read(x0 + 1, y0 + 1) - read(x0, y0 + 1)) * tx;
    return upper + (lower - upper) * ty;
}

std::shared_ptr<const HeightField> HeightFields::of(const TextureUse& use) {
    const Texture& texture = scene_.textures[use.texture];
    const auto [entry, is_new] = chains_.try_emplace(texture.image.get());
    if (is_new) try {
            MipChain chain = make_mip_chain(decode(*texture.image, context_), ColorSpace::linear, context_);
            if (!chain.levels.empty()) entry->second = std::make_shared<const MipChain>(std::move(chain));
        } catch (const Error& error) {
            context_.throw_if_cancelled();
            context_.report().add(Remark::warning, texture.image->file, texture.image->name,
                                  "no displacement: " + error.reason());
        }
    return entry->second ? std::make_shared<const HeightField>(entry->second, use, texture.sampler) : nullptr;
}

}  // namespace rakelight
