// SPDX-License-Identifier: Apache-2.0
// Fog over a run of pixels. Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// 0..1: how much of the pixel's own color is seen.
inline real fog_of(const ShadeJob& job, const Pixels& p) {
    const FogView& fog = job.full->fog;
    return lit::fog_factor(fog.kind, lit::fog_distance(p.position, splat(job.view_direction), job.orthographic),
                           real(fog.start), real(fog.end), real(fog.density));
}

/// `radiance` behind the fog between it and the eye.
inline vec3 add_fog(const ShadeJob& job, const Pixels& p, vec3 radiance) {
    if (job.full->fog.kind == 0) return radiance;
    return lit::behind_fog(radiance, splat(job.full->fog.color), fog_of(job, p));
}

}  // namespace rakelight::raster::RL_ISA
