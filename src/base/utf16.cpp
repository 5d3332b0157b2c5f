// SPDX-License-Identifier: Apache-2.0
#include "base/utf16.h"

namespace rakelight {
namespace {

void append_utf8(std::string& out, char32_t c) {
    if (c < 0x80) {
        out += char(c);
    } else if (c < 0x800) {
        out += {char(0xC0 | (c >> 6)), char(0x80 | (c & 63))};
    } else if (c < 0x10000) {
        out += {char(0xE0 | (c >> 12)), char(0x80 | ((c >> 6) & 63)), char(0x80 | (c & 63))};
    } else {
        out += {char(0xF0 | (c >> 18)), char(0x80 | ((c >> 12) & 63)), char(0x80 | ((c >> 6) & 63)),
                char(0x80 | (c & 63))};
    }
}

}  // namespace

std::optional<std::string> utf8_from_utf16(std::string_view bytes) {
    if (bytes.size() < 2) return std::nullopt;
    const bool little = bytes[0] == '\xFF' && bytes[1] == '\xFE', big = bytes[0] == '\xFE' && bytes[1] == '\xFF';
    if (!little && !big) return std::nullopt;
    const auto unit = [&](std::size_t i) {
        const auto a = char32_t(static_cast<unsigned char>(bytes[i])),
                   b = char32_t(static_cast<unsigned char>(bytes[i + 1]));
        return little ? a | (b << 8) : (a << 8) | b;
    };
    std::string out;
    out.reserve(bytes.size() / 2);
    for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
        const char32_t c = unit(i);
        if (c < 0xD800 || c > 0xDFFF) {
            append_utf8(out, c);
            continue;
        }
        const char32_t next = c < 0xDC00 && i + 3 < bytes.size() ? unit(i + 2) : 0;
        const bool pair = next >= 0xDC00 && next <= 0xDFFF;
        append_utf8(out, pair ? 0x10000 + ((c - 0xD800) << 10) + (next - 0xDC00) : 0xFFFD);
        if (pair) i += 2;
    }
    return out;
}

}  // namespace rakelight
