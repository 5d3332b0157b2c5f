// SPDX-License-Identifier: Apache-2.0
// Which format a picture has, and the lazy decoding that scenes carry.
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/pictures/image_codecs.h"
#include "io/pictures/reduced_image.h"

namespace rakelight::io {
namespace codec {

void bad_picture(const std::string& reason, const std::string& advice) {
    throw Error(ErrorCode::bad_file, reason, {}, advice);
}

Pixels make_pixels(std::uint64_t width, std::uint64_t height, int channels, Component component, Want want,
                   Context& context) {
    if (width == 0 || height == 0) bad_picture("the picture has no pixels");
    if (width > max_side || height > max_side)
        bad_picture(format_text("the picture is {} x {} pixels, more than {} per side", width, height, max_side));
    Pixels pixels{int(width), int(height), channels, component, false, {}};
    if (want == Want::header) return pixels;
    const std::uint64_t size = std::uint64_t(pixels.row_bytes()) * height;
    pixels.charge = share(MemoryCharge(context.memory(), size, "the picture"));
    pixels.bytes.resize(std::size_t(size));
    return pixels;
}

namespace {

bool begins_with(std::span<const std::byte> bytes, std::string_view magic) {
    return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

/// Formats that occur in models but are not read here are named in the message.
void refuse_known_formats(std::span<const std::byte> bytes) {
    using namespace std::string_view_literals;
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> known{
        {{"GIF8"sv, "GIF"sv},
         {"\xabKTX"sv, "KTX"sv},
         {"DDS "sv, "DDS"sv},
         {"II*\0"sv, "TIFF"sv},
         {"MM\0*"sv, "TIFF"sv},
         {"8BPS"sv, "Photoshop"sv},
         {"sB\x13\0"sv, "Basis"sv},
         {"\0\0\0\x0cJXL "sv, "JPEG XL"sv}}};
    for (const auto& [magic, name] : known)
        if (begins_with(bytes, magic))
            bad_picture("pictures in " + std::string(name) + " format are not supported", "convert it to PNG or JPEG");
}

}  // namespace

PictureReader reader_of(std::span<const std::byte> bytes) {
    if (bytes.empty()) bad_picture("is not a picture: it is empty");
    if (begins_with(bytes, "\x89PNG\r\n\x1a\n")) return read_png;
    if (begins_with(bytes, "\xff\xd8\xff")) return read_jpeg;
    if (begins_with(bytes, "RIFF") && bytes.size() >= 12 && begins_with(bytes.subspan(8), "WEBP")) return read_webp;
    if (begins_with(bytes, "\x76\x2f\x31\x01")) return read_exr;
    if (begins_with(bytes, "#?")) return read_hdr;
    if (begins_with(bytes, "BM")) return read_bmp;
    refuse_known_formats(bytes);
    if (may_be_tga(bytes)) return read_tga;
    bad_picture("is not a picture of a known format");
}

}  // namespace codec

namespace {

using codec::Want;

constexpr int any_side = 0;

/// @param most_side  [px] of codec::read_reduced(); any_side: the picture as it is
Pixels read(std::span<const std::byte> bytes, Want want, int most_side, Context& context) {
    context.throw_if_cancelled();
    if (most_side != any_side) return codec::read_reduced(bytes, most_side, want, context);
    return codec::reader_of(bytes)(bytes, want, context);
}

/// The picture of a file of its own, or of a part of the model's file.
Pixels read_image(const EncodedImage& image, Want want, int most_side, Context& context) {
    try {
        if (image.bytes) return read(*image.bytes, want, most_side, context);
        return read(*read_file(image.path, context, want == Want::pixels), want, most_side, context);
    } catch (const Error& error) {
        throw image.bytes ? error.at(image.name).with_file(image.file) : error.with_file(image.path);
    }
}

template <Want want>
Pixels read_whole(const EncodedImage& image, Context& context) {
    return read_image(image, want, any_side, context);
}

bool is_of_file(const EncodedImage& image) {
    const auto* const decoder = image.decode.target<Pixels (*)(const EncodedImage&, Context&)>();
    return decoder && *decoder == read_whole<Want::pixels>;
}

}  // namespace

std::uint64_t decoding_work(const EncodedImage& image, int most_side, Context& context) {
    if (!is_of_file(image)) return 0;
    try {
        if (image.bytes) return codec::reduced_work(*image.bytes, most_side, context);
        return codec::reduced_work(*read_file(image.path, context, true), most_side, context);
    } catch (const Error&) {  // told when it is decoded
        context.throw_if_cancelled();
        return 0;
    }
}

bool has_alpha(const EncodedImage& image, Context& context) {
    if (!image.measure) return true;
    try {
        return image.measure(image, context).channels % 2 == 0;
    } catch (const Error&) {  // told when it is decoded
        context.throw_if_cancelled();
        return false;
    }
}

ImageHandle reduced_image(const ImageHandle& image, int most_side) {
    if (!is_of_file(*image)) return image;
    EncodedImage reduced = *image;
    reduced.decode = [most_side](const EncodedImage& i, Context& c) {
        return read_image(i, Want::pixels, most_side, c);
    };
    reduced.measure = [most_side](const EncodedImage& i, Context& c) {
        return read_image(i, Want::header, most_side, c);
    };
    return std::make_shared<const EncodedImage>(std::move(reduced));
}

Pixels decode_image(std::span<const std::byte> bytes, Context& context) {
    return read(bytes, Want::pixels, any_side, context);
}

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

}  // namespace rakelight::io
