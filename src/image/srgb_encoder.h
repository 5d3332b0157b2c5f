// SPDX-License-Identifier: Apache-2.0
// Linear light to 8-bit sRGB codes, exact and fast: the same result as srgb8_from_linear for every float.
#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "image/srgb_table.h"

namespace rakelight {

/// A table keyed by the upper bits of the float. Each octave has 128 buckets, so that at most one of the 255 code
/// transitions lies in a bucket: one table look-up and one addition give the correctly rounded code. (Idea: Giesen
/// 2012, "Exact float to sRGB8 conversions", with interpolated slopes.)
class SrgbEncoder {
public:
    static const SrgbEncoder& instance();  ///< created at the first call; thread-safe

    /// NaN and negative give 0, over 1 gives 255.
    std::uint32_t operator()(float linear) const {
        const float low = linear > 0.0f ? linear : 0.0f;  // NaN too
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(low < srgb_highest ? low : srgb_highest);
        return (table_[bits >> srgb_bucket_bits] + (bits & 0xFFFFu)) >> srgb_bucket_bits;
    }

    /// [srgb_buckets] 2^16 times the code at the bucket's lower end, plus an offset to the transition in the bucket.
    /// After adding the position in the bucket, bits 16 to 23 are the code.
    const std::uint32_t* table() const { return table_.data(); }

private:
    SrgbEncoder();
    std::array<std::uint32_t, srgb_buckets> table_;
};

}  // namespace rakelight
