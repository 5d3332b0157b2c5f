// SPDX-License-Identifier: Apache-2.0
// Textures that are decoded at a fraction of their size, for small pictures of models.
#pragma once
#include <cstdint>

#include <rakelight/image.h>

namespace rakelight::io {

/// The same picture, halved until no side is longer than `most_side` [px]: image_reduced.cpp. A picture that did not
/// come from a file is returned as it is.
ImageHandle reduced_image(const ImageHandle& image, int most_side);

/// [pixels] What reduced_image() costs to decode, in pixels of a PNG file: all of the whole picture, but a quarter of
/// them of a JPEG file with one scan, whose blocks are decoded at the reduced size. 0: it cannot be read, or did not come
/// from a file.
std::uint64_t decoding_work(const EncodedImage& image, Context& context);

}  // namespace rakelight::io
