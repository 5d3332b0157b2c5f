// SPDX-License-Identifier: Apache-2.0
// C headers only: kernels of every instruction set fill it.
#pragma once

namespace rakelight::shading {

/// A box about the eye, world axes.
struct LightBox {
    float low[3], high[3];
};

}  // namespace rakelight::shading
