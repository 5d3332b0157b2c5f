// SPDX-License-Identifier: Apache-2.0
// Light from all around at a run of pixels, and the environment's picture behind everything. Per instruction set.
#pragma once
#include "engines/raster/kernels/full_surface.h"

namespace rakelight::raster::RL_ISA {

inline lit::Environment environment_of(const EnvironmentView& e) {
    lit::Environment out;
    out.turn = vec2(real(e.turn[0]), real(e.turn[1]));
    out.intensity = real(e.intensity);
    out.last_level = real(float(e.specular->levels - 1));
    const float(&c)[9][3] = e.irradiance;
    out.irradiance = {splat(c[0]), splat(c[1]), splat(c[2]), splat(c[3]), splat(c[4]),
                      splat(c[5]), splat(c[6]), splat(c[7]), splat(c[8])};
    return out;
}

inline lit::LightTerms environment_terms(const ShadeJob& job, const lit::MaterialSurface& s) {
    return lit::environment_terms(maps_of(job), environment_of(*job.full->environment), s, traits_of(job),
                                  job.reflection_model);
}

inline void sky(const SkyJob* job) {
    const Maps maps = {nullptr, real(0.0f), real(0.0f), job->environment, nullptr};
    const lit::Environment environment = environment_of(*job->environment);
    const real height(float(job->environment->sky->height[0]));
    for (int32_t i = 0; i < job->count; i += lanes) {
        const integer pixel = load_i(job->pixel + i);
        const real x = to_real(pixel & integer(tile_size - 1)), y = to_real(shift_right_logical(pixel, tile_bits));
        const auto component = [&](int c) {
            return real(job->ray[c][0]) * x + real(job->ray[c][1]) * y + real(job->ray[c][2]);
        };
        const vec3 ray(component(0), component(1), component(2));
        const real scale = reciprocal(sqrt(max(dot(ray, ray), real(1e-20f))));
        const vec3 color = lit::sky_color(maps, environment, ray * scale, real(job->pixel_size) * scale, height);
        store(job->red + i, color.x);
        store(job->green + i, color.y);
        store(job->blue + i, color.z);
    }
}

}  // namespace rakelight::raster::RL_ISA
