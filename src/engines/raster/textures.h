// SPDX-License-Identifier: Apache-2.0
// Textures as the kernels read them: decoded, with mip chains, kept as long as their picture is used.
#pragma once
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <rakelight/scene.h>

#include "engines/raster/kernel_types.h"
#include "image/mip_chain.h"

namespace rakelight::raster {

/// All mip levels of one picture in one array.
struct TextureData {
    std::vector<std::uint32_t> rgba8, rgba16;  ///< data and colors: see TextureView
    std::vector<float> rgba32f;
    TextureView view;  ///< without sampler state
};

/// Decodes pictures once for each color space in which they are used, in parallel, and keeps them by identity.
class TextureCache {
public:
    /// Forgets what this scene does not use, decodes what is new. A picture that cannot be decoded becomes a warning in the
    /// report and is left out. `uses` are the (picture, color space) pairs that materials need.
    void update(const std::vector<std::pair<ImageHandle, ColorSpace>>& uses, Context& context);
    /// Null when the picture could not be decoded.
    const TextureData* find(const ImageHandle& image, ColorSpace space) const;

private:
    using Key = std::pair<ImageHandle, ColorSpace>;
    std::map<Key, std::shared_ptr<const TextureData>> textures_;
};

/// The view of a texture with its sampler's state filled in.
TextureView with_sampler(const TextureData& data, const Sampler& sampler);

}  // namespace rakelight::raster
