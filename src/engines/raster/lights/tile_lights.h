// SPDX-License-Identifier: Apache-2.0
// Many lights: each run of pixels is lit by those alone that can reach it (shading/light_reach.h).
#pragma once
#include <cstdint>

#include "engines/raster/kernels/kernel_types.h"
#include "shading/lights/light_reach.h"

namespace rakelight::raster {

struct TileScratch;
using shading::LightReach;

/// What Kernels::shade() does, in runs of pixels that have light lists of their own.
/// @param reach  null, or not worth it: the job's own lights
std::int32_t shade_with_lists(const Kernels& kernels, const LightReach* reach, const ShadeJob& job, TileScratch& s);

}  // namespace rakelight::raster
