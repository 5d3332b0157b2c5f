// SPDX-License-Identifier: Apache-2.0
// Linear light to 8-bit sRGB codes, exact and fast: the same result as srgb8_from_linear for every float.
#pragma once
#include <array>
#include <bit>
#include <cstdint>

namespace rakelight {

/// A table keyed by the upper bits of the float. Each octave is cut into 128 buckets, so fine that at most one of the 255
/// places where the code steps up falls into a bucket: one look-up and one comparison give the correctly rounded code.
/// (Giesen 2012, "Exact float to sRGB8 conversions", has the idea with interpolated slopes.)
class SrgbEncoder {
public:
    static const SrgbEncoder& instance();  ///< made on the first call; thread-safe

    /// NaN and negative give 0, over 1 gives 255.
    std::uint32_t operator()(float linear) const {
        const float low = linear > lowest ? linear : lowest;  // NaN too
        const float clamped = low < highest ? low : highest;
        const Bucket& bucket = buckets_[(std::bit_cast<std::uint32_t>(clamped) - std::bit_cast<std::uint32_t>(lowest)) >> shift];
        return bucket.code + std::uint32_t(clamped >= bucket.step);
    }

private:
    SrgbEncoder();
    static constexpr int shift = 16;                      // 7 of the 23 mantissa bits stay
    static constexpr float lowest = 0x1p-13f;             // below the first step, 0.5 / 255 / 12.92 = 0.000152
    static constexpr float highest = 0x1.fffffep-1f;      // the last float below 1
    static constexpr std::size_t bucket_count = 13 * 128;
    struct Bucket {
        float step;          // where the code of this bucket goes up by one; 2 when it does not
        std::uint32_t code;  // at the bucket's lower end
    };
    std::array<Bucket, bucket_count> buckets_;
};

}  // namespace rakelight
