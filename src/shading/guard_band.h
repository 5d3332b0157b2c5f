// SPDX-License-Identifier: Apache-2.0
// How far out of the picture engines cut triangles: where values are linear on the screen, they bend there.
#pragma once
#include "shading/picture_camera.h"

namespace rakelight::shading {

/// Screen coordinates stay below this, so that edge functions fit 64 bits.
inline constexpr double guard_band_px = double(1 << 20);

/// |x| <= x w and |y| <= y w in clip space.
struct GuardBand {
    explicit GuardBand(const PictureCamera& view)
        : x(float((guard_band_px - view.width) / (0.5 * view.width))),
          y(float((guard_band_px - view.height) / (0.5 * view.height))) {}
    float x, y;
};

}  // namespace rakelight::shading
