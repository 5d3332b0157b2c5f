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
    int width() const { return chain_->levels[0].width; }  ///< [px]
    /// The first channel, 0..1 of integer pictures, bilinear between the texels of a mip level (clamped to those that
    /// there are).
    float at(vec2 texcoord, int level) const;

private:
    std::shared_ptr<const MipChain> chain_;
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
