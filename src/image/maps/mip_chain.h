// SPDX-License-Identifier: Apache-2.0
// Mip chains for texture sampling.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/image/image.h>
#include <rakelight/math/vector.h>

#include "image/convert.h"

namespace rakelight {

/// One level, row 0 on top. Exactly one of the two arrays is filled.
struct MipLevel {
    int width = 0, height = 0;         ///< [px] >= 1
    std::vector<std::uint32_t> rgba8;  ///< [height * width] code values, R in the low byte
    std::vector<vec4> rgba32f;         ///< [height * width] linear RGB, straight alpha; finite
};

struct MipChain {
    bool is_srgb = false;          ///< the RGB of rgba8 are sRGB codes (alpha is linear always)
    bool is_float = false;         ///< rgba32f is filled, else rgba8
    MemoryCharge charge;           ///< of the levels
    std::vector<MipLevel> levels;  ///< full size first, 1 x 1 last; each side is max(1, previous / 2), rounded down
};

/// 8-bit pictures keep their codes in level 0 and have rgba8 levels; 16-bit and float pictures become linear floats.
/// Each level is an exact box filter of the previous one, so nothing shifts. This holds for odd sizes too: three taps
/// with position-dependent weights (Guthe & Heckbert 2005, "Non-Power-of-Two Mipmapping"). Colors in sRGB are averaged
/// in linear light and rounded once, from unrounded averages, at each level. Alpha is straight and colors are averaged
/// without it as weight (as glTF renderers and GPUs do); hidden colors may bleed in at cut-outs. Bit-identical for any
/// number of threads.
/// @return no level for a picture without pixels
/// @throws Error bad_file: over the memory budget
MipChain make_mip_chain(const Pixels& pixels, ColorSpace space, Context& context);

/// Linear RGB of texel `i` of a level of a color picture.
vec3 linear_texel(const MipChain& chain, const MipLevel& level, std::size_t i);

/// [bytes] upper bound of make_mip_chain() besides the pixels, of which only size and type are used.
std::uint64_t mip_chain_bytes(const Pixels& pixels);

}  // namespace rakelight
