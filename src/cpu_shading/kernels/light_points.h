// SPDX-License-Identifier: Apache-2.0
// Points that are lit before there are pixels (flat and Gouraud shading), and vertices of a mesh likewise: terms per unit of
// reflectance. Per instruction set.
#pragma once
#include "cpu_shading/kernels/shade_points.h"

namespace rakelight::cpu_shading::RL_ISA {

/// @param mean_roughness  of the material, with the mean of its map; not looked at for classical materials
/// @param from_viewer     to the point
inline lit::MaterialSurface surface_of_point(const Job<EveryMaterial>& job, float mean_roughness, vec3 from_viewer,
                                             vec3 normal) {
    const MaterialView& m = job.material();
    const bool is_metallic = m.metallic_roughness != 0;
    const vec3 v = lit::to_viewer(from_viewer, splat(job.of.view_direction), job.has_parallel_viewer());
    const real exponent = is_metallic ? lit::exponent_of_roughness(real(mean_roughness)) : real(m.shininess);
    const lit::Surface base = lit::unit_surface(normal, v, exponent, job.reflection());
    const real roughness(is_metallic ? mean_roughness : m.lobe_roughness);
    lit::MaterialSurface s =
        lit::unit_material(base, maps_of(job.of), roughness, vec2(real(m.ward_alpha[0]), real(m.ward_alpha[1])));
    set_slopes(m, vec3(real(m.base_color[0]), real(m.base_color[1]), real(m.base_color[2])), s);
    if (is_metallic) {
        lit::set_point_dielectric(s, splat(m.dielectric_color), real(m.specular_strength));
    } else {
        lit::set_classical_dielectric(
            s, lit::classical_f0(splat(m.specular), real(m.lobe_roughness), job.of.reflection_form));
    }
    return s;
}

/// One light there.
inline lit::LightTerms terms_of_point(const Job<EveryMaterial>& job, const lit::MaterialSurface& s,
                                      const lit::LightSample& light) {
    return material_terms(job, s, light, real(1.0f), point_traits(job));
}

/// The sum over the lights.
inline lit::LightTerms light_of_point(const Job<EveryMaterial>& job, float mean_roughness, vec3 position,
                                      vec3 from_viewer, vec3 normal) {
    const lit::MaterialSurface s = surface_of_point(job, mean_roughness, from_viewer, normal);
    lit::LightTerms sum = lit::no_terms();
    for (int32_t i = 0; i < job.of.light_count; ++i)
        sum = lit::both_terms(sum, terms_of_point(job, s, lit::sample_light(job.of.lights[i], position)));
    return sum;
}

}  // namespace rakelight::cpu_shading::RL_ISA
