// SPDX-License-Identifier: Apache-2.0
#include "shading/sample_positions.h"

namespace rakelight::shading {

vec4 mean_of_samples(const vec4* colors, std::size_t n) {
    double r = 0, g = 0, b = 0, a = 0;  // double: of equal colors the mean is the color itself
    for (std::size_t i = 0; i < n; ++i) {
        const double alpha = double(colors[i].w);
        r += double(colors[i].x) * alpha, g += double(colors[i].y) * alpha, b += double(colors[i].z) * alpha,
            a += alpha;
    }
    if (!(a > 0)) return {colors[0].x, colors[0].y, colors[0].z, 0};  // nothing is there: the background's own
    return {float(r / a), float(g / a), float(b / a), float(a / double(n))};
}

}  // namespace rakelight::shading
