// SPDX-License-Identifier: Apache-2.0
// Text and data inside of pages.
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include <rakelight/image/image.h>

namespace rakelight {

/// Text as HTML shows it, inside of elements and of attributes in double quotes; control characters become '?'.
std::string html_text(const std::string& text);

/// "data:image/png;base64,...": RFC 2397 and 4648.
std::string data_uri(const char* mime_type, std::span<const std::byte> bytes);

/// A picture as a PNG file in a data URI.
std::string png_uri(const Pixels& pixels);

}  // namespace rakelight
