// SPDX-License-Identifier: Apache-2.0
// Mip levels of cut-out textures that let as much through as the full picture does.
#pragma once
#include <compare>

#include <rakelight/base/context.h>

#include "image/maps/mip_chain.h"

namespace rakelight {

/// How a texture is compared with a cutoff.
struct AlphaTest {
    float cutoff = -1;      ///< texels of at least this are seen; not above 0: there is no test
    int channel = 3;        ///< 0..3: what is compared
    bool is_linear = true;  ///< texels are interpolated before they are compared
    auto operator<=>(const AlphaTest&) const = default;
};

/// The part of a level that is seen, 0..1: of four points a texel at least, of texels where they are not interpolated.
/// @param scale             multiplies the tested channel, which then ends at 1 and is rounded as the level keeps it
/// @param repeats_x         the first texel of a row follows its last one; else the last one is repeated
double alpha_coverage(const MipChain& chain, const MipLevel& level, const AlphaTest& test, double scale, bool repeats_x,
                      bool repeats_y, Context& context);

/// Scales the tested channel of each smaller level, so that as much of it is seen as of the first level (Castano 2010,
/// "Computing alpha mipmaps"). The averages alone drop below the cutoff: leaves would vanish in small pictures. The chain
/// ends before the first level whose texels are too few to show that part. Bit-identical for any number of threads.
void keep_coverage(MipChain& chain, const AlphaTest& test, bool repeats_x, bool repeats_y, Context& context);

}  // namespace rakelight
