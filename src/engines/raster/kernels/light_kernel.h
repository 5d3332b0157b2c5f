// SPDX-License-Identifier: Apache-2.0
// Lighting of points before there are pixels, for flat and Gouraud shading, and its interpolation. What a point
// receives is kept per unit of reflectance and in three terms, so that textures act at the pixel: ambient occlusion on
// the ambient term alone, metalness and specular maps on the specular one. Per instruction set.
#pragma once
#include "engines/raster/kernels/interpolate.h"

namespace rakelight::raster::RL_ISA {

static_assert(shading::reflects_lambert == RL_LAMBERT && shading::reflects_phong == RL_PHONG &&
              shading::reflects_blinn_phong == RL_BLINN_PHONG && shading::reflects_oren_nayar == RL_OREN_NAYAR &&
              shading::reflects_ward == RL_WARD && shading::reflects_pbr == RL_PBR);
static_assert(shading::form_textbook == RL_TEXTBOOK && shading::form_normalized == RL_NORMALIZED);
static_assert(shading::ward_1992 == RL_WARD_1992 && shading::ward_duer == RL_WARD_DUER &&
              shading::ward_bounded == RL_WARD_BOUNDED);
static_assert(shading::fog_none == RL_NO_FOG && shading::fog_linear == RL_LINEAR_FOG &&
              shading::fog_exponential == RL_EXPONENTIAL_FOG &&
              shading::fog_exponential_squared == RL_EXPONENTIAL_SQUARED_FOG);

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
    return lit::to_viewer(position, splat(job.view_direction), job.orthographic);
}

/// Of jobs of the full kernel.
inline vec3 viewer_of(const ShadeJob& job, vec3 position) {
    return lit::to_viewer(position, splat(job.view_direction), job.orthographic | job.full->viewer_at_infinity);
}

inline lit::LightTerms receive(const ShadeJob& job, const lit::Surface& surface, vec3 position) {
    lit::LightTerms sum = lit::no_terms();
    const lit::Reflection reflection = reflection_of(job);
    for (int32_t i = 0; i < job.light_count; ++i)
        sum = lit::both_terms(sum, lit::light_terms(surface, lit::sample_light(job.lights[i], position), reflection));
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
inline lit::Surface point_surface(const ShadeJob& job, float roughness, vec3 normal, vec3 viewer) {
    const MaterialView& m = *job.material;
    const real exponent = m.metallic_roughness != 0 ? lit::exponent_of_roughness(real(roughness)) : real(m.shininess);
    return lit::unit_surface(normal, viewer, exponent, reflection_of(job));
}

inline void store_terms(const LightJob& job, int32_t i, const lit::LightTerms& terms) {
    store3(job.ambient, i, terms.ambient);
    store3(job.diffuse, i, terms.diffuse);
    store3(job.specular, i, terms.specular);
}

void light_full(const LightJob* job);  // full_kernel.cpp

inline void light(const LightJob* job) {
    if (job->shade->full != nullptr) return light_full(job);
    for (int32_t i = 0; i < job->count; i += lanes) {
        const vec3 position = load3(job->position, i), viewer = to_viewer(*job->shade, position);
        const lit::Surface surface = point_surface(*job->shade, job->roughness, load3(job->normal, i), viewer);
        store_terms(*job, i, receive(*job->shade, surface, position));
    }
}

/// The light of each pixel's triangle at the pixel, perspective-correct.
inline lit::LightTerms interpolate_light(const LitTriangle* triangles, const int32_t* triangle, const Barycentrics& b) {
    const Records records(reinterpret_cast<const float*>(triangles), lit_triangle_floats, triangle);
    lit::LightTerms terms;
    terms.ambient = interpolate3(records, b, offsetof(LitTriangle, ambient));
    terms.diffuse = interpolate3(records, b, offsetof(LitTriangle, diffuse));
    terms.specular = interpolate3(records, b, offsetof(LitTriangle, specular));
    return terms;
}

}  // namespace rakelight::raster::RL_ISA
