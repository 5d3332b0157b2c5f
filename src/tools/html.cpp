// SPDX-License-Identifier: Apache-2.0
#include "tools/html.h"

#include <cstdint>

#include <rakelight/base/error.h>

#include "io/pictures/image_io.h"

namespace rakelight {

std::string html_text(const std::string& text) {
    std::string out;
    for (const char c : one_line(text, text.size())) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

std::string data_uri(const char* mime_type, std::span<const std::byte> bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out = std::string("data:") + mime_type + ";base64,";
    out.reserve(out.size() + (bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = bytes.size() - i < 3 ? bytes.size() - i : 3;
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < count ? std::uint32_t(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k) out += k <= count ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::string png_uri(const Pixels& pixels) {
    std::vector<std::byte> file;
    io::write_image({"picture.png", file}, pixels);
    return data_uri("image/png", file);
}

}  // namespace rakelight
