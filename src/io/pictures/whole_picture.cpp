// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/whole_picture.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <vector>

#include <rakelight_internal/base/file_ending.h>

#include "io/files/file.h"
#include "io/pictures/image_rows.h"

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

/// What the writer of PPM makes: "P6", width, height, most; then three numbers a pixel.
PictureSize size_of_whole_ppm(const std::string& path, Context& context) {
    const Bytes bytes = read_file(path, context, true);
    std::istringstream text(
        std::string(reinterpret_cast<const char*>(bytes->data()), std::min<std::size_t>(64, bytes->size())));
    std::string magic;
    std::uint64_t width = 0, height = 0, most = 0;
    const bool has_header =
        bool(text >> magic >> width >> height >> most) && magic == "P6" && width < 1u << 20 && height < 1u << 20;
    if (!has_header || bytes->size() != std::uint64_t(text.tellg()) + 1 + width * height * (most > 255 ? 6 : 3))
        throw Error(ErrorCode::bad_file, "is not a whole PPM picture").with_file(path);
    return {int(width), int(height)};
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

std::vector<std::optional<Error>> faults_of_pictures(std::size_t count, const std::function<void(std::size_t)>& check,
                                                     Context& context) {
    std::vector<std::optional<Error>> faults(count);
    const auto try_it = [&](std::size_t i) {
        faults[i].reset();
        try {
            check(i);
        } catch (const Error& error) {
            context.throw_if_cancelled();
            faults[i] = error;
        }
    };
    context.parallel_for(count, try_it);
    for (std::size_t i = 0; i < count; ++i) {
        if (!faults[i]) continue;
        const std::uint64_t refused = context.memory().refusals();
        try_it(i);
        if (faults[i] && context.memory().refusals() != refused) throw *faults[i];
    }
    return faults;
}

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
    if (ending == "ppm") return size_of_whole_ppm(path, context);
    return ending == "exr" || ending == "hdr" ? decode_rows(path, context) : decode_at_once(path, context);
}

}  // namespace rakelight::io
