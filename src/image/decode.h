// SPDX-License-Identifier: Apache-2.0
// Decodes pictures of a scene. Scenes created in memory may have a custom decoder, or none.
#pragma once
#include <rakelight/image/image.h>

namespace rakelight {

/// Calls measure() first, so that the memory budget accounts for the bytes read and refuses too large pictures.
/// @throws Error bad_file: no decoder, or its result has a wrong size; and as the decoder
Pixels decode(const EncodedImage& image, Context& context);

/// The same after the caller has called measure().
Pixels decode_measured(const EncodedImage& image, Context& context);

}  // namespace rakelight
