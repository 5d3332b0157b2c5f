// SPDX-License-Identifier: Apache-2.0
// Data channels of a run of pixels, from the same functions as their color. Runs only where somebody asked. Per
// instruction set.
#pragma once
#include "engines/raster/kernels/whole_pixels.h"

namespace rakelight::raster::RL_ISA {

/// The terms whose sum is the color.
struct ColorTerms {
    lit::LightTerms light;
    vec3 emission;
};

/// Fog dims each term; its own light counts as emission.
inline ColorTerms color_terms(const WholePixels& p) {
    ColorTerms sum = {lit::no_terms(), cpu::own_radiance(p.material, p.state())};
    cpu::add_light(p.material, p.source, p.b, p.seen(),
                   [&sum](int32_t, const lit::LightTerms& t) { sum.light = lit::both_terms(sum.light, t); });
    if (!p.material.has_fog()) return sum;
    const real share = cpu::fog_at(p.material.of, p.point().position);
    return {lit::dimmed_terms(sum.light, share), cpu::behind_fog(p.material, p.point().position, sum.emission)};
}

/// `v` where `sum` is finite, component by component, else 0: a color that is not finite is shown black, and none of
/// its parts says more than their sum.
inline vec3 where_finite(vec3 sum, vec3 v) {
    const real zero(0.0f);
    return vec3(select(sum.x - sum.x == zero, v.x, zero), select(sum.y - sum.y == zero, v.y, zero),
                select(sum.z - sum.z == zero, v.z, zero));
}

inline ColorTerms finite_terms(const ColorTerms& t) {
    const vec3 sum = lit::radiance_of_terms(t.light) + t.emission;
    return {
        {where_finite(sum, t.light.ambient), where_finite(sum, t.light.diffuse), where_finite(sum, t.light.specular)},
        where_finite(sum, t.emission)};
}

/// Tangent as normal maps use it, and the sign that makes bitangent = cross(normal on the side that is lit, tangent) w.
/// 0 where the mesh has none.
inline vec4 tangent_of(const ShadeJob& job, const Pixels& p) {
    const SignedVector normal = normal_at(p.records, p.b), tangent = tangent_at(p.records, p.b);
    const vec3 t = lit::map_tangent(safe_normalize(normal.v), tangent.v, job.orthogonalize);
    const real w = tangent.sign * normal.sign;
    const mask has_tangent = dot(tangent.v, tangent.v) > real(0.0f);
    const real zero(0.0f);
    return vec4(select(has_tangent, t.x, zero), select(has_tangent, t.y, zero), select(has_tangent, t.z, zero),
                select(has_tangent, w, zero));
}

inline void put3(const ChannelJob& job, int32_t plane, int32_t first, vec3 v) {
    if (job.out[plane] == nullptr) return;
    store(job.out[plane] + first, v.x);
    store(job.out[plane + 1] + first, v.y);
    store(job.out[plane + 2] + first, v.z);
}

inline void put_places(const ChannelJob& job, int32_t first, const Pixels& p, vec3 position) {
    put3(job, plane_position, first, position);
    put3(job, plane_barycentric, first, vec3(real(1.0f) - p.b.b1 - p.b.b2, p.b.b1, p.b.b2));
    for (int32_t set = 0; set < 2; ++set) {
        const int32_t plane = plane_uv + 2 * set;
        if (job.out[plane] == nullptr) continue;
        TexCoords c;
        find_texcoords(p.records, p.b, set, c);
        store(job.out[plane] + first, c.uv.x);
        store(job.out[plane + 1] + first, c.uv.y);
    }
}

inline void put_tangent(const ChannelJob& job, int32_t first, const Pixels& p) {
    if (job.out[plane_tangent] == nullptr) return;
    const vec4 t = tangent_of(*job.shade, p);
    put3(job, plane_tangent, first, vec3(t.x, t.y, t.z));
    store(job.out[plane_tangent + 3] + first, t.w);
}

inline void put_terms(const ChannelJob& job, int32_t first, const ColorTerms& sum) {
    const ColorTerms terms = finite_terms(sum);
    put3(job, plane_ambient, first, terms.light.ambient);
    put3(job, plane_diffuse, first, terms.light.diffuse);
    put3(job, plane_specular, first, terms.light.specular);
    put3(job, plane_emission, first, terms.emission);
}

inline void put_colors(const ChannelJob& job, int32_t first) {
    const WholePixels p(*job.shade, first);
    const vec3 own = rgb(p.state().base.color);
    put3(job, plane_base_color, first, where_finite(own, own));
    if (job.needs_terms != 0) put_terms(job, first, color_terms(p));
}

inline void find_channels(const ChannelJob& job) {
    const bool needs_color = job.out[plane_base_color] != nullptr || job.needs_terms != 0;
    for (int32_t i = 0; i < job.shade->count; i += lanes) {
        Pixels p;
        const vec3 position = p.find(*job.shade, i);
        put_places(job, i, p, position);
        put_tangent(job, i, p);
        if (needs_color) put_colors(job, i);
    }
}

}  // namespace rakelight::raster::RL_ISA
