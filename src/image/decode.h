// SPDX-License-Identifier: Apache-2.0
// The one way from a scene's picture to its pixels: who made the scene may have brought a decoder of his own, or none.
#pragma once
#include <rakelight/image.h>

namespace rakelight {

/// Measured first, so that the budget knows how much was read and refuses what is too large.
/// @throws Error bad_file: the image has no decoder, what it gives is not as large as it says; and what the decoder
/// throws
Pixels decode(const EncodedImage& image, Context& context);

/// The same for who has called measure() before.
Pixels decode_measured(const EncodedImage& image, Context& context);

}  // namespace rakelight
