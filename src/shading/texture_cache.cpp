// SPDX-License-Identifier: Apache-2.0
#include "shading/texture_cache.h"

#include <string>

#include "image/decode.h"

namespace rakelight::shading {
namespace {

/// A texture that is not there yet.
struct Missing {
    const TextureKey* key;
    bool is_bump;
    std::shared_ptr<const LoadedTexture>* data;
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
        MemoryCharge kept(memory, packer.packed_bytes(p.width, p.height, is_float, m.key->space == ColorSpace::srgb),
                          "the texture");
        memory.check(p.row_bytes() * std::uint64_t(p.height) + mip_chain_bytes(p), "the texture while it is decoded");
        m.charge = std::move(kept);
    });
}

void load(Missing& m, const TexturePacker& packer, Context& context) {
    const EncodedImage& image = *m.key->image;
    m.fault.clear();
    try_to(m, context, [&] {
        auto texture = std::make_shared<LoadedTexture>();
        const MipChain chain = [&] {
            const Pixels pixels = decode_measured(image, context);
            texture->is_tagged_srgb = pixels.is_tagged_srgb;
            return make_mip_chain(pixels, m.key->space, context);
        }();
        MemoryCharge charge = m.charge.bytes() > 0 ? std::move(m.charge) : MemoryCharge(context.memory());
        texture->packed = packer.pack(chain, *m.key, std::move(charge));
        texture->is_bump = m.is_bump;
        if (m.is_bump && !chain.is_float && !chain.is_srgb) texture->check = check_of(chain.levels[0]);
        *m.data = std::move(texture);
    });
}

/// Which are left out where memory is short depends on their order, never on threads: what is kept is charged in order,
/// before anything is decoded, and what decoding takes beside is refused only where it does not fit alone.
void load_all(std::vector<Missing>& missing, const TexturePacker& packer, Context& context) {
    context.parallel_for(missing.size(), [&](std::size_t i) { measure(missing[i], context); });
    for (Missing& m : missing) charge(m, packer, context);
    std::vector<Missing*> measured;
    for (Missing& m : missing)
        if (m.header && m.fault.empty()) measured.push_back(&m);
    const std::uint64_t refused = context.memory().refusals();
    context.parallel_for(measured.size(), [&](std::size_t i) { load(*measured[i], packer, context); });
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
    std::map<TextureKey, bool> is_bump;
    for (const TextureWish& wish : wishes) is_bump[wish.key] |= wish.is_bump;
    std::vector<Missing> missing;  // in the order of the wishes: that of the map is the order of addresses
    for (const auto& [key, _] : wishes) {
        const auto [entry, is_new] = kept.try_emplace(key);
        if (!is_new) continue;
        const auto known = textures_.find(key);
        if (known != textures_.end() && known->second && (known->second->is_bump || !is_bump[key]))
            entry->second = known->second;
        else
            missing.push_back({&entry->first, is_bump[key], &entry->second});
    }
    load_all(missing, packer, context);
    for (const Missing& m : missing)  // one that was there, and is not to be had again for its check
        if (const auto known = textures_.find(*m.key); !*m.data && known != textures_.end()) *m.data = known->second;
    for (const Missing& m : missing)
        if (!*m.data)
            context.report().add(Remark::warning, m.key->image->file, m.key->image->name,
                                 "texture left out: " + m.fault);
    textures_ = std::move(kept);
}

const LoadedTexture* TextureCache::find(const TextureKey& key) const {
    const auto it = textures_.find(key);
    return it == textures_.end() ? nullptr : it->second.get();
}

}  // namespace rakelight::shading
