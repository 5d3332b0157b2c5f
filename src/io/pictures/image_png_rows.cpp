// SPDX-License-Identifier: Apache-2.0
// PNG row by row, by libspng: gray or RGB, with or without alpha, 8 or 16 bits per component.
#include <spng.h>

#include <cstring>

#include "io/pictures/image_codecs.h"
#include "io/pictures/image_place.h"
#include "io/pictures/image_rows.h"

namespace rakelight::io::codec {
namespace {

constexpr std::size_t max_chunk_bytes = 1u << 20, max_cached_bytes = 4u << 20;  // text, profiles; not the pixels

void require(int result) {
    if (result != 0) bad_picture(std::string("broken PNG: ") + spng_strerror(result));
}

class PngRows final : public RowReader {
public:
    PngRows(std::unique_ptr<InputFile> file, Context& context)
        : file_(std::move(file)), png_(spng_ctx_new(0), spng_ctx_free) {
        if (!png_) throw Error(ErrorCode::failed, "out of memory");
        require(spng_set_image_limits(png_.get(), max_row_side, max_row_side));
        require(spng_set_chunk_limits(png_.get(), max_chunk_bytes, max_cached_bytes));
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

}  // namespace

std::unique_ptr<RowReader> read_png_rows(std::unique_ptr<InputFile> file, Context& context) {
    return std::make_unique<PngRows>(std::move(file), context);
}

}  // namespace rakelight::io::codec
