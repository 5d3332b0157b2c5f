// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of a point on HIGH.
#pragma once
#include <cstdint>

#include "bake/high/high_surface.h"

namespace rakelight::bake {

/// The share of unoccluded rays within `reach` [m] around the shading normal. Directions are cosine-weighted, in `side`
/// x `side` strata, with jitter that depends only on `seed` (the disc of Malley's method; Pharr et al. 2016,
/// "Physically Based Rendering", section 13.6.3). Directions below the triangle are ignored.
double open_sky(const HighSurface& high, const HighPoint& point, int side, double reach, std::uint64_t seed);

}  // namespace rakelight::bake
