// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/textures.h"

#include "base/format_text.h"
#include "io/pictures/image_io.h"

namespace rakelight::io::gltf {
namespace {

Wrap wrap_of(const Value& sampler, const char* name, const Document& document) {
    switch (sampler.count(name, 10497)) {
        case 10497:
            return Wrap::repeat;
        case 33648:
            return Wrap::mirrored_repeat;
        case 33071:
            return Wrap::clamp_to_edge;
    }
    document.remark(Remark::guessed, sampler.place(), std::string(name) + " is unknown; taken as repeat");
    return Wrap::repeat;
}

void set_minification(Sampler& result, const Value& sampler, const Document& document) {
    switch (sampler.count("minFilter", 9987)) {
        case 9728:
            result.minify = Filter::nearest, result.mip = MipFilter::none;
            return;
        case 9729:
            result.minify = Filter::linear, result.mip = MipFilter::none;
            return;
        case 9984:
            result.minify = Filter::nearest, result.mip = MipFilter::nearest;
            return;
        case 9985:
            result.minify = Filter::linear, result.mip = MipFilter::nearest;
            return;
        case 9986:
            result.minify = Filter::nearest, result.mip = MipFilter::linear;
            return;
        case 9987:
            return;
    }
    document.remark(Remark::guessed, sampler.place(), "minFilter is unknown; taken as linear with mip maps");
}

TextureTransform transform_of(const Value& extension) {
    TextureTransform transform;
    if (const auto offset = extension.numbers<2>("offset"))
        transform.offset = {float((*offset)[0]), float((*offset)[1])};
    if (const auto scale = extension.numbers<2>("scale")) transform.scale = {float((*scale)[0]), float((*scale)[1])};
    transform.rotation_rad = extension.real("rotation", 0);
    return transform;
}

constexpr std::uint32_t max_texcoord_set = 7;

}  // namespace

TextureUse Textures::use(const Value& owner, const char* name) {
    const Value info = owner.object(name);
    TextureUse result;
    if (!info) return result;
    read_or_drop(document_, std::string(name), [&] {
        TextureUse use;
        std::uint64_t set = info.count("texCoord", 0);
        if (const Value transform = info.extension("KHR_texture_transform")) {
            use.transform = transform_of(transform);
            set = transform.count("texCoord", set);
        }
        if (set > max_texcoord_set) info.fail(format_text("texture coordinate set {} is more than 7", set));
        use.texcoord_set = std::uint32_t(set);
        use.texture = load(info.required_index("index"), info);
        result = use;
    });
    return result.texture == no_index ? TextureUse{} : result;
}

std::uint32_t Textures::load(std::uint32_t index, const Value& from) {
    if (const auto known = textures_.find(index); known != textures_.end()) return known->second;
    textures_[index] = no_index;  // what fails once is not tried again
    const Value texture = document_.element(texture_kind, index, from);
    std::uint32_t source = texture.extension("EXT_texture_webp").index("source");
    if (source == no_index) source = texture.index("source");
    if (source == no_index)
        texture.fail(texture.extension("KHR_texture_basisu")
                         ? "its only image is KHR_texture_basisu, which is not supported"
                         : "it has no image");
    Texture result;
    result.name = Document::name_of(texture, texture_kind, index);
    result.image = image(source, texture);
    if (const std::uint32_t sampler_index = texture.index("sampler"); sampler_index != no_index)
        result.sampler = sampler(sampler_index, texture);
    scene_.textures.push_back(std::move(result));
    return textures_[index] = std::uint32_t(scene_.textures.size() - 1);
}

ImageHandle Textures::image(std::uint32_t index, const Value& from) {
    if (const auto known = images_.find(index); known != images_.end()) {
        if (!known->second) from.fail(format_text("image {} could not be used", index));
        return known->second;
    }
    images_[index] = nullptr;
    const Value image = document_.element(image_kind, index, from);
    const std::string name = Document::name_of(image, image_kind, index), mime_type = image.text("mimeType");
    const std::string* uri = image.text_pointer("uri");
    ImageHandle handle;
    if (!uri) {
        handle = image_in_view(image.required_index("bufferView"), name, image);
    } else if (const auto embedded = decode_data_uri(*uri, image, document_.context())) {
        handle = image_from_bytes(name, document_.path(), *embedded, mime_type);
    } else {
        handle = image_in_file(*uri, image.has("name") ? name : *uri, image);
    }
    return images_[index] = std::move(handle);
}

ImageHandle Textures::image_in_view(std::uint32_t view, std::string name, const Value& image) {
    ImageHandle& known = views_[view];
    if (known) return known;
    const Region region = buffers_.view(view, image);
    MemoryCharge charge(document_.context().memory(), region.bytes.size(), "an embedded image");
    Bytes bytes = charged_bytes({region.bytes.begin(), region.bytes.end()}, std::move(charge));
    return known = image_from_bytes(std::move(name), document_.path(), std::move(bytes), image.text("mimeType"));
}

ImageHandle Textures::image_in_file(const std::string& uri, std::string name, const Value& image) {
    const std::string path = resolve_uri(document_, uri, image);
    ImageHandle& known = files_[path];
    if (known) return known;
    const auto slash = uri.find_last_of("/\\");
    const std::string last = slash == std::string::npos ? uri : uri.substr(slash + 1);
    if (!is_regular_file(path)) image.fail("the file '" + one_line(last, 80) + "' is missing or no regular file");
    return known = image_from_file(std::move(name), document_.path(), path);
}

Sampler Textures::sampler(std::uint32_t index, const Value& from) const {
    const Value sampler = document_.element(sampler_kind, index, from);
    Sampler result;
    result.wrap_u = wrap_of(sampler, "wrapS", document_);
    result.wrap_v = wrap_of(sampler, "wrapT", document_);
    const std::uint64_t magnify = sampler.count("magFilter", 9729);
    if (magnify == 9728)
        result.magnify = Filter::nearest;
    else if (magnify != 9729)
        document_.remark(Remark::guessed, sampler.place(), "magFilter is unknown; taken as linear");
    set_minification(result, sampler, document_);
    return result;
}

}  // namespace rakelight::io::gltf
