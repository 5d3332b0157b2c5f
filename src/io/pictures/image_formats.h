// SPDX-License-Identifier: Apache-2.0
// The formats of picture files. A format that is read is one constant, and so is one that is written. The source of the format
// defines it; the tables in image_formats.cpp say by which first bytes and by which ending it is chosen.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "io/pictures/image_rows.h"
#include "io/pictures/new_pixels.h"

namespace rakelight::io::codec {

/// A format that is read. All functions throw Error bad_file.
struct ReadableFormat {
    /// @param bytes  they begin like the format
    Pixels (*read)(std::span<const std::byte> bytes, Want want, Context& context) = nullptr;

    /// The picture at 1/factor of its size, without memory for the whole one. JPEG: by a smaller inverse transform.
    /// Null: the means of blocks of the whole picture. @param factor  a power of 2
    Pixels (*read_reduced)(std::span<const std::byte> bytes, int factor, Context& context) = nullptr;

    /// [pixels] What decoding costs at 1/factor of the size, as decoding_work() counts. Null: a third of a pixel for
    /// each value, a whole one for values of 16 bits. Measured with 2048 x 2048 pixels of a smooth picture with noise
    /// (AMD EPYC with AVX-512), where a pixel of the PNG file with 3 x 8 bits takes 16 ns. PNG with 16 bits costs 0.6
    /// to 1 a value, WebP 0.6 and 1.4 (lossless) a pixel. HDR costs 1.5 a pixel, TGA and BMP 0.7 to 1, JPEG 0.1 to 0.2
    /// (one scan) and 0.5 (several). EXR with zip or piz costs 0.6 to 1.3 a half and 2.2 to 2.6 a float.
    std::uint64_t (*work)(const Pixels& header, std::span<const std::byte> bytes, int factor,
                          Context& context) = nullptr;

    /// For a format without a signature: whether the header could be one of it.
    bool (*may_be)(std::span<const std::byte> bytes) = nullptr;

    /// Row by row. Null: only whole pictures of the format are read.
    std::unique_ptr<RowReader> (*read_rows)(std::unique_ptr<InputFile> file, Context& context) = nullptr;
};
extern const ReadableFormat readable_png, readable_jpeg, readable_webp, readable_exr, readable_hdr, readable_bmp,
    readable_tga;

/// @throws Error bad_file: no known format; the message names formats that occur in models but are not read
const ReadableFormat& readable_format(std::span<const std::byte> bytes);
/// The format whose signature these bytes begin with; null: none.
const ReadableFormat* format_by_signature(std::span<const std::byte> bytes);

/// A format that is written.
struct WritableFormat {
    Component component = Component::u8;  ///< of its rows
    bool takes_u16 = false;               ///< likewise
    /// @param width, height  [px] 1..65536  @param channels  1..4
    std::unique_ptr<ImageWriter> (*write)(const OutputTarget& target, int width, int height, int channels,
                                          Component component) = nullptr;
    /// Channels with names. Null: the format has none.
    std::unique_ptr<ImageWriter> (*write_channels)(const OutputTarget& target, int width, int height,
                                                   std::vector<ExrChannel> channels) = nullptr;
};
extern const WritableFormat writable_png, writable_jpeg, writable_webp, writable_ppm, writable_exr, writable_hdr;

/// The format that the ending of a file's name asks for. @throws Error usage: unknown ending
const WritableFormat& writable_format(const std::string& path);

}  // namespace rakelight::io::codec
