// SPDX-License-Identifier: Apache-2.0
// Pictures for textures and environments of scenes created in memory.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/image/image.h>

namespace rakelight {

/// A picture file. It is opened when the picture is decoded.
/// @param path  of the file; messages use it as the name of the picture
RL_API ImageHandle image_from_file(const std::string& path);
/// An encoded picture in memory: PNG, JPEG, WebP, EXR, HDR, TGA or BMP, detected by content.
/// @param name  for messages
RL_API ImageHandle image_from_bytes(std::vector<std::byte> bytes, const std::string& name);
/// A picture of given pixels. The material's use of the texture decides the color space of code values: sRGB for
/// colors.
/// @throws Error usage: an impossible size, or a number of bytes that does not match the size
RL_API ImageHandle image_from_pixels(Pixels pixels, const std::string& name);

}  // namespace rakelight
