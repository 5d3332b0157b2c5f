// SPDX-License-Identifier: Apache-2.0
// The color of lines and points, which are not lit.
#pragma once
#include "shading/draw_list.h"

namespace rakelight::shading {

/// Linear RGB and opacity; RGB is multiplied by the vertices' colors where there are any.
inline vec4 mark_color(const DrawMaterial& m) {
    const float* const c = m.factors.base_color;
    return {c[0] + m.factors.emission[0], c[1] + m.factors.emission[1], c[2] + m.factors.emission[2],
            m.factors.blend ? c[3] : 1.0f};
}

}  // namespace rakelight::shading
