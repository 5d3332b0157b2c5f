// SPDX-License-Identifier: Apache-2.0
// Textures as the kernels read them.
#pragma once
#include <memory>

#include "base/huge_pages.h"
#include "cpu_shading/texture_view.h"
#include "shading/texture_cache.h"

namespace rakelight::cpu_shading {

/// Memory for texels that is written once: nothing is in it at first. In huge pages where the system grants them.
template <class Word>
class TexelArray {
public:
    TexelArray() = default;
    explicit TexelArray(std::size_t count) : words_(new Word[count]), size_(count) {
        advise_huge_pages(words_.get(), count * sizeof(Word));
    }
    Word* data() { return words_.get(); }
    const Word* data() const { return words_.get(); }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const Word& operator[](std::size_t i) const { return words_[i]; }

private:
    std::unique_ptr<Word[]> words_;
    std::size_t size_ = 0;
};

/// All mip levels of one picture in one array.
struct TextureData final : shading::PackedTexture {
    TexelArray<std::uint32_t> rgba8, rgba16;  ///< data and colors: see TextureView
    TexelArray<float> rgba32f;
    TextureView view;     ///< without the sampler's filters
    MemoryCharge charge;  ///< pays for the arrays
};

/// Into TextureData. Borders hold how the texture wraps.
class CpuTexturePacker final : public shading::TexturePacker {
public:
    std::uint64_t packed_bytes(int width, int height, bool is_float, bool is_srgb) const override;
    std::shared_ptr<const shading::PackedTexture> pack(const MipChain& chain, const shading::TextureKey& key,
                                                       MemoryCharge charge) const override;
};

/// A mip chain as the kernels read it; `key` says how its borders wrap.
/// @param charge  grows to what the texture takes
/// @throws Error bad_file: no or too many texels, over the memory budget
std::shared_ptr<TextureData> pack_texture(const MipChain& chain, const shading::TextureKey& key, MemoryCharge charge);

WrapNumber wrap_number(Wrap wrap);
MipNumber mip_number(MipFilter filter);

/// The view of a texture with its sampler's filters filled in.
TextureView with_filters(const TextureData& data, const Sampler& sampler);

}  // namespace rakelight::cpu_shading
