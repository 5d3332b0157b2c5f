// SPDX-License-Identifier: Apache-2.0
// Height maps as geometry reads them: decoded, in ever smaller versions, filtered.
#pragma once
#include <map>
#include <memory>

#include <rakelight/scene.h>

#include "image/mip_chain.h"

namespace rakelight {

/// One height map as a material uses it.
class HeightField {
public:
    HeightField(std::shared_ptr<const MipChain> chain, const TextureUse& use, const Sampler& sampler);
    /// What a square of 1 by 1 in texture coordinates is in squares as wide as the texture. Texels are taken as square
    /// on the surface, as parallax takes them.
    double square_widths() const { return square_widths_; }
    /// [texels of the full size] between two places whose texture coordinates differ by that
    double texels(vec2 difference) const;
    /// The first channel, 0..1 of integer pictures, linear between texels and between mip levels.
    /// @param level  >= 0, clamped to those that there are
    float at(vec2 texcoord, float level) const;
    /// How far heights are from their mean, as the square root of the mean square.
    double deviation(int level) const;

private:
    float at_level(vec2 map, std::size_t number) const;

    std::shared_ptr<const MipChain> chain_;
    double square_widths_;
    Wrap wrap_u_, wrap_v_;
    vec2 row_u_, row_v_, offset_;  ///< the transform of texture coordinates
};

/// Decodes each picture once.
class HeightFields {
public:
    HeightFields(const Scene& scene, Context& context) : scene_(scene), context_(context) {}
    /// Null where the picture cannot be decoded: a warning in the report says so, once.
    std::shared_ptr<const HeightField> of(const TextureUse& use);

private:
    const Scene& scene_;
    Context& context_;
    std::map<const EncodedImage*, std::shared_ptr<const MipChain>> chains_;
};

}  // namespace rakelight
