// SPDX-License-Identifier: Apache-2.0
// Textures that are decoded at a fraction of their size, for small pictures of models.
#pragma once
#include <cstdint>
#include <span>

#include <rakelight/image/image.h>

#include "io/pictures/new_pixels.h"

namespace rakelight::io {

/// The same picture, halved until no side is longer than `most_side` [px], > 0. A picture that did not
/// come from a file is returned as it is.
ImageHandle reduced_image(const ImageHandle& image, int most_side);

/// [pixels] The cost of reduced_image(), in pixels of a PNG file with 3 x 8 bits a pixel that take about as long to
/// decode. These are the pixels of the whole picture by its format, and those of the reduced one once more for its mip
/// levels. A JPEG file with one scan counts as a quarter, as its blocks are decoded at the reduced size; 16 bits,
/// lossless WebP, HDR and EXR count as more. 0: it cannot be read, or did not come from a file.
std::uint64_t decoding_work(const EncodedImage& image, int most_side, Context& context);

/// Whether the picture has an alpha channel; false where it cannot be read.
bool has_alpha(const EncodedImage& image, Context& context);

namespace codec {

/// reduced_image() and decoding_work() of the bytes of a file. @throws Error bad_file
Pixels read_reduced(std::span<const std::byte> bytes, int most_side, Want want, Context& context);
std::uint64_t reduced_work(std::span<const std::byte> bytes, int most_side, Context& context);

}  // namespace codec

}  // namespace rakelight::io
