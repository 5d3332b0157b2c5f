// SPDX-License-Identifier: Apache-2.0
// Fog between points and the eye. Per instruction set.
#pragma once
#include "cpu_shading/kernels/job.h"

namespace rakelight::cpu_shading::RL_ISA {

/// 0..1: how much of the point's own color is seen.
inline real fog_at(const MaterialJob& job, vec3 position) {
    const shading::FogFactors& fog = job.fog;
    return lit::fog_factor(fog.kind, lit::fog_distance(position, splat(job.view_direction), job.orthographic),
                           real(fog.start), real(fog.end), real(fog.density));
}

/// `radiance` behind the fog between it and the eye.
template <class Kind>
inline vec3 behind_fog(const Job<Kind>& job, vec3 position, vec3 radiance) {
    if (!job.has_fog()) return radiance;
    return lit::behind_fog(radiance, splat(job.of.fog.color), fog_at(job.of, position));
}

}  // namespace rakelight::cpu_shading::RL_ISA
