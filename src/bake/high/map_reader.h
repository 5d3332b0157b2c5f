// SPDX-License-Identifier: Apache-2.0
// Bilinear sampling of material textures.
#pragma once
#include <map>
#include <memory>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "image/maps/mip_chain.h"
#include "math/linear.h"
#include "shading/material_factors.h"

namespace rakelight::bake {

/// A texture as used by a material.
class MapReader {
public:
    MapReader(std::shared_ptr<const MipChain> chain, const TextureUse& use, const Sampler& sampler);

    std::uint32_t texcoord_set() const { return set_; }
    /// Position of texture coordinates on the picture; [uv] clamped to -1e5..1e5
    dvec2 place(dvec2 uv) const;
    /// Bilinear at place(uv): colors in linear light, data as codes / 255.
    /// @param level mip level, clamped to the last
    dvec3 operator()(dvec2 uv, std::size_t level = 0) const;
    /// The mip level with about one texel per sample.
    /// @param texels area of a sample in texels of the full picture
    std::size_t level_for(double texels) const;
    double width() const { return chain_->levels[0].width; }
    double height() const { return chain_->levels[0].height; }

private:
    std::shared_ptr<const MipChain> chain_;
    shading::UvTransform transform_;
    Wrap wrap_u_, wrap_v_;
    std::uint32_t set_;
};

/// Decoded pictures, each decoded once.
class MapChains {
public:
    explicit MapChains(ColorSpace space) : space_(space) {}
    /// @param what for the warning if it cannot be decoded: "a normal map"
    /// @return null if it cannot be decoded
    std::shared_ptr<const MipChain> chain_of(const Texture& texture, const char* what, Context& context);

private:
    ColorSpace space_;
    std::map<const EncodedImage*, std::shared_ptr<const MipChain>> chains_;
};

}  // namespace rakelight::bake
