// SPDX-License-Identifier: Apache-2.0
// How the table of SrgbEncoder is read, for code that is compiled per instruction set: constants only.
#pragma once

namespace rakelight {

inline constexpr int srgb_bucket_bits = 16;  ///< of a float's bits lie in one bucket: 7 of the mantissa choose it
inline constexpr float srgb_highest = 0x1.fffffep-1f;  ///< the last float below 1: bits 0x3f7fffff
inline constexpr int srgb_buckets = 0x3f80;

}  // namespace rakelight
