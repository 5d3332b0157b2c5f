// SPDX-License-Identifier: Apache-2.0
// Pictures in files: PNG (libspng), JPEG (libjpeg-turbo), WebP (libwebp), EXR (OpenEXR), HDR, TGA, BMP (stb).
#pragma once
#include <memory>
#include <span>
#include <string>

#include <rakelight/image/image.h>

#include "io/files/file.h"
#include "io/files/output_file.h"
#include "io/files/sync.h"

namespace rakelight::io {

/// Makes an undecoded picture with its decode function installed. Either `path` (a file of its own) or `bytes`
/// (embedded). Nothing is opened or read.
/// @param place  EncodedImage::place
ImageHandle image_from_file(std::string name, std::string model_file, std::string path, std::string place = {});
ImageHandle image_from_bytes(std::string name, std::string model_file,
                             std::shared_ptr<const std::vector<std::byte>> bytes, std::string mime_type);

/// Whether one of these made the picture, and nothing has changed how it is decoded.
bool is_of_file(const EncodedImage& image);
/// What such a picture is decoded from. @param is_told  as read_file()
Bytes bytes_of(const EncodedImage& image, Context& context, bool is_told);
/// An error in these bytes, with the names of the picture and its file.
Error named(const Error& error, const EncodedImage& image);

/// Decodes by content (not by name). The size in the header is checked against the memory budget before pixels are
/// allocated; at most 32768 pixels per side. Colors that EXR holds multiplied by alpha are divided by it (and
/// multiplied on writing).
/// @throws Error bad_file: not a picture, broken, cut short, too large. The error carries no file name; the caller adds
/// it.
Pixels decode_image(std::span<const std::byte> bytes, Context& context);

/// Takes rows from top to bottom; the file appears when finish() was called (temporary name, fsync, then rename).
class ImageWriter {
public:
    virtual ~ImageWriter() = default;
    /// [width * channels] components of the writer's kind
    virtual void write_row(const void* row) = 0;
    virtual void finish(Sync sync = Sync::now) = 0;
};

/// What a file name's ending asks for: png, jpg/jpeg, webp, ppm take 8-bit components (PNG 16 too), exr and hdr take f32.
/// @throws Error usage: unknown ending.
Component component_for(const std::string& path);
/// @param channels 1, 3 or 4 (JPEG, PPM and HDR: 3; a fourth is dropped). @throws Error usage / failed.
std::unique_ptr<ImageWriter> make_image_writer(const OutputTarget& target, int width, int height, int channels,
                                               Component component);

/// How a channel of an EXR file is stored.
enum class ExrType : std::uint8_t { f32, f16, u32 };
struct ExrChannel {
    std::string name;  ///< "R", "normal.X": the part before the last dot is the layer
    ExrType type = ExrType::f32;
    bool operator==(const ExrChannel&) const = default;
};
/// An EXR file of any channels. Rows are [width * channels] values of four bytes, in the order given: floats (halves
/// are rounded from them, what is too large for one becomes the largest) or, for u32, unsigned integers. They are
/// written as they are, without a multiplication by alpha. The data window is where `target` places the file in the whole
/// picture, the display window. @throws Error usage / failed.
std::unique_ptr<ImageWriter> make_exr_writer(const OutputTarget& target, int width, int height,
                                             std::vector<ExrChannel> channels);
/// All rows at once.
void write_image(OutputTarget target, const Pixels& pixels, Sync sync = Sync::now);

}  // namespace rakelight::io
