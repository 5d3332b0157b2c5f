// SPDX-License-Identifier: Apache-2.0
// How an environment's picture stands in the world.
#pragma once
#include <array>

#include "math/functions.h"
#include "math/linear.h"
#include "scene/fitted_camera.h"

namespace rakelight::shading {

/// The picture's own axes in the world: their dot products with a direction are that direction in the picture's axes.
inline std::array<dvec3, 3> environment_axes(const Environment& environment) {
    const double c = math::cos(environment.rotation_rad), s = math::sin(environment.rotation_rad);
    const dvec3 rows[3] = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};  // of a picture whose upper edge is at +Y
    return {turn_with_up(rows[0], environment.up), turn_with_up(rows[1], environment.up),
            turn_with_up(rows[2], environment.up)};
}

}  // namespace rakelight::shading
