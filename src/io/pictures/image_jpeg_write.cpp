// SPDX-License-Identifier: Apache-2.0
// JPEG by libjpeg-turbo: quality 95 without chroma subsampling, so that thin bright lines keep their color.
// The library leaves by longjmp on an error, so each function that calls it holds only trivial objects.
#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

#include "io/files/output_file.h"
#include "io/pictures/image_formats.h"

namespace rakelight::io::codec {
namespace {

constexpr int quality = 95;

struct JpegEncoder {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    std::jmp_buf escape;
    char message[JMSG_LENGTH_MAX] = {};

    JpegEncoder() = default;
    JpegEncoder(const JpegEncoder&) = delete;
    JpegEncoder& operator=(const JpegEncoder&) = delete;
    ~JpegEncoder() { jpeg_destroy_compress(&info); }
};

[[noreturn]] void leave(j_common_ptr info) {
    auto* encoder = static_cast<JpegEncoder*>(info->client_data);
    info->err->format_message(info, encoder->message);
    std::longjmp(encoder->escape, 1);
}

bool start(JpegEncoder& encoder, std::FILE* file, unsigned width, unsigned height, bool gray,
           const std::string& comment) {
    if (setjmp(encoder.escape) != 0) return false;
    encoder.info.err = jpeg_std_error(&encoder.errors);
    encoder.errors.error_exit = leave;
    encoder.info.client_data = &encoder;
    jpeg_create_compress(&encoder.info);
    jpeg_stdio_dest(&encoder.info, file);
    encoder.info.image_width = width;
    encoder.info.image_height = height;
    encoder.info.input_components = gray ? 1 : 3;
    encoder.info.in_color_space = gray ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&encoder.info);
    jpeg_set_quality(&encoder.info, quality, TRUE);
    encoder.info.comp_info[0].h_samp_factor = encoder.info.comp_info[0].v_samp_factor = 1;  // 4:4:4
    jpeg_start_compress(&encoder.info, TRUE);
    if (!comment.empty())
        jpeg_write_marker(&encoder.info, JPEG_COM, reinterpret_cast<const JOCTET*>(comment.data()),
                          unsigned(comment.size()));
    return true;
}

bool put_row(JpegEncoder& encoder, unsigned char* row) {
    if (setjmp(encoder.escape) != 0) return false;
    JSAMPROW rows[] = {row};
    return jpeg_write_scanlines(&encoder.info, rows, 1) == 1;
}

bool end(JpegEncoder& encoder) {
    if (setjmp(encoder.escape) != 0) return false;
    jpeg_finish_compress(&encoder.info);
    return true;
}

class JpegWriter final : public ImageWriter {
public:
    JpegWriter(const OutputTarget& target, int width, int height, int channels)
        : path_(target.path),
          width_(width),
          channels_(channels),
          file_(target),
          row_(std::size_t(width) * (channels < 3 ? 1 : 3)) {
        if (width > JPEG_MAX_DIMENSION || height > JPEG_MAX_DIMENSION)
            throw Error(ErrorCode::usage, "a JPEG picture has at most 65500 pixels per side").with_file(path_);
        require(start(encoder_, file_.handle(), unsigned(width), unsigned(height), channels < 3, target.comment));
    }

    void write_row(const void* row) override {
        const auto* from = static_cast<const unsigned char*>(row);
        unsigned char* to = row_.data();
        for (int x = 0; x < width_; ++x, from += channels_)
            for (int c = 0; c < (channels_ < 3 ? 1 : 3); ++c) *to++ = from[c];
        require(put_row(encoder_, row_.data()));
    }

    void finish(Sync sync) override {
        require(end(encoder_));
        file_.commit(sync);
    }

private:
    void require(bool done) const {
        if (!done)
            throw Error(ErrorCode::failed, std::string("cannot be written: ") + encoder_.message).with_file(path_);
    }

    std::string path_;
    int width_, channels_;
    OutputFile file_;  // outlives the encoder that holds its handle
    JpegEncoder encoder_;
    std::vector<unsigned char> row_;
};

std::unique_ptr<ImageWriter> write_jpeg(const OutputTarget& target, int width, int height, int channels, Component) {
    return std::make_unique<JpegWriter>(target, width, height, channels);
}

}  // namespace

constinit const WritableFormat writable_jpeg = {.write = write_jpeg};

}  // namespace rakelight::io::codec
