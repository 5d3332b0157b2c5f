// SPDX-License-Identifier: Apache-2.0
// Fog over a run of pixels. Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// [m] that the ray to a pixel goes through the fog: from the eye; in parallel views from the plane of the camera.
inline real distance_in_fog(const ShadeJob& job, vec3 position) {
    if (job.orthographic != 0) return max(-dot(splat(job.view_direction), position), real(0.0f));
    return length(position);
}

/// 0..1: how much of the pixel's own color is seen.
inline real fog_of(const ShadeJob& job, const Pixels& p) {
    const FogView& fog = job.full->fog;
    return lit::fog_factor(fog.kind, distance_in_fog(job, p.position), real(fog.start), real(fog.end),
                           real(fog.density));
}

/// `radiance` behind the fog between it and the eye.
inline vec3 add_fog(const ShadeJob& job, const Pixels& p, vec3 radiance) {
    if (job.full->fog.kind == 0) return radiance;
    const real seen = fog_of(job, p);
    return radiance * seen + splat(job.full->fog.color) * (real(1.0f) - seen);
}

}  // namespace rakelight::raster::RL_ISA
