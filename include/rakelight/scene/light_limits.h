// SPDX-License-Identifier: Apache-2.0
// Lower limits of light parameters, for world files, options and glTF.
#pragma once

namespace rakelight {

inline constexpr double min_light_range = 1e-6;  ///< [m] smaller values of Light::range are clamped to this
inline constexpr double min_cone_deg = 0.001;    ///< half angle of spot lights in world files and options

}  // namespace rakelight
