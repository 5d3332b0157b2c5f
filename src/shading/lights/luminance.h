// SPDX-License-Identifier: Apache-2.0
// How much a color counts where light is looked for.
#pragma once
#include <algorithm>

#include <rakelight/math/vector.h>

namespace rakelight::shading {

/// Luminance (ITU-R BT.709) of linear RGB; what is negative counts as 0.
inline double luminance_of(dvec3 c) {
    return 0.2126 * std::max(c.x, 0.0) + 0.7152 * std::max(c.y, 0.0) + 0.0722 * std::max(c.z, 0.0);
}
inline double luminance_of(vec3 c) { return luminance_of(dvec3{double(c.x), double(c.y), double(c.z)}); }

}  // namespace rakelight::shading
