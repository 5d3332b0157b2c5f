// SPDX-License-Identifier: Apache-2.0
// Shading with all that a job may ask for, a vector of pixels at a time: find the pixel, look into its relief, what the
// material is there, its frame, the lights one by one with what hides them, environment, fog. With nothing of all
// that it gives the plain kernel's numbers to the bit. Per instruction set.
#pragma once
#include "engines/raster/kernels/environment_light.h"
#include "engines/raster/kernels/fog.h"
#include "engines/raster/kernels/full_surface.h"
#include "engines/raster/kernels/relief.h"
#include "engines/raster/kernels/shadow.h"

namespace rakelight::raster::RL_ISA {

/// What is known of a vector of pixels before light falls on it.
struct FullPixels {
    Pixels p;
    Bumps bumps;
    BaseColor base;
    lit::MaterialSurface surface;
    vec3 emission;
};

inline void find_full(const ShadeJob& job, int32_t first, FullPixels& f) {
    const MaterialView& m = *job.material;
    f.p.find(job, first);
    find_relief_texcoords(job, f.p, f.bumps);
    f.base = base_color(m, f.p);
    set_material(job, f.p, f.base, f.surface);
    set_frame(job, f.p, f.bumps, f.surface);
    f.emission = finish_surface(job, f.p, emission_of(m, f.p), f.surface);
}

/// 0..1: how much of light i is not in shadow.
inline real seen_of(const ShadeJob& job, int32_t i, const FullPixels& f, const lit::LightSample& light) {
    return shadow_factor(job, i, f.p) * relief_shadow(job, i, f.bumps, light);
}

/// What light i adds at the pixel.
inline lit::LightTerms full_light(const ShadeJob& job, int32_t i, const FullPixels& f) {
    const lit::LightSample light = sample_in_frame(job, i, f.p, f.bumps);
    if (no_lane(light.attenuation > real(0.0f))) return lit::no_terms();
    return material_terms(job, f.surface, light, seen_of(job, i, f, light), traits_of(job));
}

/// Calls add(terms) for all that falls on the surface, in the order of the plain kernel's sum. What comes from all
/// around is found at the pixels in flat and Gouraud pictures too.
template <class Add>
inline void each_light(const ShadeJob& job, const FullPixels& f, const Add& add) {
    if (job.unlit != 0) return;
    if (job.lit != nullptr)
        add(lit::corner_terms(f.surface.base, interpolate_light(job.lit, f.p.triangle, f.p.b)));
    else
        for (int32_t i = 0; i < job.light_count; ++i) add(full_light(job, i, f));
    if (job.full->environment != nullptr) add(environment_terms(job, f.surface));
}

/// What shines without light.
inline vec3 own_radiance(const ShadeJob& job, const FullPixels& f) {
    return job.unlit != 0 ? lit::unlit(rgb(f.base.color), f.emission) : f.emission;
}

inline vec3 radiance_before_fog(const ShadeJob& job, const FullPixels& f) {
    vec3 sum = own_radiance(job, f);
    each_light(job, f, [&](const lit::LightTerms& t) { sum = sum + lit::radiance_of_terms(t); });
    return sum;
}

/// The color.
inline vec3 full_radiance(const ShadeJob& job, const FullPixels& f) {
    return add_fog(job, f.p, radiance_before_fog(job, f));
}

}  // namespace rakelight::raster::RL_ISA
