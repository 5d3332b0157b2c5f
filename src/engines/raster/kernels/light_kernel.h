// SPDX-License-Identifier: Apache-2.0
// Lighting of points before there are pixels, for flat and Gouraud shading, and its interpolation. What a point
// receives is kept per unit of reflectance and in three terms, so that textures act at the pixel: ambient occlusion on
// the ambient term alone, metalness and specular maps on the specular one. Per instruction set.
#pragma once
#include "engines/raster/kernels/interpolate.h"
#include "lighting/lighting.h"

namespace rakelight::raster::RL_ISA {
namespace lit = rakelight::lighting::RL_ISA;

inline vec3 splat(const float (&v)[3]) { return vec3(real(v[0]), real(v[1]), real(v[2])); }

inline lit::Reflection reflection_of(const ShadeJob& job) {
    lit::Reflection reflection;
    reflection.model = job.reflection_model;
    reflection.form = job.reflection_form;
    reflection.horizon = job.specular_horizon;
    reflection.whole_exponent = job.material->whole_exponent;
    return reflection;
}

inline vec3 to_viewer(const ShadeJob& job, vec3 position) {
    return job.orthographic != 0 ? splat(job.view_direction) : -safe_normalize(position);
}

/// Of jobs of the full kernel.
inline vec3 viewer_of(const ShadeJob& job, vec3 position) {
    return job.full->viewer_at_infinity != 0 ? splat(job.view_direction) : to_viewer(job, position);
}

/// Exponent of the Blinn-Phong lobe that is as wide as a GGX lobe of this roughness.
inline real exponent_of_roughness(real roughness) {
    const real alpha = max(roughness * roughness, real(1e-3f));
    return clamp(real(2.0f) / (alpha * alpha) - real(2.0f), real(1.0f), real(10000.0f));
}

struct ReceivedLight {
    vec3 ambient, diffuse, specular;
};

/// Light i as a point meets it, ended by its range.
inline lit::LightSample light_at(const ShadeJob& job, int32_t i, vec3 position) {
    const lit::LightSample light = lit::sample_light(job.lights[i], position);
    return job.full != nullptr ? lit::end_at_range(light, job.lights[i], position) : light;
}

inline ReceivedLight receive(const ShadeJob& job, const lit::Surface& surface, vec3 position) {
    ReceivedLight sum = {vec3(real(0.0f)), vec3(real(0.0f)), vec3(real(0.0f))};
    const lit::Reflection reflection = reflection_of(job);
    for (int32_t i = 0; i < job.light_count; ++i) {
        const lit::LightTerms terms = lit::light_terms(surface, light_at(job, i, position), reflection);
        sum.ambient = sum.ambient + terms.ambient;
        sum.diffuse = sum.diffuse + terms.diffuse;
        sum.specular = sum.specular + terms.specular;
    }
    return sum;
}

inline vec3 load3(const float* const (&from)[3], int32_t i) {
    return vec3(load(from[0] + i), load(from[1] + i), load(from[2] + i));
}
inline void store3(float* const (&to)[3], int32_t i, vec3 v) {
    store(to[0] + i, v.x);
    store(to[1] + i, v.y);
    store(to[2] + i, v.z);
}

/// A point of the material whose terms are those per unit of reflectance.
inline lit::Surface point_surface(const ShadeJob& job, float roughness, vec3 position, vec3 normal) {
    const MaterialView& m = *job.material;
    lit::Surface surface;
    surface.ambient = surface.diffuse = surface.specular = vec3(real(1.0f));
    surface.exponent = m.metallic_roughness != 0 ? exponent_of_roughness(real(roughness)) : real(m.shininess);
    surface.lobe_scale = lit::lobe_scale(surface.exponent, reflection_of(job));
    surface.n = normal;
    surface.v = to_viewer(job, position);
    return surface;
}

void light_full(const LightJob* job);  // full_kernel.cpp

inline void light(const LightJob* job) {
    if (job->shade->full != nullptr) return light_full(job);
    for (int32_t i = 0; i < job->count; i += lanes) {
        const vec3 position = load3(job->position, i);
        const lit::Surface surface = point_surface(*job->shade, job->roughness, position, load3(job->normal, i));
        const ReceivedLight received = receive(*job->shade, surface, position);
        store3(job->ambient, i, received.ambient);
        store3(job->diffuse, i, received.diffuse);
        store3(job->specular, i, received.specular);
    }
}

/// The light of each pixel's triangle at the pixel, perspective-correct.
inline ReceivedLight interpolate_light(const LitTriangle* triangles, const int32_t* triangle, const Barycentrics& b) {
    const Records records(reinterpret_cast<const float*>(triangles), lit_triangle_floats, triangle);
    return {interpolate3(records, b, offsetof(LitTriangle, ambient)),
            interpolate3(records, b, offsetof(LitTriangle, diffuse)),
            interpolate3(records, b, offsetof(LitTriangle, specular))};
}

}  // namespace rakelight::raster::RL_ISA
