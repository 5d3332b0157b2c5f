// SPDX-License-Identifier: Apache-2.0
#include "cpu_shading/textures.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "math/color.h"

namespace rakelight::cpu_shading {
using shading::TextureKey;

namespace {

/// sRGB codes -> TextureView::rgba16.
struct Linear15 {
    std::array<std::uint32_t, 256> color{}, alpha{};  ///< in the low and in the high half

    Linear15() {
        for (std::uint32_t i = 0; i < 256; ++i) {
            color[i] = std::uint32_t(linear_from_srgb8(std::uint8_t(i)) * 32767.0f + 0.5f);
            alpha[i] = (i * 32767u * 2 + 255) / 510 << 16;
        }
    }
    void put(std::uint32_t codes, std::uint32_t* to) const {
        to[0] = color[codes & 255u] | color[codes >> 16 & 255u] << 16;
        to[1] = color[codes >> 8 & 255u] | alpha[codes >> 24];
    }
};

/// Place of what stands at i, -1..size: in the border it is the opposite edge's, or the same edge's.
int wrapped(int i, int size, Wrap wrap) {
    return wrap == Wrap::repeat ? (i + size) % size : std::clamp(i, 0, size - 1);
}

/// Puts the texels of a level with its border, row by row. @param words  that each takes
template <class Texel, class Word, class Put>
void put_bordered(const std::vector<Texel>& texels, const MipLevel& level, const TextureKey& key, std::size_t words,
                  Word* to, const Put& put) {
    for (int y = -1; y <= level.height; ++y) {
        const Texel* const row =
            texels.data() + std::size_t(wrapped(y, level.height, key.wrap_v)) * std::size_t(level.width);
        put(row[wrapped(-1, level.width, key.wrap_u)], to), to += words;
        for (int x = 0; x < level.width; ++x, to += words) put(row[x], to);
        put(row[wrapped(level.width, level.width, key.wrap_u)], to), to += words;
    }
}

std::size_t bordered_size(int width, int height) { return (std::size_t(width) + 2) * (std::size_t(height) + 2); }
std::size_t bordered_size(const MipLevel& level) { return bordered_size(level.width, level.height); }

/// What pack_texture() makes of a picture of that size.
std::uint64_t packed_bytes(int width, int height, bool is_float, bool is_srgb) {
    std::uint64_t texels = 0;
    for (std::size_t levels = 0; levels < max_mip_levels; ++levels) {
        texels += bordered_size(width, height);
        if (width <= 1 && height <= 1) break;
        width = std::max(1, width / 2), height = std::max(1, height / 2);
    }
    return texels * (is_float ? 4 * sizeof(float) : (is_srgb ? 2 : 1) * sizeof(std::uint32_t));
}

/// Kernels address texels, and the four floats of one, by int32_t.
bool fits_texel_index(std::size_t texels, bool is_float) {
    return texels <= std::size_t(std::numeric_limits<std::int32_t>::max()) / (is_float ? 4 : 1);
}

/// @param at  [texels] where the level begins
void put_level(const MipChain& chain, const MipLevel& level, const TextureKey& key, std::size_t at, TextureData& to) {
    static const Linear15 linear15;
    if (chain.is_float)
        put_bordered(level.rgba32f, level, key, 4, to.rgba32f.data() + 4 * at,
                     [](const vec4& t, float* out) { out[0] = t.x, out[1] = t.y, out[2] = t.z, out[3] = t.w; });
    else if (chain.is_srgb)
        put_bordered(level.rgba8, level, key, 2, to.rgba16.data() + 2 * at,
                     [](std::uint32_t t, std::uint32_t* out) { linear15.put(t, out); });
    else
        put_bordered(level.rgba8, level, key, 1, to.rgba8.data() + at,
                     [](std::uint32_t t, std::uint32_t* out) { *out = t; });
}

void make_room(const MipChain& chain, std::size_t texels, TextureData& data) {
    if (!fits_texel_index(texels, chain.is_float))
        throw Error(ErrorCode::bad_file, "the picture has too many texels for the soft engine");
    if (chain.is_float)
        data.rgba32f = TexelArray<float>(texels * 4);
    else if (chain.is_srgb)
        data.rgba16 = TexelArray<std::uint32_t>(texels * 2);
    else
        data.rgba8 = TexelArray<std::uint32_t>(texels);
}

}  // namespace

std::shared_ptr<TextureData> pack_texture(const MipChain& chain, const TextureKey& key, MemoryCharge charge) {
    if (chain.levels.empty()) throw Error(ErrorCode::bad_file, "the picture has no pixels");
    const auto& full = chain.levels[0];
    const std::uint64_t bytes = packed_bytes(full.width, full.height, chain.is_float, chain.is_srgb);
    if (bytes > charge.bytes()) charge.grow(bytes - charge.bytes(), "the texture");
    auto data = std::make_shared<TextureData>();
    data->charge = std::move(charge);
    TextureView& view = data->view;
    view = {};
    view.levels = int(std::min<std::size_t>(chain.levels.size(), max_mip_levels));
    view.wrap_u = wrap_number(key.wrap_u);
    view.wrap_v = wrap_number(key.wrap_v);
    const std::span levels(chain.levels.data(), std::size_t(view.levels));
    std::size_t texels = 0;
    for (const MipLevel& level : levels) texels += bordered_size(level);
    make_room(chain, texels, *data);
    std::size_t offset = 0;
    for (std::size_t l = 0; l < levels.size(); ++l) {
        view.width[l] = levels[l].width;
        view.height[l] = levels[l].height;
        view.stride[l] = levels[l].width + 2;
        view.fixed_width[l] = float(levels[l].width) * 32768.0f;
        view.fixed_height[l] = float(levels[l].height) * 32768.0f;
        view.origin[l] = std::int32_t(offset) + levels[l].width + 3;
        put_level(chain, levels[l], key, offset, *data);
        offset += bordered_size(levels[l]);
    }
    if (chain.is_float)
        view.rgba32f = data->rgba32f.data();
    else if (chain.is_srgb)
        view.rgba16 = data->rgba16.data();
    else
        view.rgba8 = data->rgba8.data();
    return data;
}

std::uint64_t CpuTexturePacker::packed_bytes(int width, int height, bool is_float, bool is_srgb) const {
    return cpu_shading::packed_bytes(width, height, is_float, is_srgb);
}

std::shared_ptr<const shading::PackedTexture> CpuTexturePacker::pack(const MipChain& chain, const TextureKey& key,
                                                                     MemoryCharge charge) const {
    return pack_texture(chain, key, std::move(charge));
}

WrapNumber wrap_number(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return wrap_repeat;
        case Wrap::mirrored_repeat:
            return wrap_mirrored;
        case Wrap::clamp_to_edge:
            return wrap_clamped;
    }
    return wrap_repeat;
}

MipNumber mip_number(MipFilter filter) {
    switch (filter) {
        case MipFilter::none:
            return mip_none;
        case MipFilter::nearest:
            return mip_nearest;
        case MipFilter::linear:
            return mip_linear;
    }
    return mip_none;
}

TextureView with_filters(const TextureData& data, const Sampler& sampler) {
    TextureView view = data.view;
    view.magnify_linear = sampler.magnify == Filter::linear;
    view.minify_linear = sampler.minify == Filter::linear;
    view.mip = mip_number(sampler.mip);
    return view;
}

}  // namespace rakelight::cpu_shading
