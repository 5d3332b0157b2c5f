// SPDX-License-Identifier: Apache-2.0
// How much of the sky a place of HIGH sees.
#pragma once
#include <cstdint>

#include "bake/high_surface.h"

namespace rakelight::bake {

/// The share of rays about the shading normal that meet nothing within `reach` [m]: directions weighed by the cosine, in
/// `side` x `side` strata, jittered by numbers that depend on `seed` alone (the disc of Malley's method; Pharr et al. 2016,
/// "Physically Based Rendering", section 13.6.3). Directions below the triangle do not count.
double open_sky(const HighSurface& high, const HighPoint& point, int side, double reach, std::uint64_t seed);

}  // namespace rakelight::bake
