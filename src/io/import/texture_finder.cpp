// SPDX-License-Identifier: Apache-2.0
#include "io/import/texture_finder.h"

#include <algorithm>
#include <filesystem>

#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/pictures/image_io.h"

namespace rakelight::io {
namespace {

using import_stream::nothing;
using import_stream::Picture;
using import_stream::TextureLink;
using import_stream::WrapMode;

constexpr std::size_t most_entries = 20000;  // of a folder that is searched

std::string bare_name(const std::string& reference) {
    const std::size_t slash = reference.find_last_of("/\\");
    return slash == std::string::npos ? reference : reference.substr(slash + 1);
}

std::optional<std::string> existing(const std::string& model, const std::string& reference, bool allow_outside) {
    try {
        std::string path = resolve_reference(model, reference, allow_outside);
        if (is_regular_file(path)) return path;
    } catch (const Error&) {  // it would leave the folder: as if it were not there
    }
    return std::nullopt;
}

/// The entry of the model's folder that equals `name` except for the case of its letters; the first in order of bytes.
std::optional<std::string> in_any_case(const std::string& model, const std::string& name) {
    namespace fs = std::filesystem;
    std::error_code problem;
    const fs::path folder = fs::path(model).has_parent_path() ? fs::path(model).parent_path() : fs::path(".");
    std::vector<std::string> found;
    std::size_t seen = 0;
    for (fs::directory_iterator it(folder, problem), end; !problem && it != end && seen < most_entries;
         it.increment(problem), ++seen) {
        std::string entry = it->path().filename().string();
        if (lower_case(entry) == lower_case(name)) found.push_back(std::move(entry));
    }
    if (found.empty()) return std::nullopt;
    return *std::min_element(found.begin(), found.end());
}

std::string mime_of(const Picture& p) {
    const std::string hint = lower_case(p.hint);
    if (hint == "png") return "image/png";
    if (hint == "jpg" || hint == "jpeg") return "image/jpeg";
    if (hint == "webp") return "image/webp";
    return {};
}

Wrap wrap_of(std::uint32_t mode) {
    return mode == std::uint32_t(WrapMode::clamp)    ? Wrap::clamp_to_edge
           : mode == std::uint32_t(WrapMode::mirror) ? Wrap::mirrored_repeat
                                                     : Wrap::repeat;
}

io::Bytes bytes_of(const Picture& p, Context& context) {
    MemoryCharge charge(context.memory(), p.bytes.size(), "a picture");
    std::vector<std::byte> bytes(p.bytes.size());
    std::transform(p.bytes.begin(), p.bytes.end(), bytes.begin(), [](std::uint8_t b) { return std::byte(b); });
    return charged_bytes(std::move(bytes), std::move(charge));
}

/// A picture that the model holds as plain pixels: nothing to decode but a copy.
ImageHandle raw_image(std::string name, const std::string& model, Picture& p, Context& context) {
    auto image = std::make_shared<EncodedImage>();
    image->name = std::move(name);
    image->file = model;
    image->bytes = bytes_of(p, context);
    const Pixels header{int(p.width), int(p.height), 4, Component::u8, false, {}};
    image->measure = [header](const EncodedImage&, Context&) { return header; };
    image->decode = [header](const EncodedImage& self, Context& decoding) {
        Pixels pixels = header;
        pixels.charge = share(MemoryCharge(decoding.memory(), self.bytes->size(), "a picture"));
        pixels.bytes = *self.bytes;
        return pixels;
    };
    return image;
}

}  // namespace

std::optional<std::string> find_texture_file(const std::string& model, const std::string& reference,
                                             bool allow_outside) {
    if (reference.empty()) return std::nullopt;
    if (auto path = existing(model, reference, allow_outside)) return path;
    const std::string name = bare_name(reference);
    if (name.empty() || name == "." || name == "..") return std::nullopt;
    if (auto path = existing(model, name, allow_outside)) return path;
    const auto entry = in_any_case(model, name);
    return entry ? existing(model, *entry, allow_outside) : std::nullopt;
}

ImageHandle TextureTable::embedded(std::uint32_t number) {
    Picture& p = pictures_[number];
    const std::string name =
        format_text("image {}{} (embedded)", number, p.name.empty() ? "" : " '" + one_line(p.name, 80) + "'");
    if (p.bytes.empty() || p.width > 32768 || p.height > 32768) {
        context_.report().add(Remark::warning, model_, name,
                              "an embedded picture is empty or too large and is left out");
        return nullptr;
    }
    if (p.width != 0) return raw_image(name, model_, p, context_);
    return image_from_bytes(name, model_, bytes_of(p, context_), mime_of(p));
}

ImageHandle TextureTable::image(const TextureLink& link) {
    if (link.picture != nothing) return embedded(link.picture);
    if (const auto path = find_texture_file(model_, link.path, allow_outside_))
        return image_from_file(bare_name(*path), model_, *path);
    const std::string why = why_not_found(model_, link.path, "it is left out");
    std::vector<std::string> settings;
    if (why.find("'allow-outside'") != why.npos) settings.emplace_back("allow-outside");
    context_.report().add(Remark::warning, model_, {}, "texture '" + one_line(link.path, 160) + "'" + why,
                          std::move(settings));
    return nullptr;
}

std::uint32_t TextureTable::number(const TextureLink& link) {
    const auto key = std::pair(link.picture, link.picture == nothing ? link.path : std::string());
    auto known = images_.find(key);
    if (known == images_.end()) known = images_.emplace(key, image(link)).first;
    if (!known->second) return no_index;
    const auto place =
        numbers_.emplace(std::tuple(known->second, link.wrap_u, link.wrap_v), std::uint32_t(scene_.textures.size()));
    if (place.second) {
        Sampler sampler;
        sampler.wrap_u = wrap_of(link.wrap_u);
        sampler.wrap_v = wrap_of(link.wrap_v);
        scene_.textures.push_back({known->second->name, known->second, sampler});
    }
    return place.first->second;
}

}  // namespace rakelight::io
