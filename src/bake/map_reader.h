// SPDX-License-Identifier: Apache-2.0
// Pictures of materials, read between their texels.
#pragma once
#include <map>
#include <memory>

#include <rakelight/context.h>
#include <rakelight/scene.h>

#include "image/mip_chain.h"
#include "math/linear.h"
#include "shading/material_factors.h"

namespace rakelight::bake {

/// A picture as a material uses it.
class MapReader {
public:
    MapReader(std::shared_ptr<const MipChain> chain, const TextureUse& use, const Sampler& sampler);

    std::uint32_t texcoord_set() const { return set_; }
    /// Where texture coordinates lie on the picture. [uv] kept in -1e5..1e5
    dvec2 place(dvec2 uv) const;
    /// Linear between the four texels about place(uv): colors in linear light, data as codes / 255.
    /// @param level  of the chain, the smallest where there is none
    dvec3 operator()(dvec2 uv, std::size_t level = 0) const;
    /// The level with about one texel for each sample. @param texels  of the full picture that a sample stands for
    std::size_t level_for(double texels) const;
    double width() const { return chain_->levels[0].width; }
    double height() const { return chain_->levels[0].height; }

private:
    std::shared_ptr<const MipChain> chain_;
    shading::UvTransform transform_;
    Wrap wrap_u_, wrap_v_;
    std::uint32_t set_;
};

/// Decoded pictures, each once.
class MapChains {
public:
    explicit MapChains(ColorSpace space) : space_(space) {}
    /// @param what  for the warning where it cannot be decoded: "a normal map"
    /// @return null there
    std::shared_ptr<const MipChain> chain_of(const Texture& texture, const char* what, Context& context);

private:
    ColorSpace space_;
    std::map<const EncodedImage*, std::shared_ptr<const MipChain>> chains_;
};

}  // namespace rakelight::bake
