// SPDX-License-Identifier: Apache-2.0
// The shading kernel once more, in scalar words in a namespace of its own (RL_ISA is `trace`), with a recorder: the functions
// are those of the kernel because they are its text.
#include "engines/raster/inspect/kernels/trace_kernel.h"

#include "cpu_shading/kernels/light_points.h"
#include "engines/raster/inspect/kernels/trace_maps.h"
#include "engines/raster/inspect/kernels/trace_parts.h"

namespace rakelight::raster::RL_ISA {
namespace {

using EveryJob = cpu::Job<cpu::EveryMaterial>;

/// Whether the job's lighting model reads a map of metallic-roughness materials alone.
bool reads_of_metallic_roughness(const EveryJob& job, int map) {
    if (job.material().metallic_roughness == 0) return false;
    if (map == role_specular_strength || map == role_specular_color) return !RL_IS_MATTE(job.model());
    if (map == role_anisotropy && job.model() == RL_WARD) return true;
    return job.is_pbr();
}

/// The normal map where it acts: not where lighting is not evaluated at pixels, nor with bumps off.
void trace_maps(const WholePixels& p, PixelTrace& out, TracedTexels* texels) {
    const EveryJob& job = p.material;
    for (int i = 0; i < texture_role_count; ++i) {
        if (texels != nullptr) texels[i].count = 0;
        TracedTexels* const its_texels = texels != nullptr ? &texels[i] : nullptr;
        if (i == role_normal && (job.of.bump == 0 || cpu::uses_slopes(job))) continue;
        if (i == role_height && !job.has_relief()) continue;
        if (i > role_metallic_roughness && !reads_of_metallic_roughness(job, i)) continue;
        if (i == role_height)
            trace_heights(p, out.map[i], its_texels);
        else
            trace_texture(job, i, p.point(), out.map[i], its_texels);
    }
}

void trace_normal(const WholePixels& p, PixelTrace& out) {
    const EveryJob& job = p.material;
    const SignedVector &normal = p.point().normal, &tangent = p.point().tangent;
    const vec3 n = safe_normalize(normal.v);
    put(out.interpolated, n);
    put(out.mapped, vec3(0.0f, 0.0f, 1.0f));
    out.handedness = tangent.sign;
    out.facing = normal.sign;
    out.is_of_slopes = cpu::uses_slopes(job);
    if (out.is_of_slopes) {
        put(out.tangent, p.state().bumps.frame.tangent);
        put(out.mapped, cpu::slope_vector(job.of, p.point(), p.state().bumps));
        return;
    }
    if (job.normal_map() == nullptr) return;
    put(out.tangent, lit::map_tangent(n, tangent.v, job.of.orthogonalize));
    put(out.mapped, cpu::map_vector(job, p.point()));
}

void trace_surface(const MaterialView& m, const lit::Surface& s, PixelTrace& out) {
    put(out.normal, s.n);
    put(out.view, s.v);
    put(out.k_ambient, s.ambient);
    put(out.k_diffuse, s.diffuse);
    put(out.k_specular, s.specular);
    out.exponent = s.exponent;
    const TracedTexture& map = out.map[role_metallic_roughness];
    out.metallic = map.is_used ? m.metallic * map.value[2] : m.metallic;
    out.roughness = map.is_used ? m.roughness * map.value[1] : m.roughness;
}

void trace_reach(const lighting::LightParameters& p, vec3 position, TracedLight& out) {
    out.distance = 0;
    out.attenuation = out.range_window = out.spot = 1;
    if (p.kind != lighting::LightKind::point && p.kind != lighting::LightKind::spot) return;
    const vec3 to_light = lit::broadcast3(p.position) - position;
    const lit::LightRay ray = lit::ray_to(lit::broadcast3(p.position), position);
    const real cos_angle = -dot(lit::broadcast3(p.direction), ray.l);
    const bool is_spot = p.kind == lighting::LightKind::spot;
    out.distance = sqrt(dot(to_light, to_light));
    out.range_window = lit::range_window(ray.squared, p.inverse_range);
    if (p.is_photometric) {
        out.attenuation = lit::photometric_attenuation(ray.squared, p.inverse_range);
        if (is_spot) out.spot = lit::photometric_spot(cos_angle, p.cone_scale, p.cone_offset);
    } else {
        out.attenuation = lit::classical_attenuation(ray.distance, p.constant_term, p.linear_term, p.quadratic_term);
        if (p.inverse_range > 0) out.attenuation = out.attenuation * out.range_window;
        if (is_spot) out.spot = lit::classical_spot(cos_angle, p.cos_cutoff, p.exponent);
    }
}

void trace_lobe(const lit::Surface& s, const lit::LightSample& light, const lit::Reflection& r, TracedLight& out) {
    out.n_dot_l = dot(s.n, light.l);
    out.lobe_cosine = out.lobe = out.fresnel_weight = out.specular_factor = 0;
    if (r.model == RL_LAMBERT || r.model > RL_BLINN_PHONG) return;  // theirs is no power of a cosine
    out.lobe_cosine = lit::lobe_cosine(s, light.l, r);
    out.lobe = lit::lobe(out.lobe_cosine, s.exponent, r);
    out.specular_factor = lit::specular_factor(s, light.l, lit::lambert_cosine(out.n_dot_l), r);
}

void put_terms(const lit::LightTerms& terms, TracedLight& out) {
    put(out.ambient, terms.ambient);
    put(out.diffuse, terms.diffuse);
    put(out.specular, terms.specular);
}

/// One light at a surface point, except for its terms.
void trace_light(const EveryJob& job, int32_t i, vec3 position, const lit::Surface& surface,
                 const lit::LightSample& sample, TracedLight& out) {
    trace_reach(job.of.lights[i], position, out);
    trace_lobe(surface, sample, job.reflection(), out);
    put(out.to_light, sample.l);
    put(out.own_ambient, sample.ambient);
    put(out.own_diffuse, sample.diffuse);
    put(out.own_specular, sample.specular);
    put(out.ambient_color, sample.ambient * sample.attenuation);
    put(out.diffuse_color, sample.diffuse * sample.attenuation);
    put(out.specular_color, sample.specular * sample.attenuation);
    out.seen = 1;
}

/// What the models of more parameters are made of.
void trace_parameters(const EveryJob& job, const lit::MaterialSurface& s, PixelTrace& out) {
    if (shading::is_oren_nayar(job.model())) {
        out.oren_nayar[0] = s.oren_nayar_a, out.oren_nayar[1] = s.oren_nayar_b;
        out.oren_nayar[2] = s.oren_nayar_bounce;
    }
    if (job.model() == RL_WARD || job.is_pbr()) out.lobe_alpha[0] = s.alpha_x, out.lobe_alpha[1] = s.alpha_y;
    if (!job.is_pbr()) return;
    const lit::MaterialTraits traits = job.traits();
    put(out.f90, s.f90);
    if (traits.has_coat != 0) {
        out.coat = s.coat_reflectance, out.coat_alpha = s.coat_alpha;
        put(out.coat_normal, s.coat_n);
    }
    if (traits.has_sheen == 0) return;
    put(out.sheen, s.sheen);
    out.sheen_alpha = s.sheen_alpha;
}

void trace_relief(const WholePixels& p, PixelTrace& out) {
    const EveryJob& job = p.material;
    for (int set = 0; set < 2; ++set) {
        const bool is_read = job.material().uses_texcoords[set] != 0;  // else it is not found
        const vec2 uv = p.point().texcoords[set].uv;
        out.relief_texcoord[set][0] = is_read ? uv.x : out.texcoord[set][0];
        out.relief_texcoord[set][1] = is_read ? uv.y : out.texcoord[set][1];
    }
    out.has_relief = job.of.relief.technique != 0;
    out.relief_height = -1;
    const cpu::Maps& maps = p.state().bumps.place.maps;
    if (job.has_relief() && job.of.relief.technique >= cpu_shading::relief_parallax)
        out.relief_height = (p.state().bumps.point.height - maps.height_offset) * maps.height_scale;
}

/// Environment, what is behind, and fog.
void trace_surroundings(const WholePixels& p, vec3 before_fog, PixelTrace& out) {
    const EveryJob& job = p.material;
    out.has_fog = job.of.fog.kind != 0;
    out.has_environment = job.of.environment != nullptr && job.of.unlit == 0;
    put(out.before_fog, before_fog);
    out.fog_distance = lit::fog_distance(p.point().position, splat(job.of.view_direction), job.of.orthographic);
    out.fog_share = cpu::fog_at(job.of, p.point().position);
    put(out.fog_color, splat(job.of.fog.color));
    out.has_transmission = job.traits().has_transmission != 0 && job.of.unlit == 0;
    if (out.has_transmission) put(out.transmitted, cpu::terms_from_behind(job, p.point(), p.state().surface).diffuse);
    if (!out.has_environment) return;
    const lit::LightTerms terms = cpu::environment_terms(job, p.state().surface);
    put(out.environment[0], terms.ambient);
    put(out.environment[1], terms.diffuse);
    put(out.environment[2], terms.specular);
}

/// Ward's and GGX's lobe.
void trace_wide_lobe(const EveryJob& job, const lit::MaterialSurface& s, const lit::MaterialTraits& traits,
                     const lit::LightSample& light, TracedLight& out) {
    if (job.model() != RL_WARD && !job.is_pbr()) return;
    const vec3 h = lit::half_vector(light.l, s.base.v, s.base.n);
    out.lobe_cosine = dot(s.base.n, h);
    if (job.is_pbr()) {
        out.lobe = lit::pbr_lobe(s, light.l, traits);
        out.fresnel_weight = lit::schlick_weight(dot(s.base.v, h));
    } else {
        out.lobe =
            lit::ward_brdf(s.base.n, s.tangent, s.bitangent, light.l, s.base.v, s.alpha_x, s.alpha_y, traits.ward_form);
    }
    out.specular_factor = out.lobe * (RL_PI * lit::lambert_cosine(out.n_dot_l));
}

/// The factors of one light's terms.
void trace_factors(const EveryJob& job, const lit::MaterialSurface& s, const lit::MaterialTraits& traits,
                   const lit::LightSample& light, real seen, TracedParts* parts) {
    if (parts == nullptr) return;
    const lit::LightAlbedo albedo = lit::light_albedo(s, cpu::maps_of(job.of), light.l, traits, job.model());
    trace_parts({s, light, traits, job.reflection(), albedo, seen}, *parts);
}

void trace_lights(const WholePixels& p, TracedLight* lights, TracedParts* parts) {
    const EveryJob& job = p.material;
    const lit::MaterialSurface& s = p.state().surface;
    const lit::MaterialTraits traits = job.traits();
    for (int32_t i = 0; i < job.of.light_count; ++i) {
        lit::LightSample sample = cpu::sample_light_at(job, p.source, p.state(), 0, i);
        trace_light(job, i, p.point().position, s.base, sample, lights[i]);
        trace_wide_lobe(job, s, traits, sample, lights[i]);
        lights[i].seen = cpu::seen_of(job, p.state(), 0, i, sample, p.seen());
        trace_factors(job, s, traits, sample, lights[i].seen, parts == nullptr ? nullptr : parts + i);
        put_terms(lit::no_terms(), lights[i]);
    }
    vec3 sum = p.state().emission;
    int32_t done = 0;
    const auto put_sums = [&](int32_t end) {
        for (; done < end; ++done) put(lights[done].sum, sum);
    };
    cpu::for_each_light(job, p.source, p.b, p.seen(), [&](int32_t, int32_t i, const lit::LightTerms& terms) {
        put_sums(i);
        put_terms(terms, lights[i]);
        sum = sum + lit::radiance_of_terms(terms);
    });
    put_sums(job.of.light_count);
}

void trace_received(const WholePixels& p, PixelTrace& out) {
    const lit::LightTerms light = p.source.corner_light(0);
    put(out.received[0], light.ambient);
    put(out.received[1], light.diffuse);
    put(out.received[2], light.specular);
}

void trace_place(const WholePixels& whole, PixelTrace& out) {
    const Pixels& p = whole.pixels();
    out.barycentric[0] = 1.0f - p.b.b1 - p.b.b2, out.barycentric[1] = p.b.b1, out.barycentric[2] = p.b.b2;
    put(out.position, whole.point().position);
    for (int set = 0; set < 2; ++set) {
        TexCoords c;
        find_texcoords(p.records, p.b, set, c);
        out.texcoord[set][0] = c.uv.x, out.texcoord[set][1] = c.uv.y;
    }
}

}  // namespace

void trace_point(const ShadeJob* job, float roughness, const float (&position)[3], const float (&normal)[3],
                 float (&received)[3][3], TracedLight* lights, TracedParts* parts) {
    const EveryJob every{*job};
    const vec3 at = splat(position);
    const lit::MaterialSurface s = cpu::surface_of_point(every, roughness, at, splat(normal));
    const lit::MaterialTraits traits = cpu::point_traits(every);
    for (int32_t i = 0; i < job->light_count; ++i) {
        const lit::LightSample sample = lit::sample_light(job->lights[i], at);
        trace_light(every, i, at, s.base, sample, lights[i]);
        trace_wide_lobe(every, s, traits, sample, lights[i]);
        trace_factors(every, s, traits, sample, 1.0f, parts + i);
        put_terms(cpu::terms_of_point(every, s, sample), lights[i]);
    }
    const lit::LightTerms sum = cpu::light_of_point(every, roughness, at, at, splat(normal));
    put(received[0], sum.ambient);
    put(received[1], sum.diffuse);
    put(received[2], sum.specular);
}

void trace_pixel(const ShadeJob* job, PixelTrace* pixel, TracedLight* lights, TracedTexels* texels,
                 TracedParts* parts) {
    PixelTrace& out = *pixel;
    out = PixelTrace{};
    WholePixels p(*job, 0);
    const lit::MaterialSurface& s = p.state().surface;
    trace_place(p, out);
    trace_maps(p, out, texels);
    put(out.vertex_color, p.source.color(0));
    put(out.paint, p.state().base.paint);
    put(out.base_color, p.state().base.color);
    trace_normal(p, out);
    trace_surface(*job->material, s.base, out);
    put(out.diffuse_normal, s.diffuse_n);
    trace_parameters(p.material, s, out);
    put(out.emission, p.state().emission);
    trace_relief(p, out);
    out.openness = job->openness != nullptr ? p.source.openness(0) : -1.0f;
    out.is_lit_at_corners = job->unlit == 0 && job->lit != nullptr;
    if (out.is_lit_at_corners) trace_received(p, out);
    if (job->unlit == 0 && job->lit == nullptr) trace_lights(p, lights, parts);
    if (parts != nullptr) trace_parts_around(p, parts[job->light_count]);
    vec3 radiance[1];
    cpu::find_radiance(p.material, p.source, p.b, p.seen(), radiance);
    trace_surroundings(p, radiance[0], out);
    put(out.color, cpu::behind_fog(p.material, p.point().position, radiance[0]));
    out.alpha = cpu::alpha_in_silhouette(p.material, p.state().bumps, p.state().base.color.w);
}

}  // namespace rakelight::raster::RL_ISA
