// SPDX-License-Identifier: Apache-2.0
#include "io/whole_picture.h"

#include <vector>

#include <rakelight/tools/file_ending.h>

#include "io/file.h"
#include "io/image_rows.h"

namespace rakelight::io {
namespace {

PictureSize decode_rows(const std::string& path, Context& context) {
    const std::unique_ptr<RowReader> rows = read_rows(path, context);
    const RowHeader& header = rows->header();
    std::vector<std::byte> row(std::size_t(header.width) * header.kind.pixel_bytes());
    try {
        for (int y = 0; y < header.height; ++y) rows->read_row(row.data());
    } catch (const Error& error) {
        throw error.with_file(path);
    }
    return {header.width, header.height};
}

PictureSize decode_at_once(const std::string& path, Context& context) {
    const Bytes bytes = read_file(path, context, true);
    try {
        const Pixels pixels = decode_image(*bytes, context);
        return {pixels.width, pixels.height};
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

/// All checksums are right, and the last chunk is there.
PngHeader header_of_sound_png(const std::string& path, Context& context) {
    const Bytes bytes = read_file(path, context, true);
    try {
        return png_header(png_chunks(*bytes));
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

}  // namespace

PngHeader header_of_whole_png(const std::string& path, Context& context) {
    const PngHeader header = header_of_sound_png(path, context);
    constexpr int palette = 3;
    const bool has_rows = header.bit_depth >= 8 && header.color_type != palette && header.interlace == 0;
    has_rows ? decode_rows(path, context) : decode_at_once(path, context);
    return header;
}

PictureSize size_of_whole_picture(const std::string& path, Context& context) {
    const std::string ending = file_ending(path);
    if (ending == "png") {
        const PngHeader header = header_of_whole_png(path, context);
        return {int(header.width), int(header.height)};
    }
    return ending == "exr" || ending == "hdr" ? decode_rows(path, context) : decode_at_once(path, context);
}

}  // namespace rakelight::io
