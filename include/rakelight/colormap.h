// SPDX-License-Identifier: Apache-2.0
// Colors for numbers.
#pragma once
#include <cstdint>

#include <rakelight/export.h>
#include <rakelight/vector.h>

namespace rakelight {

/// Colors for numbers.
enum class ColorMap : std::uint8_t { viridis, magma, inferno, plasma, turbo, coolwarm, gray };

/// @param t  0..1; outside it is clamped, NaN gives gray
/// @return   linear RGB
RL_API vec3 color_of(ColorMap map, double t);

}  // namespace rakelight
