// SPDX-License-Identifier: Apache-2.0
// JPEG by libjpeg-turbo: gray or RGB, 8 bits. The EXIF orientation is not applied (glTF 2.0, section 3.8.3.1).
// The library leaves by longjmp on an error, so each function that calls it holds only trivial objects.
#include <csetjmp>
#include <cstdio>
#include <cstring>

#include <jpeglib.h>

#include <jerror.h>

#include <algorithm>
#include <limits>

#include "io/pictures/block_means.h"
#include "io/pictures/image_formats.h"

namespace rakelight::io::codec {
namespace {

// Every scan of a progressive file is a pass over the whole picture, however few bytes it takes; real ones have about ten.
constexpr int max_scans = 100;

struct JpegReader {
    jpeg_decompress_struct info{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf escape;
    const Context* context = nullptr;
    char message[JMSG_LENGTH_MAX] = {};

    JpegReader() = default;
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;
    ~JpegReader() { jpeg_destroy_decompress(&info); }  // safe in any state
};

[[noreturn]] void leave(j_common_ptr info) {
    auto* reader = static_cast<JpegReader*>(info->client_data);
    info->err->format_message(info, reader->message);
    std::longjmp(reader->escape, 1);
}

/// Warnings that mean damaged or missing pixels are errors here; sloppy but harmless files are read.
void on_message(j_common_ptr info, int level) {
    if (level >= 0) return;
    switch (info->err->msg_code) {
        case JWRN_JPEG_EOF:
        case JWRN_HIT_MARKER:
        case JWRN_HUFF_BAD_CODE:
        case JWRN_ARITH_BAD_CODE:
        case JWRN_MUST_RESYNC:
            leave(info);
        default:
            break;
    }
}

void on_progress(j_common_ptr info) {
    auto* reader = static_cast<JpegReader*>(info->client_data);
    if (reader->context->cancelled()) std::longjmp(reader->escape, 1);
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= max_scans) return;
    std::snprintf(reader->message, sizeof(reader->message), "more than %d scans", max_scans);
    std::longjmp(reader->escape, 1);
}

bool read_header(JpegReader& reader, const unsigned char* bytes, unsigned long size, long max_memory) {
    if (setjmp(reader.escape) != 0) return false;
    reader.info.err = jpeg_std_error(&reader.errors);
    reader.errors.error_exit = leave;
    reader.errors.emit_message = on_message;
    reader.info.client_data = &reader;
    jpeg_create_decompress(&reader.info);
    reader.info.mem->max_memory_to_use = max_memory;
    reader.progress.progress_monitor = on_progress;
    reader.info.progress = &reader.progress;
    jpeg_mem_src(&reader.info, bytes, size);
    jpeg_read_header(&reader.info, TRUE);
    return true;
}

bool is_cmyk(const jpeg_decompress_struct& info) {
    return info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK;
}

/// Adobe writes inks inverted (255 is none), others upright.
void rgb_from_cmyk(const unsigned char* cmyk, unsigned char* rgb, unsigned width, bool inverted) {
    for (unsigned x = 0; x < width; ++x, cmyk += 4, rgb += 3) {
        const unsigned flip = inverted ? 0 : 255, white = cmyk[3] ^ flip;
        for (int c = 0; c < 3; ++c) rgb[c] = static_cast<unsigned char>(((cmyk[c] ^ flip) * white + 127) / 255);
    }
}

/// @param cmyk  room for one row of four components, null for other color spaces
bool read_rows(JpegReader& reader, unsigned char* pixels, std::size_t row_bytes, unsigned char* cmyk) {
    if (setjmp(reader.escape) != 0) return false;
    reader.info.dct_method = JDCT_ISLOW;  // the exact one: the same bits with and without SIMD
    reader.info.do_block_smoothing = FALSE;
    jpeg_start_decompress(&reader.info);
    while (reader.info.output_scanline < reader.info.output_height) {
        unsigned char* const out = pixels + row_bytes * reader.info.output_scanline;
        JSAMPROW row = cmyk != nullptr ? cmyk : out;
        if (jpeg_read_scanlines(&reader.info, &row, 1) == 1 && cmyk != nullptr)
            rgb_from_cmyk(cmyk, out, reader.info.output_width, reader.info.saw_Adobe_marker != FALSE);
    }
    return true;
}

/// The memory that the library itself allocates: all coefficients if the file has several scans.
std::uint64_t coefficient_bytes(jpeg_decompress_struct& info) {
    std::uint64_t blocks = 0;
    if (jpeg_has_multiple_scans(&info))
        for (int c = 0; c < info.num_components; ++c)
            blocks += std::uint64_t(info.comp_info[c].width_in_blocks) * info.comp_info[c].height_in_blocks;
    return blocks * sizeof(JBLOCK);
}

[[noreturn]] void broken(const JpegReader& reader) {
    reader.context->throw_if_cancelled();
    bad_picture(std::string("broken JPEG: ") + reader.message);
}

/// @param scale  1, 2, 4 or 8: blocks of 8 x 8 pixels become blocks of 8 / scale
Pixels read(std::span<const std::byte> bytes, Want want, unsigned scale, Context& context) {
    JpegReader reader;
    reader.context = &context;
    const long max_memory = long(std::min<std::uint64_t>(context.memory().limit(), std::numeric_limits<long>::max()));
    if (!read_header(reader, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), max_memory))
        broken(reader);
    const bool cmyk = is_cmyk(reader.info), gray = reader.info.jpeg_color_space == JCS_GRAYSCALE;
    reader.info.out_color_space = cmyk ? JCS_CMYK : gray ? JCS_GRAYSCALE : JCS_RGB;
    context.memory().check(coefficient_bytes(reader.info), "the picture while it is decoded");
    reader.info.scale_num = 1, reader.info.scale_denom = scale;
    const auto side = [scale](std::uint64_t size) { return (size + scale - 1) / scale; };  // as the library's
    Pixels pixels = make_pixels(side(reader.info.image_width), side(reader.info.image_height), gray ? 1 : 3,
                                Component::u8, want, context);
    if (want == Want::header) return pixels;
    std::vector<unsigned char> inks(cmyk ? std::size_t(pixels.width) * 4 : 0);
    auto* out = reinterpret_cast<unsigned char*>(pixels.bytes.data());
    if (!read_rows(reader, out, pixels.row_bytes(), cmyk ? inks.data() : nullptr)) broken(reader);
    return pixels;
}

Pixels read_jpeg(std::span<const std::byte> bytes, Want want, Context& context) {
    return read(bytes, want, 1, context);
}

/// Whether all coefficients of the file are decoded before the first pixel is.
bool has_several_scans(std::span<const std::byte> bytes, Context& context) {
    JpegReader reader;
    reader.context = &context;
    if (!read_header(reader, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), 0)) broken(reader);
    return jpeg_has_multiple_scans(&reader.info) != FALSE;
}

std::uint64_t work_of_jpeg(const Pixels& header, std::span<const std::byte> bytes, int factor, Context& context) {
    const std::uint64_t pixels = std::uint64_t(header.width) * std::uint64_t(header.height);
    return has_several_scans(bytes, context) ? pixels : pixels / (factor > 1 ? 4 : 2);
}

Pixels read_reduced_jpeg(std::span<const std::byte> bytes, int factor, Context& context) {
    const int scale = std::min(factor, 8);
    Pixels pixels = read(bytes, Want::pixels, unsigned(scale), context);
    if (factor == scale) return pixels;
    return block_means(
        pixels, factor / scale, [&pixels](int y) { return pixels.row(y); }, context);
}

}  // namespace

constinit const ReadableFormat readable_jpeg = {
    .read = read_jpeg, .read_reduced = read_reduced_jpeg, .work = work_of_jpeg};

}  // namespace rakelight::io::codec
