// SPDX-License-Identifier: Apache-2.0
// The terms of the lights taken apart into their factors, for the recorder: each part of a term is a product whose
// factors the equations' own functions give. Their sum is the kernel's term except for rounding, as
// tests/unit/raster/inspect/explain_parts_test.cpp checks.
#pragma once
#include "engines/raster/inspect/kernels/trace_kernel.h"
#include "engines/raster/kernels/whole_pixels.h"

namespace rakelight::raster::RL_ISA {

using Quantity = TracedQuantity;
using Term = TracedTerm;
using Layer = TracedLayer;

/// A product in the making.
class PartWriter {
public:
    PartWriter(TracedParts& to, Term term, Layer layer) : part_(to.part[to.count++]) {
        part_ = TracedPart{};
        part_.term = term, part_.layer = layer;
    }
    PartWriter& times(Quantity quantity, vec3 v) { return times(quantity, 1, v); }
    PartWriter& times(Quantity quantity, real v) { return times(quantity, 0, vec3(v)); }

private:
    PartWriter& times(Quantity quantity, int32_t is_color, vec3 v) {
        TracedFactor& f = part_.factor[part_.count++];
        f.quantity = quantity, f.is_color = is_color;
        f.value[0] = v.x, f.value[1] = v.y, f.value[2] = v.z;
        return *this;
    }
    TracedPart& part_;
};

/// A light as it falls on a surface.
struct PartSource {
    const lit::MaterialSurface& s;
    const lit::LightSample& light;
    const lit::MaterialTraits& traits;
    const lit::Reflection& r;
    lit::LightAlbedo albedo;
    real seen;
};

inline bool same(vec3 a, vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

inline void times_seen(PartWriter& part, const PartSource& of) {
    if (of.seen < 1.0f) part.times(Quantity::seen, of.seen);
}

/// BRDFs that are 0 where light or viewer are below the surface.
inline void times_above(PartWriter& part, const PartSource& of, vec3 n) {
    const real least = min(dot(n, of.light.l), dot(n, of.s.base.v));
    if (!(least > 0.0f)) part.times(Quantity::above, 0.0f);
}

/// What the layers from `above` on leave.
inline void times_layers(PartWriter& part, const PartSource& of, Layer above) {
    if (of.traits.has_sheen != 0 && above <= Layer::sheen)
        part.times(Quantity::sheen_rest, lit::sheen_rest(of.s.sheen, of.albedo.sheen, of.s.sheen_albedo));
    if (of.traits.has_coat != 0) part.times(Quantity::coat_rest, 1.0f - of.s.coat_reflectance);
}

/// [1/sr] to radiance.
inline void times_light(PartWriter& part, const PartSource& of, Quantity n_dot_l, vec3 n) {
    part.times(Quantity::light_color, of.light.specular * of.light.attenuation)
        .times(Quantity::pi, RL_PI)
        .times(n_dot_l, lit::lambert_cosine(dot(n, of.light.l)));
}

inline real schlick_weight_of(const PartSource& of) {
    const vec3 h = lit::half_vector(of.light.l, of.s.base.v, of.s.base.n);
    return lit::schlick_weight(dot(of.s.base.v, h));
}

inline void diffuse_part(const PartSource& of, TracedParts& out) {
    const lit::MaterialSurface& s = of.s;
    const Quantity n_dot_l = same(s.diffuse_n, s.base.n) ? Quantity::n_dot_l : Quantity::n_dot_l_diffuse;
    PartWriter part(out, Term::diffuse, Layer::base);
    part.times(Quantity::k_diffuse, s.base.diffuse)
        .times(Quantity::light_color, of.light.diffuse * of.light.attenuation)
        .times(n_dot_l, lit::lambert_cosine(dot(s.diffuse_n, of.light.l)));
    if (of.r.model == RL_OREN_NAYAR)
        part.times(Quantity::oren_nayar,
                   lit::oren_nayar_factor(s.diffuse_n, of.light.l, s.base.v, s.oren_nayar_a, s.oren_nayar_b));
    if (of.r.model == RL_OREN_NAYAR_FULL)
        part.times(Quantity::oren_nayar_full,
                   lit::oren_nayar_full_factor(s.diffuse_n, of.light.l, s.base.v, s.oren_nayar_a, s.oren_nayar_b,
                                               s.oren_nayar_bounce, s.facet_color));
    if (of.r.model == RL_PBR) {
        part.times(Quantity::fresnel_rest, lit::fresnel_rest(s, schlick_weight_of(of)));
        times_layers(part, of, Layer::sheen);
    }
    times_seen(part, of);
}

/// Phong, Blinn-Phong.
inline void power_part(const PartSource& of, TracedParts& out) {
    const lit::Surface& s = of.s.base;
    const real cosine = lit::lambert_cosine(dot(s.n, of.light.l));
    PartWriter part(out, Term::specular, Layer::base);
    part.times(Quantity::k_specular, s.specular)
        .times(Quantity::light_color, of.light.specular * of.light.attenuation)
        .times(Quantity::power, lit::lobe(lit::lobe_cosine(s, of.light.l, of.r), s.exponent, of.r));
    if (of.r.form == RL_NORMALIZED)
        part.times(Quantity::energy_factor, s.lobe_scale).times(Quantity::n_dot_l, cosine);
    else if (of.r.horizon != 0 && !(cosine > 0.0f))
        part.times(Quantity::above, 0.0f);
    times_seen(part, of);
}

inline void ward_part(const PartSource& of, TracedParts& out) {
    const lit::MaterialSurface& s = of.s;
    const vec3 h = lit::half_vector(of.light.l, s.base.v, s.base.n);
    PartWriter part(out, Term::specular, Layer::base);
    part.times(Quantity::k_specular, s.base.specular)
        .times(Quantity::ward_peak, lit::ward_peak(s.alpha_x, s.alpha_y))
        .times(Quantity::ward_exponential, lit::ward_lobe(s.base.n, s.tangent, s.bitangent, h, s.alpha_x, s.alpha_y))
        .times(Quantity::ward_divided,
               1.0f / lit::ward_divisor(s.base.n, of.light.l, s.base.v, h, of.traits.ward_form));
    times_light(part, of, Quantity::n_dot_l, s.base.n);
    times_above(part, of, s.base.n);
    times_seen(part, of);
}

/// D and V of a lobe with equal widths.
inline void times_lobe(PartWriter& part, const PartSource& of, vec3 n, real alpha) {
    const vec3 v = of.s.base.v, l = of.light.l, h = lit::half_vector(l, v, n);
    const real n_dot_l = dot(n, l), n_dot_v = dot(n, v);
    part.times(Quantity::distribution, lit::ggx_distribution_isotropic(n, h, alpha))
        .times(Quantity::visibility, lit::smith_visibility(n_dot_l, n_dot_v, lit::ggx_stretch_isotropic(n_dot_l, alpha),
                                                           lit::ggx_stretch_isotropic(n_dot_v, alpha)));
}

inline void times_anisotropic_lobe(PartWriter& part, const PartSource& of) {
    const lit::MaterialSurface& s = of.s;
    const vec3 n = s.base.n, v = s.base.v, l = of.light.l, h = lit::half_vector(l, v, n);
    const real stretch_l = lit::ggx_stretch(n, s.tangent, s.bitangent, l, s.alpha_x, s.alpha_y);
    const real stretch_v = lit::ggx_stretch(n, s.tangent, s.bitangent, v, s.alpha_x, s.alpha_y);
    part.times(Quantity::distribution, lit::ggx_distribution(n, s.tangent, s.bitangent, h, s.alpha_x, s.alpha_y))
        .times(Quantity::visibility, lit::smith_visibility(dot(n, l), dot(n, v), stretch_l, stretch_v));
}

/// GGX, and the light between its facets.
inline void pbr_parts(const PartSource& of, TracedParts& out) {
    const lit::MaterialSurface& s = of.s;
    PartWriter part(out, Term::specular, Layer::base);
    part.times(Quantity::fresnel, lit::schlick(s.base.specular, s.f90, schlick_weight_of(of)));
    if (of.traits.is_anisotropic != 0)
        times_anisotropic_lobe(part, of);
    else
        times_lobe(part, of, s.base.n, s.alpha_x);
    times_light(part, of, Quantity::n_dot_l, s.base.n);
    times_above(part, of, s.base.n);
    times_layers(part, of, Layer::sheen);
    times_seen(part, of);
    if (of.traits.has_scattering == 0) return;
    PartWriter between(out, Term::specular, Layer::scattering);
    between.times(Quantity::scattering_color, s.scattering)
        .times(Quantity::scattering_lost_l, 1.0f - of.albedo.lobe)
        .times(Quantity::scattering_lost_v, 1.0f - s.albedo)
        .times(Quantity::scattering_mean, RL_INVERSE_PI / lit::scattering_mean(s.albedo_mean));
    times_light(between, of, Quantity::n_dot_l, s.base.n);
    times_layers(between, of, Layer::sheen);
    times_seen(between, of);
}

inline void layer_parts(const PartSource& of, TracedParts& out) {
    const lit::MaterialSurface& s = of.s;
    if (of.traits.has_sheen != 0) {
        PartWriter part(out, Term::specular, Layer::sheen);
        part.times(Quantity::sheen_color, s.sheen)
            .times(Quantity::sheen_lobe, lit::sheen_brdf(s.base.n, of.light.l, s.base.v, s.sheen_alpha));
        times_light(part, of, Quantity::n_dot_l, s.base.n);
        times_layers(part, of, Layer::coat);
        times_seen(part, of);
    }
    if (of.traits.has_coat != 0) {
        PartWriter part(out, Term::specular, Layer::coat);
        part.times(Quantity::coat_reflectance, s.coat_reflectance);
        times_lobe(part, of, s.coat_n, s.coat_alpha);
        times_light(part, of, Quantity::n_dot_l_coat, s.coat_n);
        times_above(part, of, s.coat_n);
        times_seen(part, of);
    }
}

/// One light's terms, as surface_terms.glsl forms them.
inline void trace_parts(const PartSource& of, TracedParts& out) {
    out.count = 0;
    PartWriter(out, Term::ambient, Layer::base)
        .times(Quantity::k_ambient, of.s.base.ambient)
        .times(Quantity::light_color, of.light.ambient * of.light.attenuation);
    diffuse_part(of, out);
    if (of.r.model == RL_PHONG || of.r.model == RL_BLINN_PHONG) power_part(of, out);
    if (of.r.model == RL_WARD) ward_part(of, out);
    if (of.r.model != RL_PBR) return;
    pbr_parts(of, out);
    layer_parts(of, out);
}

/// What comes from the environment, as environment_terms() forms it, and the emission under a coat.
inline void trace_parts_around(const WholePixels& p, TracedParts& out) {
    const auto& job = p.material;
    const lit::MaterialSurface& s = p.state().surface;
    const lit::MaterialTraits traits = job.traits();
    if (traits.has_coat != 0)
        PartWriter(out, Term::emission, Layer::base)
            .times(Quantity::own_emission, cpu::emission_of(job, p.point()))
            .times(Quantity::coat_rest, 1.0f - s.coat_reflectance);
    const cpu::Maps maps = cpu::maps_of(job.of);
    if (traits.has_transmission != 0 && job.of.unlit == 0)
        PartWriter(out, Term::diffuse, Layer::base)
            .times(Quantity::through, s.through)
            .times(Quantity::behind, lit::light_from_behind(maps, cpu::behind_view(*job.of.behind),
                                                            cpu::body_at(job, p.point()), s, p.point().position));
    if (job.environment() == nullptr || job.of.unlit != 0) return;
    const lit::Environment e = cpu::environment_of(*job.environment());
    PartWriter(out, Term::ambient, Layer::base)
        .times(Quantity::around_diffuse, s.around_diffuse)
        .times(Quantity::mean_light, lit::irradiance(e, lit::diffuse_normal(s, traits)));
    PartWriter(out, Term::specular, Layer::base)
        .times(Quantity::around_specular, s.around_specular)
        .times(Quantity::mirrored, lit::glossy(maps, e, s, traits, job.model()));
    if (traits.has_sheen != 0)
        PartWriter(out, Term::specular, Layer::sheen)
            .times(Quantity::around_sheen, s.around_sheen)
            .times(Quantity::mean_light_sheen, lit::irradiance(e, s.base.n));
    if (traits.has_coat != 0)
        PartWriter(out, Term::specular, Layer::coat)
            .times(Quantity::around_coat, s.around_coat)
            .times(Quantity::mirrored_coat, lit::mirrored_by_coat(maps, e, s));
}

}  // namespace rakelight::raster::RL_ISA
