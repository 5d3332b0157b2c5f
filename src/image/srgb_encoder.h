// SPDX-License-Identifier: Apache-2.0
// Linear light to 8-bit sRGB codes, exact and fast: the same result as srgb8_from_linear for every float.
#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "image/srgb_table.h"

namespace rakelight {

/// A table keyed by the upper bits of the float. Each octave is cut into 128 buckets, so fine that at most one of the 255
/// places where the code steps up falls into a bucket: one look-up and one comparison give the correctly rounded code.
/// (Giesen 2012, "Exact float to sRGB8 conversions", has the idea with interpolated slopes.)
class SrgbEncoder {
public:
    static const SrgbEncoder& instance();  ///< made on the first call; thread-safe

    /// NaN and negative give 0, over 1 gives 255.
    std::uint32_t operator()(float linear) const {
        const float low = linear > srgb_lowest ? linear : srgb_lowest;  // NaN too
        const float clamped = low < srgb_highest ? low : srgb_highest;
        const std::uint32_t above = std::bit_cast<std::uint32_t>(clamped) - std::bit_cast<std::uint32_t>(srgb_lowest);
        const std::uint32_t entry = table_[above >> srgb_bucket_bits];
        return (entry >> 24) + std::uint32_t((above & 0xFFFFu) >= (entry & 0x1FFFFu));
    }

    /// [srgb_buckets] the code at the bucket's lower end in the upper 8 bits; in the lower 17 the place in the bucket
    /// where it goes up by one, 0x10000 where it does not.
    const std::uint32_t* table() const { return table_.data(); }

private:
    SrgbEncoder();
    std::array<std::uint32_t, srgb_buckets> table_;
};

}  // namespace rakelight
