// SPDX-License-Identifier: Apache-2.0
// Data channels of points, from the same functions as their color. Run only where somebody asked. Of a Source (shade_points.h)
// they want weights(k) too: of the triangle's corners. Per instruction set.
#pragma once
#include "cpu_shading/channel_planes.h"
#include "cpu_shading/kernels/whole_points.h"

namespace rakelight::cpu_shading::RL_ISA {

/// The terms whose sum is the color.
struct ColorTerms {
    lit::LightTerms light;
    vec3 emission;
};

/// Fog dims each term; its own light counts as emission.
template <class Whole>
inline ColorTerms color_terms(const Whole& p) {
    ColorTerms sum = {lit::no_terms(), own_radiance(p.material, p.state())};
    add_light(p.material, p.source, p.b, p.seen(),
              [&sum](int32_t, const lit::LightTerms& t) { sum.light = lit::both_terms(sum.light, t); });
    if (!p.material.has_fog()) return sum;
    const real share = fog_at(p.material.of, p.point().position);
    return {lit::dimmed_terms(sum.light, share), behind_fog(p.material, p.point().position, sum.emission)};
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
template <class Source>
inline vec4 tangent_of(const MaterialJob& job, const Source& source) {
    const SignedVector normal = source.normal(0), tangent = source.tangent(0);
    const vec3 t = lit::map_tangent(safe_normalize(normal.v), tangent.v, job.orthogonalize);
    const real w = tangent.sign * normal.sign;
    const mask has_tangent = dot(tangent.v, tangent.v) > real(0.0f);
    const real zero(0.0f);
    return vec4(select(has_tangent, t.x, zero), select(has_tangent, t.y, zero), select(has_tangent, t.z, zero),
                select(has_tangent, w, zero));
}

inline void put3(const ChannelValues& to, int32_t plane, int32_t first, vec3 v) {
    if (to.out[plane] == nullptr) return;
    store(to.out[plane] + first, v.x);
    store(to.out[plane + 1] + first, v.y);
    store(to.out[plane + 2] + first, v.z);
}

template <class Source>
inline void put_places(const ChannelValues& to, int32_t first, const Source& source, vec3 position) {
    put3(to, plane_position, first, position);
    put3(to, plane_barycentric, first, source.weights(0));
    for (int32_t set = 0; set < 2; ++set) {
        const int32_t plane = plane_uv + 2 * set;
        if (to.out[plane] == nullptr) continue;
        TexCoords c;
        source.texcoords(0, set, c);
        store(to.out[plane] + first, c.uv.x);
        store(to.out[plane + 1] + first, c.uv.y);
    }
}

template <class Source>
inline void put_tangent(const ChannelValues& to, int32_t first, const MaterialJob& job, const Source& source) {
    if (to.out[plane_tangent] == nullptr) return;
    const vec4 t = tangent_of(job, source);
    put3(to, plane_tangent, first, vec3(t.x, t.y, t.z));
    store(to.out[plane_tangent + 3] + first, t.w);
}

inline void put_terms(const ChannelValues& to, int32_t first, const ColorTerms& sum) {
    const ColorTerms terms = finite_terms(sum);
    put3(to, plane_ambient, first, terms.light.ambient);
    put3(to, plane_diffuse, first, terms.light.diffuse);
    put3(to, plane_specular, first, terms.light.specular);
    put3(to, plane_emission, first, terms.emission);
}

/// @tparam Whole  the engine's WholePoints, with seen(): what find_radiance() asks
template <class Whole, class Source, class EnginesJob>
inline void find_channels(const EnginesJob& job, const ChannelValues& to) {
    const bool needs_color = to.out[plane_base_color] != nullptr || to.needs_terms != 0;
    for (int32_t i = 0; i < job.count; i += lanes) {
        Source source(job, i);
        ShadingPoint point;
        source.place(0, point);
        put_places(to, i, source, point.position);
        put_tangent(to, i, job, source);
        if (!needs_color) continue;
        const Whole p(job, i);
        const vec3 own = rgb(p.state().base.color);
        put3(to, plane_base_color, i, where_finite(own, own));
        if (to.needs_terms != 0) put_terms(to, i, color_terms(p));
    }
}

}  // namespace rakelight::cpu_shading::RL_ISA
