// SPDX-License-Identifier: Apache-2.0
// The chunks of a PNG file, as PNG (third edition), section 5, has them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rakelight::io {

struct PngChunk {
    std::string_view type;            ///< "IDAT"
    std::span<const std::byte> data;  ///< without length, type and checksum
};

inline constexpr std::array<std::uint8_t, 8> png_signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

/// All of them, from IHDR to IEND; they point into `bytes`. @throws Error bad_file: no PNG, cut short, a wrong checksum
std::vector<PngChunk> png_chunks(std::span<const std::byte> bytes);

/// What IHDR says.
struct PngHeader {
    std::uint32_t width = 0, height = 0;
    std::uint8_t bit_depth = 0, color_type = 0, interlace = 0;
    bool has_alpha() const { return (color_type & 4) != 0; }
    bool operator==(const PngHeader&) const = default;
};
/// @throws Error bad_file: it does not begin with a whole IHDR
PngHeader png_header(std::span<const PngChunk> chunks);

/// Numbers as PNG writes them, the highest byte first.
void put_u16(std::vector<std::byte>& to, std::uint32_t value);
void put_u32(std::vector<std::byte>& to, std::uint32_t value);
/// A chunk with its length and checksum. @param prefix  data before `data`
void put_chunk(std::vector<std::byte>& to, std::string_view type, std::span<const std::byte> prefix,
               std::span<const std::byte> data);

}  // namespace rakelight::io
