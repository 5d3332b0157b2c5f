// SPDX-License-Identifier: Apache-2.0
// Materials' pictures as OpenGL samples them: our mip levels, the driver's filters.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <rakelight/base/context.h>

#include "engines/opengl/context/driver.h"
#include "engines/opengl/context/gl_objects.h"
#include "shading/texture_cache.h"

namespace rakelight::opengl {

/// A mip chain on its way to the GPU.
struct TextureLevels final : shading::PackedTexture {
    bool is_srgb = false, is_float = false;
    int width = 1, height = 1;
    float mean_green = 1;                  ///< 0..1: of the smallest level
    mutable std::vector<MipLevel> levels;  ///< empty: they are on the GPU
    mutable MemoryCharge charge;           ///< pays for them
    std::size_t level_count = 0;
};

/// Keeps levels as they are. Thread-safe.
class LevelPacker final : public shading::TexturePacker {
public:
    std::uint64_t packed_bytes(int width, int height, bool is_float, bool is_srgb) const override;
    std::shared_ptr<const shading::PackedTexture> pack(const MipChain& chain, const shading::TextureKey& key,
                                                       MemoryCharge charge) const override;
};

/// What is on the GPU, by what it was made of.
class TextureStore {
public:
    explicit TextureStore(const Driver& driver) : driver_(driver) {}

    /// A picture, and whether heights are read from it: they need more than 8 bits between two texels.
    struct Wish {
        std::shared_ptr<const TextureLevels> levels;
        bool is_height = false;
        bool keeps_levels = false;            ///< a bump map: it may be wished for as the other kind later
        const EncodedImage* image = nullptr;  ///< what messages name
    };
    bool has(const Wish& wish) const { return textures_.contains({wish.levels.get(), wish.is_height}); }
    void add(const Wish& wish, Context& context);  ///< @throws Error failed: no memory on the GPU
    /// Drops what is not wished for, and what the processor's memory holds of what is.
    void keep_only(const std::vector<Wish>& wishes);
    GLuint find(const TextureLevels& levels, bool is_height) const;
    GLuint sampler(const Sampler& how, bool is_height);

private:
    GlTexture upload(const Wish& wish, Context& context) const;

    const Driver& driver_;
    struct Entry {
        std::shared_ptr<const TextureLevels> of;  ///< keeps the address its own
        GlTexture texture;
    };
    std::map<std::pair<const TextureLevels*, bool>, Entry> textures_;
    std::map<std::array<int, 5>, GlSampler> samplers_;
};

/// Of a mip chain: the first levels that have more texels per side than the driver takes.
std::size_t levels_beyond(const std::vector<MipLevel>& levels, int texture_size);
/// "of ... is drawn with fewer texels ..."
std::string drawn_smaller(const MipLevel& whole, const Driver& driver);
/// Into the texture that is bound; the first `skipped` are left out. Floats become half floats.
void upload_levels(const std::vector<MipLevel>& levels, std::size_t skipped, bool is_srgb);

}  // namespace rakelight::opengl
