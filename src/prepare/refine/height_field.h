// SPDX-License-Identifier: Apache-2.0
// Filtered sampling of height maps for displacement.
#pragma once
#include <map>
#include <memory>

#include <rakelight/scene/scene.h>

#include "image/maps/mip_chain.h"

namespace rakelight {

/// A height map as used by a material.
class HeightField {
public:
    HeightField(std::shared_ptr<const MipChain> chain, const TextureUse& use, const Sampler& sampler);
    /// Area of 1 x 1 in texture coordinates, in squares of the texture's width. Texels are square on the surface, as
    /// for parallax mapping.
    double square_widths() const { return square_widths_; }
    /// [texels of the full size] length of a difference of texture coordinates
    double texels(vec2 difference) const;
    /// The first channel, 0..1 for integer pictures, trilinear.
    /// @param level >= 0, clamped to the last level
    float at(vec2 texcoord, float level) const;
    /// Standard deviation of the heights.
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
    /// Null if the picture cannot be decoded, with one warning.
    std::shared_ptr<const HeightField> of(const TextureUse& use);

private:
    const Scene& scene_;
    Context& context_;
    std::map<const EncodedImage*, std::shared_ptr<const MipChain>> chains_;
};

}  // namespace rakelight
