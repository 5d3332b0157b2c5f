// SPDX-License-Identifier: Apache-2.0
// Fog over a run of pixels. Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// `radiance` behind the fog between it and the eye.
inline vec3 add_fog(const ShadeJob& job, const Pixels&, vec3 radiance) {
    if (job.full->fog.kind == 0) return radiance;
    return radiance;
}

}  // namespace rakelight::raster::RL_ISA
