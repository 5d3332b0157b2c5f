// SPDX-License-Identifier: Apache-2.0
// The horizontal extent of a camera: its own, or from its height and the aspect in its file.
#pragma once
#include <optional>

#include <rakelight/scene/scene.h>

#include "math/functions.h"

namespace rakelight {

/// [rad] of a perspective camera; nothing where the picture decides.
inline std::optional<double> horizontal_fov_rad(const Camera& c) {
    if (c.horizontal_fov_rad || !c.aspect) return c.horizontal_fov_rad;
    return 2 * math::atan2(math::tan(0.5 * c.vertical_fov_rad) * *c.aspect, 1);
}

/// [m] of an orthographic camera; nothing where the picture decides.
inline std::optional<double> half_width(const Camera& c) {
    if (c.half_width || !c.aspect) return c.half_width;
    return c.half_height * *c.aspect;
}

}  // namespace rakelight
