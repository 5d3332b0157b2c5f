// SPDX-License-Identifier: Apache-2.0
#include "io/stray_vertices.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rakelight::io {

bool has_stray_vertices(std::span<const vec3> positions) {
    if (positions.size() < 8) return false;
    std::vector<float> reach;
    reach.reserve(positions.size());
    for (const vec3& p : positions)
        reach.push_back(std::fmax(std::fabs(p.x), std::fmax(std::fabs(p.y), std::fabs(p.z))));
    std::erase_if(reach, [](float r) { return !std::isfinite(r); });
    if (reach.empty()) return false;
    const float largest = *std::max_element(reach.begin(), reach.end());
    const auto middle = reach.begin() + std::ptrdiff_t(reach.size() / 2);
    std::nth_element(reach.begin(), middle, reach.end());
    return *middle > 0 && largest > *middle * 1e6f;
}

}  // namespace rakelight::io
