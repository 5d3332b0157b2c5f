// SPDX-License-Identifier: Apache-2.0
// TGA and BMP by stb_image. It takes missing bytes for zeros, so whether a file is whole is found out here first.
#include <climits>
#include <cstring>
#include <utility>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS 32768
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include "base/format_text.h"
#include "io/pictures/image_formats.h"

namespace rakelight::io::codec {
namespace {

std::uint32_t byte_at(std::span<const std::byte> bytes, std::size_t at) { return std::uint32_t(bytes[at]); }
std::uint32_t u16_at(std::span<const std::byte> bytes, std::size_t at) {
    return byte_at(bytes, at) | byte_at(bytes, at + 1) << 8;
}
std::uint32_t u32_at(std::span<const std::byte> bytes, std::size_t at) {
    return u16_at(bytes, at) | u16_at(bytes, at + 2) << 16;
}

/// A picture that was checked to be whole and within limits.
Pixels read_by_stb(std::span<const std::byte> bytes, const char* format, Want want, Context& context) {
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    int width = 0, height = 0, channels = 0;
    if (bytes.size() > INT_MAX) bad_picture(std::string(format) + " files over 2 GiB are not supported");
    const int size = int(bytes.size());
    if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0 || width <= 0 || height <= 0 ||
        channels < 1 || channels > 4)
        bad_picture(std::string("broken ") + format + ": " + stbi_failure_reason());
    Pixels pixels = make_pixels(std::uint64_t(width), std::uint64_t(height), channels, Component::u8, want, context);
    if (want == Want::header) return pixels;
    context.memory().check(pixels.bytes.size() * 2, "the picture while it is decoded");
    const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
        stbi_load_from_memory(data, size, &width, &height, &channels, pixels.channels), stbi_image_free);
    if (!decoded || width != pixels.width || height != pixels.height)
        bad_picture(std::string("broken ") + format + ": " +
                    (decoded ? "its size is inconsistent" : stbi_failure_reason()));
    std::memcpy(pixels.bytes.data(), decoded.get(), pixels.bytes.size());
    return pixels;
}

struct TgaHeader {
    std::uint32_t palette_kind, type, palette_start, palette_length, palette_bits, width, height, bits, descriptor;
    std::size_t pixels_at;
    bool packed() const { return type >= 8; }
};

TgaHeader tga_header(std::span<const std::byte> bytes) {
    TgaHeader h{byte_at(bytes, 1), byte_at(bytes, 2), u16_at(bytes, 3),   u16_at(bytes, 5),   byte_at(bytes, 7),
                u16_at(bytes, 12), u16_at(bytes, 14), byte_at(bytes, 16), byte_at(bytes, 17), 0};
    h.pixels_at =
        18 + byte_at(bytes, 0) + (h.palette_kind == 1 ? std::size_t(h.palette_length) * ((h.palette_bits + 7) / 8) : 0);
    return h;
}

/// Pixels that the bytes hold, walked packet by packet (Truevision TGA 2.0, section "Run-length encoding").
bool tga_is_whole(std::span<const std::byte> bytes, const TgaHeader& h) {
    const std::size_t pixel_bytes = (h.bits + 7) / 8;
    const std::uint64_t needed = std::uint64_t(h.width) * h.height;
    if (h.pixels_at > bytes.size()) return false;
    if (!h.packed()) return (bytes.size() - h.pixels_at) / pixel_bytes >= needed;
    std::uint64_t found = 0;
    std::size_t at = h.pixels_at;
    while (found < needed) {
        if (at >= bytes.size()) return false;
        const std::uint32_t packet = byte_at(bytes, at++), count = (packet & 127) + 1;
        const std::size_t size = (packet & 128) != 0 ? pixel_bytes : pixel_bytes * count;
        if (bytes.size() - at < size) return false;
        at += size;
        found += count;
    }
    return true;
}

void mirror_rows(Pixels& pixels) {
    const std::size_t n = std::size_t(pixels.channels);
    for (int y = 0; y < pixels.height; ++y)
        for (std::size_t left = 0, right = std::size_t(pixels.width) - 1; left < right; ++left, --right)
            for (std::size_t c = 0; c < n; ++c) std::swap(pixels.row(y)[left * n + c], pixels.row(y)[right * n + c]);
}

bool may_be_tga(std::span<const std::byte> bytes) {
    if (bytes.size() < 18) return false;
    const TgaHeader h = tga_header(bytes);
    const bool indexed = h.type == 1 || h.type == 9;
    const bool known_type = indexed || h.type == 2 || h.type == 3 || h.type == 10 || h.type == 11;
    const bool known_bits = h.bits == 8 || h.bits == 15 || h.bits == 16 || h.bits == 24 || h.bits == 32;
    return h.palette_kind <= 1 && known_type && known_bits && h.width > 0 && h.height > 0 &&
           (h.palette_kind == 1 || !indexed);
}

Pixels read_tga(std::span<const std::byte> bytes, Want want, Context& context) {
    const TgaHeader h = tga_header(bytes);
    if (h.palette_kind == 1 && h.palette_start != 0)
        bad_picture("TGA palettes that begin in the middle are not supported");
    if (h.width > max_side || h.height > max_side) bad_picture("the picture is too large");
    if (!tga_is_whole(bytes, h)) bad_picture("broken TGA: it ends too early");
    Pixels pixels = read_by_stb(bytes, "TGA", want, context);
    if (want == Want::pixels && (h.descriptor & 0x10) != 0)
        mirror_rows(pixels);  // right to left, which stb_image does not look at
    return pixels;
}

Pixels read_bmp(std::span<const std::byte> bytes, Want want, Context& context) {
    if (bytes.size() < 26) bad_picture("broken BMP: it ends too early");
    const std::uint64_t offset = u32_at(bytes, 10);
    const bool old = u32_at(bytes, 14) == 12;
    if (!old && bytes.size() < 54) bad_picture("broken BMP: it ends too early");
    const std::int64_t width = old ? u16_at(bytes, 18) : std::int32_t(u32_at(bytes, 18));
    const std::int64_t height = old ? u16_at(bytes, 20) : std::int32_t(u32_at(bytes, 22));
    const std::uint32_t bits = u16_at(bytes, old ? 24 : 28);
    const std::uint64_t rows = std::uint64_t(height < 0 ? -height : height);
    if (width < 1 || rows < 1 || width > max_side || rows > max_side)
        bad_picture("broken BMP: a size of no or too many pixels");
    if (bits == 0 || bits > 32) bad_picture(format_text("broken BMP: {} bits per pixel", bits));
    const std::uint64_t row_bytes = (std::uint64_t(width) * bits + 31) / 32 * 4;
    if (offset > bytes.size() || (bytes.size() - offset) / row_bytes < rows)
        bad_picture("broken BMP: it ends too early");
    return read_by_stb(bytes, "BMP", want, context);
}

}  // namespace

constinit const ReadableFormat readable_tga = {.read = read_tga, .may_be = may_be_tga};
constinit const ReadableFormat readable_bmp = {.read = read_bmp};

}  // namespace rakelight::io::codec
