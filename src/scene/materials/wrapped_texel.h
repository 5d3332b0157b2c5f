// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>

#include <rakelight/scene/scene.h>

namespace rakelight {

/// Index of the texel at coordinate i after wrapping.
inline int wrapped_texel(int i, int size, Wrap wrap) {
    if (wrap == Wrap::clamp_to_edge) return std::clamp(i, 0, size - 1);
    const int period = wrap == Wrap::repeat ? size : 2 * size;
    const int in = (i % period + period) % period;
    return in < size ? in : period - 1 - in;
}

}  // namespace rakelight
