// SPDX-License-Identifier: Apache-2.0
// How a color is laid over what is there.
#pragma once
#include <rakelight/math/vector.h>

namespace rakelight::raster {

/// Porter & Duff 1984, straight alpha in 0..1. Where both are transparent nothing changes.
inline void lay_over(vec4 c, vec4& to) {
    const float under = to.w * (1 - c.w), alpha = c.w + under;
    if (alpha > 0)
        to = {(c.x * c.w + to.x * under) / alpha, (c.y * c.w + to.y * under) / alpha,
              (c.z * c.w + to.z * under) / alpha, alpha};
}

}  // namespace rakelight::raster
