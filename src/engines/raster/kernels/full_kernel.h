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
    BaseColor base;
    lit::MaterialSurface surface;
    vec3 emission;
};

inline void find_full(const ShadeJob& job, int32_t first, FullPixels& f) {
    const MaterialView& m = *job.material;
    f.p.find(job, first);
    find_relief_texcoords(job, f.p);
    f.base = base_color(m, f.p);
    set_material(job, f.p, f.base, f.surface);
    set_frame(job, f.p, f.surface);
    f.emission = emission_of(m, f.p);
}

/// What light i adds at the pixel.
inline lit::LightTerms full_light(const ShadeJob& job, int32_t i, const FullPixels& f) {
    const lit::LightSample light = sample_in_frame(job, i, f.p, f.surface);
    const real seen = shadow_factor(job, i, f.p, light) * relief_shadow(job, f.p, f.surface, light);
    return lit::surface_terms(f.surface, light, seen, reflection_of(job));
}

inline vec3 add_terms(vec3 sum, const lit::LightTerms& t) { return sum + (t.ambient + t.diffuse + t.specular); }

/// The color, in the order of the plain kernel's sum.
inline vec3 full_radiance(const ShadeJob& job, const FullPixels& f) {
    vec3 sum = f.emission;
    if (job.unlit != 0) {
        sum = lit::unlit(rgb(f.base.color), sum);
    } else if (job.lit != nullptr) {
        const ReceivedLight received = interpolate_light(job.lit, f.p.triangle, f.p.b);
        const lit::Surface& s = f.surface.base;
        sum = sum + (s.ambient * received.ambient + s.diffuse * received.diffuse + s.specular * received.specular);
    } else {
        for (int32_t i = 0; i < job.light_count; ++i) sum = add_terms(sum, full_light(job, i, f));
        if (job.full->environment != nullptr) sum = add_terms(sum, environment_terms(job, f.surface));
    }
    return add_fog(job, f.p, sum);
}

}  // namespace rakelight::raster::RL_ISA
