// SPDX-License-Identifier: Apache-2.0
// Conversion of UTF-16 text with a byte order mark to UTF-8.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace rakelight {

/// nullopt if `bytes` does not start with a UTF-16 byte order mark. Broken surrogates become U+FFFD; an odd last byte
/// is dropped.
std::optional<std::string> utf8_from_utf16(std::string_view bytes);

}  // namespace rakelight
