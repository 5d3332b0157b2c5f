// SPDX-License-Identifier: Apache-2.0
// PNG by libspng: gray, gray + alpha, RGB or RGBA with 8 or 16 bits per component. Palettes and tRNS are resolved; gAMA,
// iCCP and sRGB are not applied: what the numbers mean is decided by the texture's role (glTF 2.0, section 3.9.2).
// Row by row: without palettes, and with 8 or 16 bits.
#include <spng.h>

#include <cstring>

#include "io/pictures/block_means.h"
#include "io/pictures/image_formats.h"
#include "io/pictures/image_place.h"

namespace rakelight::io::codec {
namespace {

constexpr std::size_t max_chunk_bytes = 32u << 20, max_cached_bytes = 64u << 20;  // text, profiles; not the pixels
constexpr std::size_t max_row_chunk_bytes = 1u << 20,
                      max_row_cached_bytes = 4u << 20;  // likewise, of files read by rows
constexpr std::uint64_t max_deflate_ratio = 1032;       // zlib's documented limit of compression

struct Target {
    int channels;
    Component component;
    int format;  // spng_format
};

using PngContext = std::unique_ptr<spng_ctx, void (*)(spng_ctx*)>;

void require(int result) {
    if (result != 0) bad_picture(std::string("broken PNG: ") + spng_strerror(result));
}

PngContext open(std::span<const std::byte> bytes) {
    PngContext png(spng_ctx_new(0), spng_ctx_free);
    if (!png) throw Error(ErrorCode::failed, "out of memory");
    require(spng_set_image_limits(png.get(), max_side, max_side));
    require(spng_set_chunk_limits(png.get(), max_chunk_bytes, max_cached_bytes));
    // A wrong checksum in a chunk that matters is an error; text or a profile with one is skipped.
    require(spng_set_crc_action(png.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD));
    require(spng_set_png_buffer(png.get(), bytes.data(), bytes.size()));
    return png;
}

/// Row by row, so that it stops where it is cancelled.
void decode_rows(spng_ctx* png, int format, Pixels& pixels, const Context& context) {
    require(spng_decode_image(png, nullptr, 0, format, SPNG_DECODE_TRNS | SPNG_DECODE_PROGRESSIVE));
    for (;;) {
        context.throw_if_cancelled();
        spng_row_info row{};
        require(spng_get_row_info(png, &row));
        const int result =
            spng_decode_row(png, pixels.bytes.data() + row.row_num * pixels.row_bytes(), pixels.row_bytes());
        if (result == SPNG_EOI) return;
        require(result);
    }
}

Target target_of(const spng_ihdr& header, bool has_transparency) {
    const bool deep = header.bit_depth == 16;
    const Component component = deep ? Component::u16 : Component::u8;
    switch (header.color_type) {
        case SPNG_COLOR_TYPE_GRAYSCALE:
            if (has_transparency) return {2, component, deep ? SPNG_FMT_GA16 : SPNG_FMT_GA8};
            return {1, component, deep ? SPNG_FMT_PNG : SPNG_FMT_G8};
        case SPNG_COLOR_TYPE_GRAYSCALE_ALPHA:
            return {2, component, SPNG_FMT_PNG};
        case SPNG_COLOR_TYPE_TRUECOLOR_ALPHA:
            return {4, component, SPNG_FMT_PNG};
        default:  // true color, and palettes with at most 8 bits
            if (has_transparency) return {4, component, deep ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8};
            return {3, component, deep ? SPNG_FMT_PNG : SPNG_FMT_RGB8};
    }
}

/// A file whose header was read.
struct PngFile {
    PngContext png;
    int format;  // spng_format
    bool is_interlaced;
    Pixels size;  ///< without bytes
};

PngFile read_header(std::span<const std::byte> bytes, Context& context) {
    PngContext png = open(bytes);
    spng_ihdr header{};
    require(spng_get_ihdr(png.get(), &header));
    spng_trns transparency{};
    const int has_transparency = spng_get_trns(png.get(), &transparency);
    if (has_transparency != SPNG_ECHUNKAVAIL) require(has_transparency);
    const Target target = target_of(header, has_transparency == 0);

    // Compressed data cannot hold more than this: a small file that claims to be huge is refused before memory is requested.
    std::size_t raw_bytes = 0;
    require(spng_decoded_image_size(png.get(), SPNG_FMT_RAW, &raw_bytes));
    if (raw_bytes / max_deflate_ratio > bytes.size()) bad_picture("broken PNG: it is too short for its size in pixels");

    Pixels size = make_pixels(header.width, header.height, target.channels, target.component, Want::header, context);
    return {std::move(png), target.format, header.interlace_method != SPNG_INTERLACE_NONE, std::move(size)};
}

void check_size(const PngFile& file) {
    std::size_t needed = 0;
    require(spng_decoded_image_size(file.png.get(), file.format, &needed));
    if (needed != file.size.row_bytes() * std::size_t(file.size.height))
        bad_picture("broken PNG: its size is inconsistent");
}

/// After the pixels, as chunks may stand behind them.
bool is_tagged_srgb(spng_ctx* png) {
    std::uint8_t intent = 0;
    std::uint32_t gamma = 0;  // times 100000; 45455 is 1 / 2.2, what the PNG specification writes beside an sRGB chunk
    const bool is_gamma_srgb = spng_get_gama_int(png, &gamma) == 0 && gamma == 45455;
    return spng_get_srgb(png, &intent) == 0 || is_gamma_srgb;
}

Pixels read_png(std::span<const std::byte> bytes, Want want, Context& context) {
    PngFile file = read_header(bytes, context);
    if (want == Want::header) return std::move(file.size);
    const Pixels& size = file.size;
    Pixels pixels = make_pixels(std::uint64_t(size.width), std::uint64_t(size.height), size.channels, size.component,
                                want, context);
    check_size(file);
    decode_rows(file.png.get(), file.format, pixels, context);
    pixels.is_tagged_srgb = is_tagged_srgb(file.png.get());
    return pixels;
}

Pixels read_reduced_png(std::span<const std::byte> bytes, int factor, Context& context) {
    const PngFile file = read_header(bytes, context);
    if (file.is_interlaced) {  // its rows come several times
        const Pixels whole = read_png(bytes, Want::pixels, context);
        return block_means(
            whole, factor, [&whole](int y) { return whole.row(y); }, context);
    }
    check_size(file);
    require(spng_decode_image(file.png.get(), nullptr, 0, file.format, SPNG_DECODE_TRNS | SPNG_DECODE_PROGRESSIVE));
    std::vector<std::byte> row(file.size.row_bytes());
    const auto next_row = [&](int y) {
        const int result = spng_decode_row(file.png.get(), row.data(), row.size());
        if (result != SPNG_EOI || y + 1 < file.size.height) require(result);
        return row.data();
    };
    Pixels pixels = block_means(file.size, factor, next_row, context);
    pixels.is_tagged_srgb = is_tagged_srgb(file.png.get());
    return pixels;
}

class PngRows final : public RowReader {
public:
    PngRows(std::unique_ptr<InputFile> file, Context& context)
        : file_(std::move(file)), png_(spng_ctx_new(0), spng_ctx_free) {
        if (!png_) throw Error(ErrorCode::failed, "out of memory");
        require(spng_set_image_limits(png_.get(), max_row_side, max_row_side));
        require(spng_set_chunk_limits(png_.get(), max_row_chunk_bytes, max_row_cached_bytes));
        require(spng_set_crc_action(png_.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD));
        require(spng_set_png_file(png_.get(), file_->handle()));
        read_header();
        constexpr std::uint64_t rows_of_decoder = 3;
        charge_ =
            MemoryCharge(context.memory(), rows_of_decoder * std::uint64_t(header_.width) * header_.kind.pixel_bytes(),
                         "rows of the picture");
    }

    void read_row(void* row) override {
        if (!is_decoding_) require(spng_decode_image(png_.get(), nullptr, 0, SPNG_FMT_PNG, SPNG_DECODE_PROGRESSIVE));
        is_decoding_ = true;
        const int result = spng_decode_row(png_.get(), row, std::size_t(header_.width) * header_.kind.pixel_bytes());
        if (result != SPNG_EOI) require(result);
    }

private:
    void read_header() {
        spng_ihdr ihdr{};
        require(spng_get_ihdr(png_.get(), &ihdr));
        check_row_size(ihdr.width, ihdr.height);
        if (ihdr.interlace_method != SPNG_INTERLACE_NONE)
            bad_picture("is an interlaced PNG, which has no rows in order");
        if (ihdr.color_type == SPNG_COLOR_TYPE_INDEXED || ihdr.bit_depth < 8)
            bad_picture("is a PNG with a palette or less than 8 bits");
        header_.width = int(ihdr.width), header_.height = int(ihdr.height);
        header_.kind.format = RowFormat::png;
        header_.kind.component = ihdr.bit_depth == 16 ? Component::u16 : Component::u8;
        header_.kind.channels = ihdr.color_type == SPNG_COLOR_TYPE_GRAYSCALE         ? 1
                                : ihdr.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ? 2
                                : ihdr.color_type == SPNG_COLOR_TYPE_TRUECOLOR       ? 3
                                                                                     : 4;
        read_texts();
    }

    void read_texts() {
        std::uint32_t count = 0;
        const int result = spng_get_text(png_.get(), nullptr, &count);
        if (result == SPNG_ECHUNKAVAIL) return;
        require(result);
        std::vector<spng_text> texts(count);
        require(spng_get_text(png_.get(), texts.data(), &count));
        for (const spng_text& text : texts) {
            if (text.type != SPNG_TEXT) continue;
            const std::string value(text.text, text.length);
            if (std::strcmp(text.keyword, "Comment") == 0) header_.kind.comment = value;
            if (std::strcmp(text.keyword, png_window_keyword) == 0)
                header_.place = place_of(value, header_.width, header_.height);
        }
    }

    std::unique_ptr<InputFile> file_;  // outlives the decoder that holds its handle
    std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> png_;
    MemoryCharge charge_;
    bool is_decoding_ = false;
};

std::unique_ptr<RowReader> read_png_rows(std::unique_ptr<InputFile> file, Context& context) {
    return std::make_unique<PngRows>(std::move(file), context);
}

}  // namespace

constinit const ReadableFormat readable_png = {
    .read = read_png, .read_reduced = read_reduced_png, .read_rows = read_png_rows};

}  // namespace rakelight::io::codec
