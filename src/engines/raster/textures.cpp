// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/textures.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "math/color.h"

namespace rakelight::raster {
namespace {

/// sRGB codes -> TextureView::rgba16.
void append_linear15(const std::vector<std::uint32_t>& codes, std::vector<std::uint32_t>& to) {
    static const std::array<std::uint32_t, 256> color = [] {
        std::array<std::uint32_t, 256> t{};
        for (std::size_t i = 0; i < 256; ++i)
            t[i] = std::uint32_t(linear_from_srgb8(std::uint8_t(i)) * 32767.0f + 0.5f);
        return t;
    }();
    for (const std::uint32_t c : codes) {
        const std::uint32_t alpha = ((c >> 24) * 32767u * 2 + 255) / 510;
        to.push_back(color[c & 255u] | color[c >> 16 & 255u] << 16);
        to.push_back(color[c >> 8 & 255u] | alpha << 16);
    }
}

/// Kernels address texels, and the four floats of one, by int32_t.
bool fits_texel_index(std::size_t texels, bool is_float) {
    return texels <= std::size_t(std::numeric_limits<std::int32_t>::max()) / (is_float ? 4 : 1);
}

std::shared_ptr<const TextureData> pack(const MipChain& chain) {
    if (chain.levels.empty()) throw Error(ErrorCode::bad_file, "the picture has no pixels");
    auto data = std::make_shared<TextureData>();
    TextureView& view = data->view;
    view = {};
    view.levels = int(std::min<std::size_t>(chain.levels.size(), max_mip_levels));
    std::size_t texels = 0;
    for (int l = 0; l < view.levels; ++l) texels += std::size_t(chain.levels[std::size_t(l)].width) * std::size_t(chain.levels[std::size_t(l)].height);
    if (!fits_texel_index(texels, chain.is_float)) throw Error(ErrorCode::bad_file, "the picture has too many texels for the soft engine");
    if (chain.is_float)
        data->rgba32f.reserve(texels * 4);
    else if (chain.is_srgb)
        data->rgba16.reserve(texels * 2);
    else
        data->rgba8.reserve(texels);
    std::size_t offset = 0;
    for (int l = 0; l < max_mip_levels; ++l) {
        const MipLevel& level = chain.levels[std::size_t(std::min(l, view.levels - 1))];
        view.width[l] = level.width;
        view.height[l] = level.height;
        view.offset[l] = l < view.levels ? std::int32_t(offset) : view.offset[view.levels - 1];
        if (l >= view.levels) continue;
        offset += std::size_t(level.width) * std::size_t(level.height);
        if (chain.is_srgb)
            append_linear15(level.rgba8, data->rgba16);
        else
            data->rgba8.insert(data->rgba8.end(), level.rgba8.begin(), level.rgba8.end());
        for (const vec4& t : level.rgba32f) data->rgba32f.insert(data->rgba32f.end(), {t.x, t.y, t.z, t.w});
    }
    if (chain.is_float)
        view.rgba32f = data->rgba32f.data();
    else if (chain.is_srgb)
        view.rgba16 = data->rgba16.data();
    else
        view.rgba8 = data->rgba8.data();
    return data;
}

/// A texture that is not there yet.
struct Missing {
    const ImageHandle* image;
    ColorSpace space;
    std::shared_ptr<const TextureData>* data;
    std::string fault;  ///< why there is no data
};

void load(Missing& m, Context& context) {
    const EncodedImage& image = **m.image;
    try {
        const Pixels pixels = image.decode(image, context);
        *m.data = pack(make_mip_chain(pixels, m.space, context));
    } catch (const Error& error) {
        m.fault = error.reason();
    }
}

/// What decoding charged beyond the textures themselves is free again.
void release_temporaries(MemoryBudget& memory, std::uint64_t charged_before, std::span<const Missing> loaded) {
    std::uint64_t kept = charged_before;
    for (const Missing& m : loaded)
        if (*m.data)
            kept += ((*m.data)->rgba8.size() + (*m.data)->rgba16.size()) * sizeof(std::uint32_t) +
                    (*m.data)->rgba32f.size() * sizeof(float);
    if (memory.charged() > kept) memory.release(memory.charged() - kept);
}

}  // namespace

void TextureCache::update(const std::vector<std::pair<ImageHandle, ColorSpace>>& uses, Context& context) {
    std::map<Key, std::shared_ptr<const TextureData>> kept;
    std::vector<Missing> missing;  // in the order of use: that of the map is the order of addresses
    for (const Key& key : uses) {
        const auto [entry, is_new] = kept.try_emplace(key);
        const auto known = textures_.find(key);
        if (known != textures_.end()) entry->second = known->second;
        if (is_new && !entry->second) missing.push_back({&entry->first.first, entry->first.second, &entry->second, {}});
    }
    MemoryBudget& memory = context.memory();
    const std::uint64_t before = memory.charged();
    context.parallel_for(missing.size(), [&](std::size_t i) { load(missing[i], context); });
    if (memory.grants_in_any_order()) {
        release_temporaries(memory, before, missing);
    } else {
        // Memory is short: one after another, so that what is left out does not depend on threads.
        for (Missing& m : missing) m.data->reset();
        memory.release(memory.charged() - before);
        for (Missing& m : missing) {
            const std::uint64_t before_this = memory.charged();
            load(m, context);
            release_temporaries(memory, before_this, {&m, 1});
        }
    }
    for (const Missing& m : missing)
        if (!*m.data) context.report().add(Remark::warning, (*m.image)->file, (*m.image)->name, "texture left out: " + m.fault);
    textures_ = std::move(kept);
}

const TextureData* TextureCache::find(const ImageHandle& image, ColorSpace space) const {
    const auto it = textures_.find({image, space});
    return it == textures_.end() ? nullptr : it->second.get();
}

TextureView with_sampler(const TextureData& data, const Sampler& sampler) {
    TextureView view = data.view;
    view.wrap_u = int(sampler.wrap_u);
    view.wrap_v = int(sampler.wrap_v);
    view.magnify_linear = sampler.magnify == Filter::linear;
    view.minify_linear = sampler.minify == Filter::linear;
    view.mip = int(sampler.mip);
    return view;
}

}  // namespace rakelight::raster
