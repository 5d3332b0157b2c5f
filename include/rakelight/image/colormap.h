// SPDX-License-Identifier: Apache-2.0
// Color maps.
#pragma once
#include <cstdint>

#include <rakelight/base/export.h>
#include <rakelight/math/vector.h>

namespace rakelight {

/// Color maps.
enum class ColorMap : std::uint8_t { viridis, magma, inferno, plasma, turbo, coolwarm, gray };

/// @param t 0..1, clamped; NaN gives gray
/// @return   linear RGB
RL_API vec3 color_of(ColorMap map, double t);

}  // namespace rakelight
