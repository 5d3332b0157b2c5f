// SPDX-License-Identifier: Apache-2.0
// The shading kernel once more, in scalar words in a namespace of its own (RL_ISA is `trace`), with a recorder: the functions
// are those of the kernel because they are its text.
#include "engines/raster/kernels/full_kernel.cpp"
#include "engines/raster/kernels/shade_kernel.cpp"

#include "engines/raster/inspect/kernels/trace_kernel.h"
#include "engines/raster/inspect/kernels/trace_parts.h"

namespace rakelight::raster::RL_ISA {
namespace {

void put(float (&to)[3], vec3 v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }
void put(float (&to)[4], vec4 v) { to[0] = v.x, to[1] = v.y, to[2] = v.z, to[3] = v.w; }

/// A texel of the border is one of the opposite edge, or of the same.
int32_t wrapped(int32_t i, int32_t size, int32_t mode) {
    return mode == wrap_repeat ? (i + size) % size : clamp(i, 0, size - 1);
}

void put_texel(const TextureView& t, int32_t texel, int32_t probe, float weight, TracedTexels& out) {
    if (!(weight > 0.0f) || out.count == most_texels) return;
    TracedTexel& to = out.texel[out.count];
    to.probe = probe;
    to.level = 0;
    const auto begin = [&t](int32_t level) { return t.origin[level] - t.width[level] - 3; };  // of its border
    while (to.level + 1 < t.levels && texel >= begin(to.level + 1)) ++to.level;
    const int32_t place = texel - begin(to.level), stride = t.width[to.level] + 2;
    to.x = wrapped(place % stride - 1, t.width[to.level], t.wrap_u);
    to.y = wrapped(place / stride - 1, t.height[to.level], t.wrap_v);
    for (int32_t i = 0; i < out.count; ++i) {
        TracedTexel& known = out.texel[i];
        if (known.probe != probe || known.level != to.level || known.x != to.x || known.y != to.y) continue;
        known.weight += weight;
        return;
    }
    ++out.count;
    to.weight = weight;
    Footprint alone{};
    alone.taps[0].texel = texel;
    put(to.value, sample(t, alone));
}

float weight_of(int32_t fixed) { return float(fixed & 0xffff) / float(1 << fraction_bits); }

void trace_taps(const TextureView& t, const Taps& taps, bool linear, int32_t probe, float weight, TracedTexels& out) {
    if (!linear) return put_texel(t, taps.texel, probe, weight, out);
    const float right = weight_of(taps.along_x), lower = weight_of(taps.along_y);
    for (int32_t k = 0; k < 4; ++k)
        put_texel(t, taps.texel + k % 2 + k / 2 * taps.stride, probe,
                  weight * (k % 2 == 0 ? 1.0f - right : right) * (k / 2 == 0 ? 1.0f - lower : lower), out);
}

/// The texels of a footprint.
void trace_texels(const TextureView& t, const Footprint& f, int32_t probe, float weight, TracedTexels& out) {
    const float second = f.has_two_levels ? weight_of(f.between) : 0.0f;
    trace_taps(t, f.taps[0], f.linear, probe, weight * (1.0f - second), out);
    if (f.has_two_levels) trace_taps(t, f.taps[1], f.linear, probe, weight * second, out);
}

/// How texel() reads: the probes and their level of detail; one in the middle where none are wanted.
lit::Probes trace_probes(const TextureView& t, const TexCoords& c, int32_t most, TracedTexture& out) {
    lit::Probes p{};
    if (most > 1 && t.mip != mip_none && t.levels > 1) p = probes_of(t, c, most);
    out.probes = 1;
    out.axis_u = out.axis_v = 0;
    out.level_of_detail = p.is_stretched ? p.lod : level_of_detail(t, c);
    if (!p.is_stretched) return p;
    out.probes = to_int(p.count);
    out.axis_u = p.axis.x, out.axis_v = p.axis.y;
    return p;
}

/// What texel() reads where: its coordinates, probes and levels.
void trace_texture(const TextureSlot& slot, const Pixels& p, TracedTexture& out, TracedTexels* texels) {
    if (slot.view == nullptr) return;
    const TextureView& t = *slot.view;
    TexCoords room;
    const TexCoords& c = transformed(slot, p.texcoords[slot.texcoord_set == 0 ? 0 : 1], room);
    out.is_used = 1;
    out.u = c.uv.x;
    out.v = c.uv.y;
    const lit::Probes probes = trace_probes(t, c, p.anisotropy, out);
    out.level = 0;
    if (t.mip != mip_none && t.levels > 1 && out.level_of_detail > 0.0f) {
        out.level = clamp(out.level_of_detail, 0.0f, float(t.levels - 1));
        if (t.mip == mip_nearest) out.level = float(to_int(out.level + 0.5f));
    }
    put(out.value, texel(slot, p));
    if (texels == nullptr) return;
    const bool linear = (out.probes > 1 || out.level_of_detail > 0.0f ? t.minify_linear : t.magnify_linear) != 0;
    for (int32_t i = 0; i < out.probes; ++i) {
        TexCoords at = c;
        if (out.probes > 1) at.uv = lit::probe_place(probes, c.uv, i);
        trace_texels(t, footprint_of(t, at, out.level_of_detail, linear), i, 1.0f / float(out.probes), *texels);
    }
}

/// The mip level that sample() reads at a level of detail.
float level_read(const TextureView& t, float lod) {
    if (t.mip == mip_none || t.levels == 1) return 0.0f;
    const float level = clamp(lod, 0.0f, float(t.levels - 1));
    return t.mip == mip_nearest ? float(to_int(level + 0.5f)) : level;
}

/// How the height map is read where the ray arrives: four heights a probe where the normal is that of its slopes.
void trace_heights(const ShadeJob& job, const FullPixels& f, TracedTexture& out, TracedTexels* texels) {
    const HeightPlace& place = f.bumps.place;
    const vec2 uv = f.bumps.point.uv;
    const TextureSlot& slot = job.material->map[role_height];
    const TextureView& t = *slot.view;
    const bool is_slope = uses_slopes(job);
    TexCoords room;
    TexCoords at = transformed(slot, f.p.texcoords[slot.texcoord_set == 0 ? 0 : 1], room);
    lit::Probes probes{};
    probes.count = probes.inverse = 1.0f, probes.lod = place.lod;
    if (is_slope && f.p.anisotropy > 1) probes = slope_probes(place, at, f.p.anisotropy);
    const lit::HeightLevels levels = height_levels(t);
    const real level = is_slope ? lit::slope_level(levels, probes.lod) : probes.lod;
    const real half = is_slope ? 0.5f * lit::slope_width(levels, level) : 0.0f;
    const vec2 ways[4] = {vec2(half / float(t.width[0]), 0.0f), vec2(-half / float(t.width[0]), 0.0f),
                          vec2(0.0f, half / float(t.height[0])), vec2(0.0f, -half / float(t.height[0]))};
    out.is_used = 1;
    out.u = uv.x, out.v = uv.y;
    out.probes = to_int(probes.count);
    out.axis_u = out.axis_v = 0;
    if (out.probes > 1) out.axis_u = probes.axis.x, out.axis_v = probes.axis.y;
    out.level_of_detail = probes.lod;
    out.level = level_read(t, level);
    const int32_t heights = is_slope ? 4 : 1;
    const real share = 1.0f / float(heights * out.probes);
    vec4 sum(0.0f);
    for (int32_t i = 0; i < out.probes; ++i)
        for (int32_t k = 0; k < heights; ++k) {
            at.uv = (out.probes > 1 ? lit::probe_place(probes, uv, i) : uv) + ways[k];
            const Footprint footprint = footprint_of(t, at, level, true);
            sum = sum + sample(t, footprint) * share;
            if (texels != nullptr) trace_texels(t, footprint, i, share, *texels);
        }
    put(out.value, sum);
}

/// Whether the job's lighting model reads a map of metallic-roughness materials alone.
bool reads_of_metallic_roughness(const ShadeJob& job, int map) {
    if (job.material->metallic_roughness == 0) return false;
    if (map == role_specular_strength || map == role_specular_color)
        return job.reflection_model != RL_LAMBERT && job.reflection_model != RL_OREN_NAYAR;
    if (map == role_anisotropy && job.reflection_model == RL_WARD) return true;
    return job.full != nullptr && is_pbr(job);
}

/// The normal map where it acts: not where lighting is not evaluated at pixels, nor with bumps off.
void trace_maps(const ShadeJob& job, const FullPixels& f, PixelTrace& out, TracedTexels* texels) {
    const Pixels& p = f.p;
    const MaterialView& m = *job.material;
    const bool has_heights = job.full != nullptr && has_relief(job);
    for (int i = 0; i < texture_role_count; ++i) {
        if (texels != nullptr) texels[i].count = 0;
        TracedTexels* const its_texels = texels != nullptr ? &texels[i] : nullptr;
        if (i == role_normal && (job.bump == 0 || (has_heights && uses_slopes(job)))) continue;
        if (i == role_height && !has_heights) continue;
        if (i > role_metallic_roughness && !reads_of_metallic_roughness(job, i)) continue;
        if (i == role_height)
            trace_heights(job, f, out.map[i], its_texels);
        else
            trace_texture(m.map[i], p, out.map[i], its_texels);
    }
}

void trace_normal(const ShadeJob& job, const FullPixels& f, PixelTrace& out) {
    const Pixels& p = f.p;
    const MaterialView& m = *job.material;
    const SignedVector normal = normal_at(p.records, p.b), tangent = tangent_at(p.records, p.b);
    const vec3 n = safe_normalize(normal.v);
    put(out.interpolated, n);
    put(out.mapped, vec3(0.0f, 0.0f, 1.0f));
    out.handedness = tangent.sign;
    out.facing = normal.sign;
    out.is_of_slopes = job.full != nullptr && uses_slopes(job);
    if (out.is_of_slopes) {
        put(out.tangent, f.bumps.frame.tangent);
        put(out.mapped, slope_vector(job, p, f.bumps));
        return;
    }
    if (job.bump == 0 || m.map[role_normal].view == nullptr) return;
    put(out.tangent, lit::map_tangent(n, tangent.v, job.orthogonalize));
    put(out.mapped, job.full != nullptr ? map_vector(job, p)
                                        : lit::decode_normal(rgb(texel(m.map[role_normal], p)), m.normal_scale));
}

void trace_surface(const MaterialView& m, const lit::Surface& s, PixelTrace& out) {
    put(out.normal, s.n);
    put(out.diffuse_normal, s.n);
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

/// One light at a surface point; not its place in the sum.
lit::LightTerms trace_light(const ShadeJob& job, int32_t i, vec3 position, const lit::Surface& surface,
                            const lit::LightSample& sample, TracedLight& out) {
    const lit::Reflection reflection = reflection_of(job);
    const lit::LightTerms terms = lit::light_terms(surface, sample, reflection);
    trace_reach(job.lights[i], position, out);
    trace_lobe(surface, sample, reflection, out);
    put(out.to_light, sample.l);
    put(out.own_ambient, sample.ambient);
    put(out.own_diffuse, sample.diffuse);
    put(out.own_specular, sample.specular);
    put(out.ambient_color, sample.ambient * sample.attenuation);
    put(out.diffuse_color, sample.diffuse * sample.attenuation);
    put(out.specular_color, sample.specular * sample.attenuation);
    put_terms(terms, out);
    out.seen = 1;
    return terms;
}

/// The factors of what the plain kernel's models give; `parts` may be null.
void trace_plain_parts(const ShadeJob& job, const lit::Surface& surface, const lit::LightSample& light,
                       TracedParts* parts) {
    if (parts == nullptr) return;
    lit::MaterialSurface s;
    s.base = surface;
    s.diffuse_n = surface.n;
    const lit::MaterialTraits none = {};
    const lit::Reflection reflection = reflection_of(job);
    trace_parts({s, light, none, reflection, {}, 1.0f}, *parts);
}

void trace_lights(const ShadeJob& job, const Pixels& p, const lit::Surface& surface, vec3 sum, TracedLight* lights,
                  TracedParts* parts) {
    for (int32_t i = 0; i < job.light_count; ++i) {
        const lit::LightSample sample = lit::sample_light(job.lights[i], p.position);
        trace_light(job, i, p.position, surface, sample, lights[i]);
        trace_plain_parts(job, surface, sample, parts == nullptr ? nullptr : parts + i);
        sum = lit::add_light(sum, surface, sample, reflection_of(job));
        put(lights[i].sum, sum);
    }
}

/// What the models of more parameters are made of.
void trace_parameters(const ShadeJob& job, const lit::MaterialSurface& s, PixelTrace& out) {
    if (job.reflection_model == RL_OREN_NAYAR) out.oren_nayar[0] = s.oren_nayar_a, out.oren_nayar[1] = s.oren_nayar_b;
    if (job.reflection_model == RL_WARD || is_pbr(job)) out.lobe_alpha[0] = s.alpha_x, out.lobe_alpha[1] = s.alpha_y;
    if (!is_pbr(job)) return;
    const lit::MaterialTraits traits = traits_of(job);
    put(out.f90, s.f90);
    if (traits.has_coat != 0) {
        out.coat = s.coat_reflectance, out.coat_alpha = s.coat_alpha;
        put(out.coat_normal, s.coat_n);
    }
    if (traits.has_sheen == 0) return;
    put(out.sheen, s.sheen);
    out.sheen_alpha = s.sheen_alpha;
}

/// What the full kernel has beside the plain one.
void trace_full(const ShadeJob& job, const FullPixels& f, PixelTrace& out) {
    put(out.diffuse_normal, f.surface.diffuse_n);
    trace_parameters(job, f.surface, out);
    for (int set = 0; set < 2; ++set) {
        const bool is_read = job.material->uses_texcoords[set] != 0;  // else it is not found
        const vec2 uv = f.p.texcoords[set].uv;
        out.relief_texcoord[set][0] = is_read ? uv.x : out.texcoord[set][0];
        out.relief_texcoord[set][1] = is_read ? uv.y : out.texcoord[set][1];
    }
    out.has_relief = job.full->relief.technique != 0;
    out.relief_height = -1;
    const Maps& maps = f.bumps.place.maps;
    if (has_relief(job) && job.full->relief.technique >= relief_parallax)
        out.relief_height = (f.bumps.point.height - maps.height_offset) * maps.height_scale;
    out.has_fog = job.full->fog.kind != 0;
    out.has_environment = job.full->environment != nullptr && job.unlit == 0;
    put(out.before_fog, radiance_before_fog(job, f));
    out.fog_distance = lit::fog_distance(f.p.position, splat(job.view_direction), job.orthographic);
    out.fog_share = fog_of(job, f.p);
    put(out.fog_color, splat(job.full->fog.color));
    if (!out.has_environment) return;
    const lit::LightTerms terms = environment_terms(job, f.surface);
    put(out.environment[0], terms.ambient);
    put(out.environment[1], terms.diffuse);
    put(out.environment[2], terms.specular);
}

/// Ward's and GGX's lobe.
void trace_full_lobe(const ShadeJob& job, const lit::MaterialSurface& s, const lit::MaterialTraits& traits,
                     const lit::LightSample& light, TracedLight& out) {
    if (job.reflection_model != RL_WARD && !is_pbr(job)) return;
    const vec3 h = lit::half_vector(light.l, s.base.v, s.base.n);
    out.lobe_cosine = dot(s.base.n, h);
    if (is_pbr(job)) {
        out.lobe = lit::pbr_lobe(s, light.l, traits);
        out.fresnel_weight = lit::schlick_weight(dot(s.base.v, h));
    } else {
        out.lobe =
            lit::ward_brdf(s.base.n, s.tangent, s.bitangent, light.l, s.base.v, s.alpha_x, s.alpha_y, traits.ward_form);
    }
    out.specular_factor = out.lobe * (RL_PI * lit::lambert_cosine(out.n_dot_l));
}

lit::LightAlbedo albedo_of(const ShadeJob& job, const lit::MaterialSurface& s, const lit::LightSample& light,
                           const lit::MaterialTraits& traits) {
    return lit::light_albedo(s, maps_of(job), light.l, traits, job.reflection_model);
}

void trace_full_lights(const ShadeJob& job, const FullPixels& f, TracedLight* lights, TracedParts* parts) {
    vec3 sum = f.emission;
    const lit::MaterialTraits traits = traits_of(job);
    const lit::Reflection reflection = reflection_of(job);
    for (int32_t i = 0; i < job.light_count; ++i) {
        const lit::LightSample sample = sample_in_frame(job, i, f.p, f.bumps);
        trace_light(job, i, f.p.position, f.surface.base, sample, lights[i]);
        trace_full_lobe(job, f.surface, traits, sample, lights[i]);
        lights[i].seen = seen_of(job, i, f, sample);
        if (parts != nullptr)
            trace_parts(
                {f.surface, sample, traits, reflection, albedo_of(job, f.surface, sample, traits), lights[i].seen},
                parts[i]);
        const lit::LightTerms terms = full_light(job, i, f);
        put_terms(terms, lights[i]);
        sum = sum + lit::radiance_of_terms(terms);
        put(lights[i].sum, sum);
    }
}

void trace_received(const ShadeJob& job, const Pixels& p, PixelTrace& out) {
    const lit::LightTerms light = interpolate_light(job.lit, p.triangle, p.b);
    put(out.received[0], light.ambient);
    put(out.received[1], light.diffuse);
    put(out.received[2], light.specular);
}

/// What find_full() finds, by the plain kernel's functions.
void find_plain(const ShadeJob& job, FullPixels& f) {
    f.p.find(job, 0);
    find_texcoords(*job.material, f.p);
    f.base = base_color(*job.material, f.p);
    set_reflectance(job, f.p, f.base, f.surface.base);
    f.surface.base.n = shading_normal(job, f.p);
    f.surface.base.v = to_viewer(job, f.p.position);
    f.emission = emission_of(*job.material, f.p);
}

void trace_place(const Pixels& p, PixelTrace& out) {
    out.barycentric[0] = 1.0f - p.b.b1 - p.b.b2, out.barycentric[1] = p.b.b1, out.barycentric[2] = p.b.b2;
    put(out.position, p.position);
    for (int set = 0; set < 2; ++set) {
        TexCoords c;
        find_texcoords(p.records, p.b, set, c);
        out.texcoord[set][0] = c.uv.x, out.texcoord[set][1] = c.uv.y;
    }
}

/// As the engine's own kernel has it.
vec3 color_of(const ShadeJob& job) {
    if (job.full != nullptr) {
        FullPixels f;
        find_full(job, 0, f);
        return full_radiance(job, f);
    }
    Block b;
    b.count = 1;
    find_surfaces(job, 0, b);
    light_surfaces(job, b);
    return b.radiance[0];
}

/// One light at a point that is lit before there are pixels.
lit::LightTerms trace_full_point(const ShadeJob& job, const lit::MaterialSurface& s, const lit::LightSample& light,
                                 TracedLight& out, TracedParts& parts) {
    const lit::MaterialTraits traits = point_traits(job);
    const lit::Reflection reflection = reflection_of(job);
    const lit::LightTerms terms = point_terms(job, s, light);
    trace_full_lobe(job, s, traits, light, out);
    trace_parts({s, light, traits, reflection, albedo_of(job, s, light, traits), 1.0f}, parts);
    put_terms(terms, out);
    return terms;
}

}  // namespace

void trace_point(const ShadeJob* job, float roughness, const float (&position)[3], const float (&normal)[3],
                 float (&received)[3][3], TracedLight* lights, TracedParts* parts) {
    const vec3 at = splat(position);
    const lit::Surface surface = point_surface(*job, roughness, splat(normal), to_viewer(*job, at));
    vec3 sum[3] = {vec3(0.0f, 0.0f, 0.0f), vec3(0.0f, 0.0f, 0.0f), vec3(0.0f, 0.0f, 0.0f)};
    for (int32_t i = 0; i < job->light_count; ++i) {
        const lit::LightSample sample = lit::sample_light(job->lights[i], at);
        lit::LightTerms terms = trace_light(*job, i, at, surface, sample, lights[i]);
        if (job->full != nullptr)
            terms = trace_full_point(*job, full_point(*job, roughness, at, splat(normal)), sample, lights[i], parts[i]);
        else
            trace_plain_parts(*job, surface, sample, parts + i);
        sum[0] = sum[0] + terms.ambient;
        sum[1] = sum[1] + terms.diffuse;
        sum[2] = sum[2] + terms.specular;
    }
    for (int k = 0; k < 3; ++k) put(received[k], sum[k]);
}

void trace_pixel(const ShadeJob* job, PixelTrace* pixel, TracedLight* lights, TracedTexels* texels,
                 TracedParts* parts) {
    PixelTrace& out = *pixel;
    out = PixelTrace{};
    FullPixels f;
    if (job->full != nullptr)
        find_full(*job, 0, f);
    else
        find_plain(*job, f);
    const Pixels& p = f.p;
    trace_place(p, out);
    trace_maps(*job, f, out, texels);
    put(out.vertex_color, interpolate_color(p.records, p.b));
    put(out.paint, f.base.paint);
    put(out.base_color, f.base.color);
    trace_normal(*job, f, out);
    trace_surface(*job->material, f.surface.base, out);
    put(out.emission, f.emission);
    if (job->full != nullptr) trace_full(*job, f, out);
    out.is_lit_at_corners = job->unlit == 0 && job->lit != nullptr;
    if (out.is_lit_at_corners) trace_received(*job, p, out);
    if (job->unlit == 0 && job->lit == nullptr) {
        if (job->full != nullptr)
            trace_full_lights(*job, f, lights, parts);
        else
            trace_lights(*job, p, f.surface.base, f.emission, lights, parts);
    }
    if (parts != nullptr && job->full != nullptr) trace_parts_around(*job, f, parts[job->light_count]);
    put(out.color, color_of(*job));
    out.alpha = job->full != nullptr ? shown_alpha(*job, f.bumps, f.base.color.w) : f.base.color.w;
}

}  // namespace rakelight::raster::RL_ISA
