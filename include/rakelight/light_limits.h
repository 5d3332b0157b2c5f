// SPDX-License-Identifier: Apache-2.0
// Least values of lights, the same for world files, options and glTF.
#pragma once

namespace rakelight {

inline constexpr double least_light_range = 1e-6;  ///< [m] Light::range that is less is taken as this
inline constexpr double least_cone_deg = 0.001;    ///< half angle of a spot light that a world file or an option names

}  // namespace rakelight
