// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/scene/textures.h"

#include <algorithm>
#include <set>

#include "base/format_text.h"

namespace rakelight::opengl {
namespace {

std::uint64_t bytes_of(const MipChain& chain) {
    std::uint64_t bytes = 0;
    for (const MipLevel& level : chain.levels) bytes += level.rgba8.size() * 4 + level.rgba32f.size() * 16;
    return bytes;
}

float mean_green(const MipLevel& level) {
    float sum = 0;
    for (const std::uint32_t texel : level.rgba8) sum += float(texel >> 8 & 255u) * (1.0f / 255.0f);
    for (const vec4& texel : level.rgba32f) sum += texel.y;
    return sum / (float(level.width) * float(level.height));
}

void upload_level(GLint number, GLint format, const MipLevel& l, GLenum layout, GLenum type, const void* texels) {
    glTexImage2D(GL_TEXTURE_2D, number, format, l.width, l.height, 0, layout, type, texels);
}

/// The first channel, as floats.
void upload_heights(const std::vector<MipLevel>& levels, std::size_t skipped, GLint format) {
    for (std::size_t i = skipped; i < levels.size(); ++i) {
        std::vector<float> heights;
        heights.reserve(levels[i].rgba8.size() + levels[i].rgba32f.size());
        for (const std::uint32_t texel : levels[i].rgba8) heights.push_back(float(texel & 255u) * (1.0f / 255.0f));
        for (const vec4& texel : levels[i].rgba32f) heights.push_back(texel.x);
        upload_level(GLint(i - skipped), format, levels[i], GL_RED, GL_FLOAT, heights.data());
    }
}

void upload_codes(const std::vector<MipLevel>& levels, std::size_t skipped, GLint format) {
    for (std::size_t i = skipped; i < levels.size(); ++i)
        upload_level(GLint(i - skipped), format, levels[i], GL_RGBA, GL_UNSIGNED_BYTE, levels[i].rgba8.data());
}

GLint wrap_of(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return GL_REPEAT;
        case Wrap::mirrored_repeat:
            return GL_MIRRORED_REPEAT;
        case Wrap::clamp_to_edge:
            return GL_CLAMP_TO_EDGE;
    }
    return GL_REPEAT;
}

GLint minify_of(const Sampler& how) {
    const bool is_linear = how.minify == Filter::linear;
    switch (how.mip) {
        case MipFilter::none:
            return is_linear ? GL_LINEAR : GL_NEAREST;
        case MipFilter::nearest:
            return is_linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
        case MipFilter::linear:
            return is_linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
    }
    return GL_LINEAR;
}

}  // namespace

std::size_t levels_beyond(const std::vector<MipLevel>& levels, int texture_size) {
    std::size_t skipped = 0;
    while (skipped + 1 < levels.size() && std::max(levels[skipped].width, levels[skipped].height) > texture_size)
        ++skipped;
    return skipped;
}

std::string drawn_smaller(const MipLevel& whole, const Driver& driver) {
    return format_text("of {} x {} is drawn with fewer texels: the OpenGL driver has at most {} per side", whole.width,
                       whole.height, driver.texture_size);
}

void upload_levels(const std::vector<MipLevel>& levels, std::size_t skipped, bool is_srgb) {
    if (!levels[0].rgba8.empty()) return upload_codes(levels, skipped, is_srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8);
    for (std::size_t i = skipped; i < levels.size(); ++i) {
        std::vector<vec4> texels = levels[i].rgba32f;
        for (vec4& t : texels)
            t = {std::clamp(t.x, -most_half, most_half), std::clamp(t.y, -most_half, most_half),
                 std::clamp(t.z, -most_half, most_half), t.w};
        upload_level(GLint(i - skipped), GL_RGBA16F, levels[i], GL_RGBA, GL_FLOAT, texels.data());
    }
}

std::uint64_t LevelPacker::packed_bytes(int width, int height, bool is_float, bool) const {
    std::uint64_t texels = 0;
    for (;; width = std::max(width / 2, 1), height = std::max(height / 2, 1)) {
        texels += std::uint64_t(width) * std::uint64_t(height);
        if (width <= 1 && height <= 1) return texels * (is_float ? 16 : 4);
    }
}

std::shared_ptr<const shading::PackedTexture> LevelPacker::pack(const MipChain& chain, const shading::TextureKey&,
                                                                MemoryCharge charge) const {
    if (chain.levels.empty()) throw Error(ErrorCode::bad_file, "the picture has no texels");
    const std::uint64_t bytes = bytes_of(chain);
    if (charge.bytes() < bytes) charge.grow(bytes - charge.bytes(), "the texture");
    auto out = std::make_shared<TextureLevels>();
    out->is_srgb = chain.is_srgb, out->is_float = chain.is_float;
    out->width = chain.levels[0].width, out->height = chain.levels[0].height;
    out->mean_green = mean_green(chain.levels.back());
    out->level_count = chain.levels.size();
    out->levels = chain.levels;
    out->charge = std::move(charge);
    return out;
}

GlTexture TextureStore::upload(const Wish& wish, Context& context) const {
    const TextureLevels& of = *wish.levels;
    const std::size_t skipped = levels_beyond(of.levels, driver_.texture_size);
    if (skipped > 0)
        context.report().add(Remark::warning, wish.image->file, wish.image->name,
                             "texture " + drawn_smaller(of.levels[0], driver_));
    GlTexture texture;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, GLint(of.levels.size() - skipped - 1));
    if (wish.is_height)
        upload_heights(of.levels, skipped, driver_.filters_floats ? GL_R32F : GL_R16F);
    else
        upload_levels(of.levels, skipped, of.is_srgb);
    check_gl("a texture");
    return texture;
}

void TextureStore::add(const Wish& wish, Context& context) {
    textures_[{wish.levels.get(), wish.is_height}] = {wish.levels, upload(wish, context)};
}

void TextureStore::keep_only(const std::vector<Wish>& wishes) {
    std::set<std::pair<const TextureLevels*, bool>> wanted;
    for (const Wish& wish : wishes) wanted.emplace(wish.levels.get(), wish.is_height);
    std::erase_if(textures_, [&](const auto& entry) { return !wanted.contains(entry.first); });
    for (const Wish& wish : wishes)
        if (!wish.keeps_levels) wish.levels->levels = {}, wish.levels->charge = {};
}

GLuint TextureStore::find(const TextureLevels& levels, bool is_height) const {
    const auto at = textures_.find({&levels, is_height});
    return at == textures_.end() ? 0 : at->second.texture.name();
}

GLuint TextureStore::sampler(const Sampler& how, bool is_height) {
    Sampler use = how;
    if (is_height) use.magnify = use.minify = Filter::linear;  // a relief has no steps that its texels do not have
    GlSampler& sampler = samplers_[{int(use.wrap_u), int(use.wrap_v), int(use.magnify), int(use.minify), int(use.mip)}];
    if (sampler) return sampler.name();
    const GLuint name = sampler.get();
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, wrap_of(use.wrap_u));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, wrap_of(use.wrap_v));
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, use.magnify == Filter::linear ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, minify_of(use));
    return name;
}

}  // namespace rakelight::opengl
