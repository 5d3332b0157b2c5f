// SPDX-License-Identifier: Apache-2.0
// Pictures of scenes, decoded when they are needed; and pictures written.
#include "io/pictures/image_io.h"

#include <algorithm>
#include <utility>

#include <rakelight_internal/base/file_ending.h>

#include "base/format_text.h"
#include "io/pictures/image_formats.h"

namespace rakelight::io {
namespace {

using codec::Want;

Pixels read(std::span<const std::byte> bytes, Want want, Context& context) {
    context.throw_if_cancelled();
    return codec::readable_format(bytes).read(bytes, want, context);
}

template <Want want>
Pixels read_whole(const EncodedImage& image, Context& context) {
    try {
        return read(*bytes_of(image, context, want == Want::pixels), want, context);
    } catch (const Error& error) {
        throw named(error, image);
    }
}

constexpr int max_written_side = 65536;

void check_written_size(const std::string& path, int width, int height, std::size_t channels, std::size_t most) {
    if (width < 1 || height < 1 || width > max_written_side || height > max_written_side || channels < 1 ||
        channels > most)
        throw Error(ErrorCode::usage, format_text("a picture of {} x {} pixels with {} channels cannot be written",
                                                  width, height, channels))
            .with_file(path);
}

}  // namespace

ImageHandle image_from_file(std::string name, std::string model_file, std::string path, std::string place) {
    return std::make_shared<const EncodedImage>(EncodedImage{std::move(name),
                                                             std::move(model_file),
                                                             std::move(path),
                                                             nullptr,
                                                             {},
                                                             read_whole<Want::pixels>,
                                                             std::move(place),
                                                             read_whole<Want::header>});
}

ImageHandle image_from_bytes(std::string name, std::string model_file,
                             std::shared_ptr<const std::vector<std::byte>> bytes, std::string mime_type) {
    if (!bytes) bytes = std::make_shared<const std::vector<std::byte>>();
    return std::make_shared<const EncodedImage>(EncodedImage{std::move(name),
                                                             std::move(model_file),
                                                             {},
                                                             std::move(bytes),
                                                             std::move(mime_type),
                                                             read_whole<Want::pixels>,
                                                             {},
                                                             read_whole<Want::header>});
}

bool is_of_file(const EncodedImage& image) {
    const auto* const decoder = image.decode.target<Pixels (*)(const EncodedImage&, Context&)>();
    return decoder && *decoder == read_whole<Want::pixels>;
}

Bytes bytes_of(const EncodedImage& image, Context& context, bool is_told) {
    return image.bytes ? image.bytes : read_file(image.path, context, is_told);
}

Error named(const Error& error, const EncodedImage& image) {
    return image.bytes ? error.at(image.name).with_file(image.file) : error.with_file(image.path);
}

Pixels decode_image(std::span<const std::byte> bytes, Context& context) { return read(bytes, Want::pixels, context); }

Component component_for(const std::string& path) { return codec::writable_format(path).component; }

std::unique_ptr<ImageWriter> make_image_writer(const OutputTarget& target, int width, int height, int channels,
                                               Component component) {
    const codec::WritableFormat& format = codec::writable_format(target.path);
    if (component != format.component && !(component == Component::u16 && format.takes_u16))
        throw Error(ErrorCode::usage, "a ." + file_ending(target.path) + " picture cannot hold such components")
            .with_file(target.path);
    check_written_size(target.path, width, height, std::size_t(std::max(channels, 0)), 4);
    return format.write(target, width, height, channels, component);
}

std::unique_ptr<ImageWriter> make_exr_writer(const OutputTarget& target, int width, int height,
                                             std::vector<ExrChannel> channels) {
    check_written_size(target.path, width, height, channels.size(), 1024);
    if (target.place.width != 0)
        check_written_size(target.path, target.place.width, target.place.height, channels.size(), 1024);
    return codec::writable_exr.write_channels(target, width, height, std::move(channels));
}

void write_image(OutputTarget target, const Pixels& pixels, Sync sync) {
    target.is_data |= pixels.is_linear;
    const auto writer = make_image_writer(target, pixels.width, pixels.height, pixels.channels, pixels.component);
    for (int y = 0; y < pixels.height; ++y) writer->write_row(pixels.row(y));
    writer->finish(sync);
}

}  // namespace rakelight::io
