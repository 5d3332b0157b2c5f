// SPDX-License-Identifier: Apache-2.0
// Textures as the kernels read them: decoded, with mip chains, kept as long as their picture is used.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include <rakelight/scene.h>

#include "engines/raster/kernel_types.h"
#include "image/mip_chain.h"

namespace rakelight::raster {

/// All mip levels of one picture in one array.
struct TextureData {
    std::vector<std::uint32_t> rgba8, rgba16;  ///< data and colors: see TextureView
    std::vector<float> rgba32f;
    TextureView view;             ///< without the sampler's filters
    bool is_tagged_srgb = false;  ///< Pixels::is_tagged_srgb
    MemoryCharge charge;          ///< pays for the arrays
};

/// What a texture is made of. How it wraps is in its borders.
struct TextureKey {
    ImageHandle image;
    ColorSpace space;
    Wrap wrap_u, wrap_v;
    auto operator<=>(const TextureKey&) const = default;
};

/// Decodes pictures once for each color space and wrapping in which they are used, in parallel, and keeps them by
/// identity.
class TextureCache {
public:
    /// Forgets what this scene does not use, decodes what is new. A picture that cannot be decoded becomes a warning in the
    /// report and is left out. `uses` are what materials need.
    void update(const std::vector<TextureKey>& uses, Context& context);
    /// Null when the picture could not be decoded.
    const TextureData* find(const TextureKey& key) const;

private:
    std::map<TextureKey, std::shared_ptr<const TextureData>> textures_;
};

/// A mip chain as the kernels read it; `key` says how its borders wrap.
/// @param charge  grows to what the texture takes
/// @throws Error bad_file: no or too many texels, over the memory budget
std::shared_ptr<TextureData> pack_texture(const MipChain& chain, const TextureKey& key, MemoryCharge charge);

/// The view of a texture with its sampler's filters filled in.
TextureView with_filters(const TextureData& data, const Sampler& sampler);

}  // namespace rakelight::raster
