// SPDX-License-Identifier: Apache-2.0
#include "shading/texture_cache.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <string>

#include "image/decode.h"

namespace rakelight::shading {
namespace {

/// What all wishes for a texture want of it.
struct Wanted {
    bool is_bump = false, means = false;
};

bool has(const LoadedTexture& texture, const Wanted& wanted) {
    return (texture.is_bump || !wanted.is_bump) && (texture.means || !wanted.means);
}

/// A texture that does not exist yet.
struct Missing {
    const TextureKey* key;
    Wanted wanted;
    std::shared_ptr<const LoadedTexture>* data;
    std::shared_ptr<const LoadedTexture>
        before{};                    ///< what it is with the cutoff that it had before; null: it had none
    std::optional<Pixels> header{};  ///< what the picture will be, where that is known before it is decoded
    MemoryCharge charge{};           ///< pays for the data
    std::string fault{};             ///< why there is no data
};

NormalMapCheck check_of(const MipLevel& level) {
    return check_normal_map(level.rgba8, level.width, level.height, level.width);
}

template <class Work>
void try_to(Missing& m, Context& context, const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        context.throw_if_cancelled();
        m.fault = error.reason();
    }
}

void measure(Missing& m, Context& context) {
    const EncodedImage& image = *m.key->image;
    if (!image.measure) return;
    try_to(m, context, [&] { m.header = image.measure(image, context); });
}

/// Charges what will be kept, and asks for what decoding takes beside: what is refused is not decoded.
void charge(Missing& m, const TexturePacker& packer, Context& context) {
    if (!m.header) return;
    const Pixels& p = *m.header;
    const bool is_float = p.component != Component::u8;
    try_to(m, context, [&] {
        MemoryBudget& memory = context.memory();
        MemoryCharge kept(memory,
                          packer.packed_bytes(p.width, p.height, is_float, m.key->space == ColorSpace::srgb) +
                              (m.wanted.means ? MeanMap::bytes_for(p.width, p.height) : 0),
                          "the texture");
        memory.check(p.row_bytes() * std::uint64_t(p.height) + mip_chain_bytes(p), "the texture while it is decoded");
        m.charge = std::move(kept);
    });
}

PlainLevels decoded(const TextureKey& key, Context& context) {
    const Pixels pixels = decode_measured(*key.image, context);
    return {make_mip_chain(pixels, key.space, context), pixels.is_tagged_srgb};
}

PlainLevels copy_of(const PlainLevels& plain, Context& context) {
    const MipChain& from = plain.chain;
    MemoryCharge charge(context.memory(), from.charge.bytes(), "the texture");
    return {{from.is_srgb, from.is_float, std::move(charge), from.levels}, plain.is_tagged_srgb};
}

/// The levels of a texture whose cutoff has changed are kept: it is likely to change again. Other data goes first.
std::shared_ptr<const PlainLevels> kept_levels(const Missing& m, const PlainLevels& plain, Context& context) {
    if (!m.before) return nullptr;
    if (m.before->plain) return m.before->plain;
    const MemoryBudget& memory = context.memory();
    if (memory.charged() + plain.chain.charge.bytes() > memory.limit() / 4) return nullptr;
    return std::make_shared<const PlainLevels>(copy_of(plain, context));
}

void load(Missing& m, const TexturePacker& packer, Context& context) {
    m.fault.clear();
    try_to(m, context, [&] {
        auto texture = std::make_shared<LoadedTexture>();
        const bool is_known = m.before && m.before->plain;
        PlainLevels plain = is_known ? copy_of(*m.before->plain, context) : decoded(*m.key, context);
        texture->is_tagged_srgb = plain.is_tagged_srgb;
        texture->plain = kept_levels(m, plain, context);
        MipChain& chain = plain.chain;
        keep_coverage(chain, m.key->test, m.key->wrap_u == Wrap::repeat, m.key->wrap_v == Wrap::repeat, context);
        MemoryCharge charge = m.charge.bytes() > 0 ? std::move(m.charge) : MemoryCharge(context.memory());
        if (m.wanted.means && !chain.levels.empty()) {
            const std::uint64_t bytes = MeanMap::bytes_for(chain.levels[0].width, chain.levels[0].height);
            texture->means_charge =
                charge.bytes() > 0 ? charge.split(bytes) : MemoryCharge(context.memory(), bytes, "the texture's means");
            texture->means.emplace(chain);
        }
        texture->packed = packer.pack(chain, *m.key, std::move(charge));
        texture->is_bump = m.wanted.is_bump;
        if (m.wanted.is_bump && !chain.is_float && !chain.is_srgb) texture->check = check_of(chain.levels[0]);
        *m.data = std::move(texture);
    });
}

/// The largest pictures first: begun last, one of them would be waited for.
std::vector<Missing*> by_size(std::vector<Missing*> measured) {
    const auto texels = [](const Missing* m) {
        return std::uint64_t(m->header->width) * std::uint64_t(m->header->height);
    };
    std::ranges::stable_sort(measured, std::greater<>(), texels);
    return measured;
}

/// Which are left out where memory is short depends on their order, never on threads. What is kept is charged in order,
/// before anything is decoded. The memory for decoding itself is refused only where it does not fit alone.
void load_all(std::vector<Missing>& missing, const TexturePacker& packer, Context& context) {
    context.parallel_for(missing.size(), [&](std::size_t i) { measure(missing[i], context); });
    for (Missing& m : missing) charge(m, packer, context);
    std::vector<Missing*> measured;
    for (Missing& m : missing)
        if (m.header && m.fault.empty()) measured.push_back(&m);
    const std::uint64_t refused = context.memory().refusals();
    const std::vector<Missing*> largest_first = by_size(measured);
    std::atomic<std::size_t> begun{0};  // the loop's own order is not that of its indices
    context.parallel_for(measured.size(), [&](std::size_t) { load(*largest_first[begun++], packer, context); });
    if (context.memory().refusals() != refused)
        for (Missing* m : measured)
            if (!m->fault.empty()) load(*m, packer, context);
    for (Missing* m : measured)
        if (!m->fault.empty()) m->charge = {};
    for (Missing& m : missing)
        if (!m.header && m.fault.empty()) load(m, packer, context);
}

}  // namespace

void TextureCache::update(const std::vector<TextureWish>& wishes, const TexturePacker& packer, Context& context) {
    std::map<TextureKey, std::shared_ptr<const LoadedTexture>> kept;
    std::map<TextureKey, Wanted> wanted;
    for (const TextureWish& wish : wishes) {
        wanted[wish.key].is_bump |= wish.is_bump;
        wanted[wish.key].means |= wish.is_emission;
    }
    std::vector<Missing> missing;  // in the order of the wishes: that of the map is the order of addresses
    for (const TextureWish& wish : wishes) {
        const TextureKey& key = wish.key;
        const auto [entry, is_new] = kept.try_emplace(key);
        if (!is_new) continue;
        const auto known = textures_.find(key);
        if (known != textures_.end() && known->second && has(*known->second, wanted[key]))
            entry->second = known->second;
        else
            missing.push_back({&entry->first, wanted[key], &entry->second, with_other_cutoff(key)});
    }
    load_all(missing, packer, context);
    for (const Missing& m : missing)  // one that was there, and is not to be had again for what is new of it
        if (const auto known = textures_.find(*m.key); !*m.data && known != textures_.end()) *m.data = known->second;
    for (const Missing& m : missing)
        if (!*m.data)
            context.report().add(Remark::warning, m.key->image->file, m.key->image->name,
                                 "texture left out: " + m.fault);
    textures_ = std::move(kept);
}

std::shared_ptr<const LoadedTexture> TextureCache::with_other_cutoff(const TextureKey& key) const {
    if (!(key.test.cutoff > 0)) return nullptr;
    TextureKey other = key;
    other.test = {};  // the first of its picture
    for (auto it = textures_.lower_bound(other); it != textures_.end(); ++it) {
        other.test = it->first.test;
        if (it->first != other) break;
        if (it->second && other.test.cutoff > 0) return it->second;
    }
    return nullptr;
}

const LoadedTexture* TextureCache::find(const TextureKey& key) const {
    const auto it = textures_.find(key);
    return it == textures_.end() ? nullptr : it->second.get();
}

}  // namespace rakelight::shading
