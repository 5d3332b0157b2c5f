// SPDX-License-Identifier: Apache-2.0
// Pictures for textures and environments of scenes that a caller makes.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <rakelight/export.h>
#include <rakelight/image.h>

namespace rakelight {

/// A picture that is a file of its own; it is opened when it is decoded. @param path  names it in messages too
RL_API ImageHandle image_from_file(const std::string& path);
/// A picture whose file is in memory: PNG, JPEG, WebP, EXR, HDR, TGA or BMP, by content. @param name  for messages
RL_API ImageHandle image_from_bytes(std::vector<std::byte> bytes, const std::string& name);
/// A picture made of pixels that are there. Code values are what the role of the texture makes of them, sRGB for colors.
/// @throws Error usage: a size that no picture has, or another number of bytes than the size needs
RL_API ImageHandle image_from_pixels(Pixels pixels, const std::string& name);

}  // namespace rakelight
