// SPDX-License-Identifier: Apache-2.0
// The pictures that materials read: decoded, with mip chains, handed to an engine that packs them as it samples them, and
// kept as long as they are used.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <rakelight/scene/scene.h>

#include "image/maps/alpha_coverage.h"
#include "image/maps/mip_chain.h"
#include "image/maps/normal_map_check.h"
#include "shading/lights/mean_map.h"

namespace rakelight::shading {

/// What a texture is made of. Engines may keep how it wraps in the texels.
struct TextureKey {
    ImageHandle image;
    ColorSpace space;
    Wrap wrap_u, wrap_v;
    AlphaTest test{};  ///< of materials with a mask: the levels keep what is seen
    auto operator<=>(const TextureKey&) const = default;
};

/// A texture as an engine samples it.
struct PackedTexture {
    virtual ~PackedTexture() = default;
};

/// How an engine packs mip chains. Thread-safe.
class TexturePacker {
public:
    virtual ~TexturePacker() = default;
    /// What pack() makes of a picture of that size. [bytes]
    virtual std::uint64_t packed_bytes(int width, int height, bool is_float, bool is_srgb) const = 0;
    /// @param charge  pays for packed_bytes() where the size was known before; else it grows
    /// @throws Error bad_file: no or too many texels, over the memory budget
    virtual std::shared_ptr<const PackedTexture> pack(const MipChain& chain, const TextureKey& key,
                                                      MemoryCharge charge) const = 0;
};

/// Mip levels as averages, before they keep the coverage for a cutoff.
struct PlainLevels {
    MipChain chain;
    bool is_tagged_srgb;  ///< Pixels::is_tagged_srgb
};

/// A texture that is there.
struct LoadedTexture {
    std::shared_ptr<const PackedTexture> packed;
    bool is_tagged_srgb = false;          ///< Pixels::is_tagged_srgb
    bool is_bump = false;                 ///< as it was wished for
    std::optional<NormalMapCheck> check;  ///< of bumps of 8 bits
    std::optional<MeanMap> means;         ///< where they were wished for
    MemoryCharge means_charge;            ///< pays for them
    /// Of a texture whose cutoff has changed, so that the next cutoff need not decode the picture; null: of others, and
    /// where memory is short.
    std::shared_ptr<const PlainLevels> plain;
};

/// What a material needs.
struct TextureWish {
    TextureKey key;
    bool is_bump = false;      ///< a normal or height map: LoadedTexture::check is wanted
    bool is_emission = false;  ///< LoadedTexture::means are wanted
};

/// Decodes pictures once for each color space, wrapping and cutoff with which they are used, in parallel, and keeps them
/// by identity.
class TextureCache {
public:
    /// Forgets what is not wished for, decodes what is new. A picture that cannot be decoded becomes a warning in the
    /// report and is left out.
    void update(const std::vector<TextureWish>& wishes, const TexturePacker& packer, Context& context);
    /// Null when the picture could not be decoded. Valid until the next update().
    const LoadedTexture* find(const TextureKey& key) const;

private:
    std::shared_ptr<const LoadedTexture> with_other_cutoff(const TextureKey& key) const;
    std::map<TextureKey, std::shared_ptr<const LoadedTexture>> textures_;
};

}  // namespace rakelight::shading
