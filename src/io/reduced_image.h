// SPDX-License-Identifier: Apache-2.0
// Textures that are decoded at a fraction of their size, for small pictures of models.
#pragma once
#include <rakelight/image.h>

namespace rakelight::io {

/// The same picture, halved until no side is longer than `most_side` [px]: image_reduced.cpp. A picture that did not
/// come from a file is returned as it is.
ImageHandle reduced_image(const ImageHandle& image, int most_side);

}  // namespace rakelight::io
