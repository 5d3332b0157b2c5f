// SPDX-License-Identifier: Apache-2.0
// Constants of SrgbEncoder's table, for code compiled per instruction set.
#pragma once

namespace rakelight {

inline constexpr int srgb_bucket_bits = 16;  ///< bits of a float inside a bucket: the upper 7 of the mantissa select it
inline constexpr float srgb_highest = 0x1.fffffep-1f;  ///< the last float below 1: bits 0x3f7fffff
inline constexpr int srgb_buckets = 0x3f80;

}  // namespace rakelight
