// SPDX-License-Identifier: Apache-2.0
// WebP by libwebp: RGB or RGBA with 8 bits; written without loss.
#include <webp/decode.h>
#include <webp/encode.h>

#include <cstring>

#include "io/files/output_file.h"
#include "io/pictures/image_formats.h"

namespace rakelight::io::codec {
namespace {

const std::uint8_t* data_of(std::span<const std::byte> bytes) {
    return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

const char* text_of(VP8StatusCode status) {
    switch (status) {
        case VP8_STATUS_OUT_OF_MEMORY:
            return "out of memory";
        case VP8_STATUS_SUSPENDED:
        case VP8_STATUS_NOT_ENOUGH_DATA:
            return "it ends too early";
        case VP8_STATUS_UNSUPPORTED_FEATURE:
            return "it uses an unsupported feature";
        default:
            return "its data are damaged";
    }
}

void require(VP8StatusCode status) {
    if (status != VP8_STATUS_OK) bad_picture(std::string("broken WebP: ") + text_of(status));
}

/// Collects the rows, because the encoder wants the whole picture at once.
class WebpWriter final : public ImageWriter {
public:
    WebpWriter(const OutputTarget& target, int width, int height, int channels)
        : path_(target.path), width_(width), height_(height), channels_(channels), file_(target) {
        if (width > WEBP_MAX_DIMENSION || height > WEBP_MAX_DIMENSION)
            throw Error(ErrorCode::usage, "a WebP picture has at most 16383 pixels per side").with_file(target.path);
        rgba_.reserve(std::size_t(width) * std::size_t(height) * 4);
    }

    void write_row(const void* row) override {
        const auto* from = static_cast<const std::uint8_t*>(row);
        const bool gray = channels_ < 3, has_alpha = channels_ % 2 == 0;
        for (int x = 0; x < width_; ++x, from += channels_) {
            const std::uint8_t alpha = has_alpha ? from[channels_ - 1] : 255;
            rgba_.insert(rgba_.end(), {from[0], gray ? from[0] : from[1], gray ? from[0] : from[2], alpha});
        }
    }

    void finish(Sync sync) override {
        if (rgba_.size() != std::size_t(width_) * std::size_t(height_) * 4)
            throw Error(ErrorCode::failed, "the picture is not complete").with_file(path_);
        struct Encoded {
            WebPPicture picture;
            WebPMemoryWriter memory;
            Encoded() {
                WebPPictureInit(&picture);
                WebPMemoryWriterInit(&memory);
            }
            ~Encoded() {
                WebPPictureFree(&picture);
                WebPMemoryWriterClear(&memory);
            }
        } encoded;
        WebPConfig config;
        WebPConfigInit(&config);
        WebPConfigLosslessPreset(&config, 1);  // higher levels take many times as long for a few percent
        config.exact = 1;                      // colors under alpha 0 are kept
        encoded.picture.use_argb = 1;
        encoded.picture.width = width_;
        encoded.picture.height = height_;
        encoded.picture.writer = WebPMemoryWrite;
        encoded.picture.custom_ptr = &encoded.memory;
        if (!WebPPictureImportRGBA(&encoded.picture, rgba_.data(), width_ * 4) ||
            !WebPEncode(&config, &encoded.picture))
            throw Error(ErrorCode::failed, "cannot be encoded as WebP").with_file(path_);
        file_.write(std::as_bytes(std::span(encoded.memory.mem, encoded.memory.size)));
        file_.commit(sync);
    }

private:
    std::string path_;
    int width_, height_, channels_;
    OutputFile file_;
    std::vector<std::uint8_t> rgba_;
};

Pixels read_webp(std::span<const std::byte> bytes, Want want, Context& context) {
    WebPDecoderConfig config;
    if (!WebPInitDecoderConfig(&config)) throw Error(ErrorCode::failed, "libwebp does not match its headers");
    require(WebPGetFeatures(data_of(bytes), bytes.size(), &config.input));
    if (config.input.has_animation) bad_picture("animated WebP is not supported");
    const bool alpha = config.input.has_alpha != 0;
    const std::uint64_t width = std::uint64_t(config.input.width), height = std::uint64_t(config.input.height);
    Pixels pixels = make_pixels(width, height, alpha ? 4 : 3, Component::u8, want, context);
    if (want == Want::header) return pixels;
    context.memory().check(width * height * 4, "the picture while it is decoded");  // what the lossless decoder keeps
    config.output.colorspace = alpha ? MODE_RGBA : MODE_RGB;
    config.output.is_external_memory = 1;
    config.output.u.RGBA.rgba = reinterpret_cast<std::uint8_t*>(pixels.bytes.data());
    config.output.u.RGBA.stride = int(pixels.row_bytes());
    config.output.u.RGBA.size = pixels.bytes.size();
    const VP8StatusCode status = WebPDecode(data_of(bytes), bytes.size(), &config);
    WebPFreeDecBuffer(&config.output);
    require(status);
    return pixels;
}

std::uint64_t work_of_webp(const Pixels& header, std::span<const std::byte> bytes, int, Context&) {
    constexpr int lossless = 2;  // WebPBitstreamFeatures::format
    WebPBitstreamFeatures features{};
    const bool is_lossless =
        WebPGetFeatures(data_of(bytes), bytes.size(), &features) == VP8_STATUS_OK && features.format == lossless;
    const std::uint64_t values =
        std::uint64_t(header.width) * std::uint64_t(header.height) * std::uint64_t(header.channels);
    return is_lossless ? values / 2 : values / 4;
}

std::unique_ptr<ImageWriter> write_webp(const OutputTarget& target, int width, int height, int channels, Component) {
    return std::make_unique<WebpWriter>(target, width, height, channels);
}

}  // namespace

constinit const ReadableFormat readable_webp = {.read = read_webp, .work = work_of_webp};
constinit const WritableFormat writable_webp = {.write = write_webp};

}  // namespace rakelight::io::codec
