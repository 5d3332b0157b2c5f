// SPDX-License-Identifier: Apache-2.0
// The environment as the lighting text has it. Per instruction set.
#pragma once
#include "cpu_shading/kernels/job.h"
#include "cpu_shading/kernels/maps.h"

namespace rakelight::cpu_shading::RL_ISA {

inline lit::Environment environment_of(const EnvironmentView& e) {
    lit::Environment out;
    out.to_x = splat(e.turn[0]), out.to_y = splat(e.turn[1]), out.to_z = splat(e.turn[2]);
    out.intensity = real(e.intensity);
    out.last_level = real(float(e.specular->levels - 1));
    const float(&c)[9][3] = e.irradiance;
    out.irradiance = {splat(c[0]), splat(c[1]), splat(c[2]), splat(c[3]), splat(c[4]),
                      splat(c[5]), splat(c[6]), splat(c[7]), splat(c[8])};
    return out;
}

/// What a surface shows of it. @param job  has an environment
template <class Kind>
inline lit::LightTerms environment_terms(const Job<Kind>& job, const lit::MaterialSurface& s) {
    return lit::environment_terms(maps_of(job.of), environment_of(*job.of.environment), s, job.traits(), job.model());
}

}  // namespace rakelight::cpu_shading::RL_ISA
