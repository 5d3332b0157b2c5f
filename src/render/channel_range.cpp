// SPDX-License-Identifier: Apache-2.0
#include <rakelight/picture.h>

#include <algorithm>
#include <limits>

#include "math/linear.h"

namespace rakelight {

ChannelRange channel_range_of(const Bounds& bounds, const Camera& camera) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p = {corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                         corner & 4 ? bounds.high.z : bounds.low.z};
        const double distance = -dot(p - camera.to_world[3].xyz(), camera.to_world[2].xyz());
        low = std::min(low, distance);
        high = std::max(high, distance);
    }
    return {std::max(low, camera.z_near), std::min(high, camera.z_far), bounds.low, bounds.high};
}

}  // namespace rakelight
