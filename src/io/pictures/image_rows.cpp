// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/image_rows.h"

#include <array>
#include <span>

#include <rakelight_internal/base/file_ending.h>

#include "base/format_text.h"
#include "io/pictures/image_formats.h"

namespace rakelight::io {
namespace codec {

void check_row_size(std::uint64_t width, std::uint64_t height) {
    if (width == 0 || height == 0) bad_picture("the picture has no pixels");
    if (width > max_row_side || height > max_row_side)
        bad_picture(format_text("the picture is {} x {} pixels, more than {} per side", width, height, max_row_side));
}

}  // namespace codec

std::unique_ptr<RowReader> read_rows(const std::string& path, Context& context) {
    try {
        auto file = std::make_unique<InputFile>(path, context);
        std::array<std::byte, 8> first{};
        const std::size_t got = file->read(first);
        file->seek(0);
        const codec::ReadableFormat* const format = codec::format_by_signature(std::span(first).first(got));
        if (!format || !format->read_rows) codec::bad_picture("is not a PNG, EXR or HDR picture");
        return format->read_rows(std::move(file), context);
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

std::unique_ptr<ImageWriter> write_rows(const std::string& path, int width, int height, const RowKind& kind) {
    constexpr std::array<const char*, 3> endings{"png", "exr", "hdr"};
    const std::string wanted = endings[std::size_t(kind.format)];
    if (file_ending(path) != wanted)
        throw Error(ErrorCode::usage, "the input pictures are ." + wanted + " pictures", {},
                    "let the output end in ." + wanted)
            .with_file(path);
    OutputTarget target(path);
    target.comment = kind.comment;
    return kind.format == RowFormat::exr ? make_exr_writer(target, width, height, kind.exr_channels)
                                         : make_image_writer(target, width, height, kind.channels, kind.component);
}

}  // namespace rakelight::io
