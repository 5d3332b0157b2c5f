// SPDX-License-Identifier: Apache-2.0
// The header and the scan lines of Radiance HDR, for readers of whole pictures and of rows (image_hdr.cpp names the sources).
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace rakelight::io::codec::hdr {

/// Bytes that are taken from the front.
class Source {
public:
    explicit Source(std::span<const std::byte> bytes) : bytes_(bytes) {}
    std::size_t left() const { return bytes_.size() - at_; }
    std::size_t taken() const { return at_; }
    std::uint8_t peek(std::size_t i) const { return std::uint8_t(bytes_[at_ + i]); }
    const std::uint8_t* take(std::size_t count);  ///< @throws Error bad_file: it ends too early
    std::string_view line();                      ///< @throws Error bad_file

private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

struct Header {
    std::uint64_t width = 0, height = 0;
    bool bottom_up = false;
    std::string comment{}, window{};  ///< the first comment; what stands behind window_key
};
/// The variable of the header that names a window: "WINDOW=432,210,240,180 of 960,720".
inline constexpr const char* window_key = "WINDOW=";

/// @throws Error bad_file
Header read_header(Source& source);

/// Whether scan lines in run lengths can say such a width.
constexpr bool can_pack(std::size_t width) { return width >= 8 && width <= 0x7fff; }

/// Bytes that a line can take up at most: runs of one value have a count before each.
constexpr std::size_t most_line_bytes(std::size_t width) { return 8 * width + 4; }

/// The next line as it is stored. @param rgbe  [4 * width] @throws Error bad_file
void read_line(Source& source, std::size_t width, std::uint8_t* rgbe);
/// @param rgb  [3 * width]
void floats_of(const std::uint8_t* rgbe, std::size_t width, float* rgb);

}  // namespace rakelight::io::codec::hdr
