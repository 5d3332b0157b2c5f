// SPDX-License-Identifier: Apache-2.0
// Animated WebP by libwebpmux, without loss.
#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>
#include <memory>

#include "io/files/file.h"
#include "io/files/output_file.h"
#include "io/movie/movie_formats.h"
#include "io/pictures/image_io.h"

namespace rakelight::io {
namespace {

Error not_encoded(const std::string& why) {
    return Error(ErrorCode::failed, "cannot be encoded as WebP" + (why.empty() ? "" : ": " + why));
}

class Encoder {
public:
    explicit Encoder(const PngHeader& header) : encoder_(nullptr, WebPAnimEncoderDelete) {
        WebPAnimEncoderOptions options;
        if (!WebPAnimEncoderOptionsInit(&options) || !WebPConfigInit(&config_) ||
            !WebPConfigLosslessPreset(&config_, 1))  // as single pictures: higher levels take many times as long
            throw Error(ErrorCode::failed, "libwebpmux does not match its headers");
        config_.exact = 1;  // colors under alpha 0 are kept
        encoder_.reset(WebPAnimEncoderNew(int(header.width), int(header.height), &options));
        if (!encoder_) throw not_encoded("out of memory");
    }

    void add(const Pixels& pixels, int begin_ms) {
        struct Picture : WebPPicture {
            Picture() { WebPPictureInit(this); }
            ~Picture() { WebPPictureFree(this); }
        } picture;
        picture.use_argb = 1, picture.width = pixels.width, picture.height = pixels.height;
        const std::vector<std::uint8_t> rgba = rgba_of(pixels);
        if (!WebPPictureImportRGBA(&picture, rgba.data(), 4 * pixels.width)) throw not_encoded("out of memory");
        require(WebPAnimEncoderAdd(encoder_.get(), &picture, begin_ms, &config_));
    }

    void write(OutputFile& out, int end_ms) {
        require(WebPAnimEncoderAdd(encoder_.get(), nullptr, end_ms, nullptr));
        struct Data : WebPData {
            Data() { WebPDataInit(this); }
            ~Data() { WebPDataClear(this); }
        } data;
        require(WebPAnimEncoderAssemble(encoder_.get(), &data));
        out.write(std::as_bytes(std::span(data.bytes, data.size)));
    }

private:
    static std::vector<std::uint8_t> rgba_of(const Pixels& pixels) {
        const auto channels = std::size_t(pixels.channels);
        const bool is_gray = channels < 3, has_alpha = channels % 2 == 0;
        std::vector<std::uint8_t> rgba;
        rgba.reserve(4 * std::size_t(pixels.width) * std::size_t(pixels.height));
        for (std::size_t at = 0; at + channels <= pixels.bytes.size(); at += channels) {
            const auto byte = [&](std::size_t k) { return std::uint8_t(pixels.bytes[at + k]); };
            rgba.insert(rgba.end(), {byte(0), byte(is_gray ? 0 : 1), byte(is_gray ? 0 : 2),
                                     has_alpha ? byte(channels - 1) : std::uint8_t(255)});
        }
        return rgba;
    }
    void require(int is_done) {
        if (!is_done) throw not_encoded(WebPAnimEncoderGetError(encoder_.get()));
    }

    WebPConfig config_{};
    std::unique_ptr<WebPAnimEncoder, void (*)(WebPAnimEncoder*)> encoder_;
};

void write_webp_movie(const std::string& path, const MoviePictures& pictures, Context& context) {
    OutputFile out(path);
    const auto ms_of = [&](std::size_t i) {
        const double ms = std::round(1000 * double(i) / pictures.fps);
        if (ms > 0x7fffffff) throw not_encoded("it would last longer than 24 days");
        return int(ms);
    };
    try {
        Encoder encoder(pictures.header);
        for (std::size_t i = 0; i < pictures.files.size(); ++i) {
            context.throw_if_cancelled();
            context.progress("movie", double(i) / double(pictures.files.size()));
            const Bytes file = read_file(pictures.files[i], context);
            try {
                encoder.add(decode_image(*file, context), ms_of(i));
            } catch (const Error& error) {
                throw error.code() == ErrorCode::bad_file ? error.with_file(pictures.files[i]) : error;
            }
        }
        encoder.write(out, ms_of(pictures.files.size()));
    } catch (const Error& error) {
        throw error.with_file(path);
    }
    out.commit();
}

}  // namespace

constinit const MovieFormat webp_movie = {.ending = "webp", .most_side = 16383, .write = write_webp_movie};

}  // namespace rakelight::io
