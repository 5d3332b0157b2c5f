// SPDX-License-Identifier: Apache-2.0
// One light's terms for a surface of any lighting model: the classical ones of light_sum.glsl and those of more parameters.
// Layers of metallic-roughness surfaces, from below: diffuse and GGX (glTF 2.0, appendix B), sheen, clearcoat.
// n.l of a term times pi and the light's color makes radiance of a BRDF.
RL_FN vec3 radiance_of(vec3 brdf, vec3 light_color, real cosine, real attenuation)
{
    return brdf * (light_color * (RL_PI * cosine * attenuation));
}

RL_FN vec3 ward_term(RL_IN(MaterialSurface) s, RL_IN(LightSample) light, RL_IN(MaterialTraits) traits)
{
    real value = ward_brdf(s.base.n, s.tangent, s.bitangent, light.l, s.base.v, s.alpha_x, s.alpha_y, traits.ward_form);
    return radiance_of(s.base.specular * value, light.specular, lambert_cosine(dot(s.base.n, light.l)), light.attenuation);
}

// D V, F = 1.
RL_FN real pbr_lobe(RL_IN(MaterialSurface) s, vec3 l, RL_IN(MaterialTraits) traits)
{
    if (traits.is_anisotropic != 0) {
        return ggx_anisotropic_brdf(s.base.n, s.tangent, s.bitangent, l, s.base.v, s.alpha_x, s.alpha_y);
    }
    return ggx_brdf(s.base.n, l, s.base.v, s.alpha_x);
}

// Adds the layers above to the terms of diffuse and GGX, which get what the layers leave.
RL_FN LightTerms add_layers(LightTerms below, RL_IN(MaterialSurface) s, RL_IN(LightSample) light, RL_IN(LightAlbedo) albedo, RL_IN(MaterialTraits) traits)
{
    LightTerms terms = below;
    if (traits.has_sheen != 0) {
        real rest = sheen_rest(s.sheen, albedo.sheen, s.sheen_albedo);
        vec3 brdf = s.sheen * sheen_brdf(s.base.n, light.l, s.base.v, s.sheen_alpha);
        terms.diffuse = terms.diffuse * rest;
        terms.specular = terms.specular * rest + radiance_of(brdf, light.specular, lambert_cosine(dot(s.base.n, light.l)), light.attenuation);
    }
    if (traits.has_coat != 0) {
        real rest = 1.0f - s.coat_reflectance;
        real lobe = s.coat_reflectance * ggx_brdf(s.coat_n, light.l, s.base.v, s.coat_alpha);
        terms.diffuse = terms.diffuse * rest;
        terms.specular = terms.specular * rest + radiance_of(vec3(lobe), light.specular, lambert_cosine(dot(s.coat_n, light.l)), light.attenuation);
    }
    return terms;
}

// The normal of the diffuse term.
RL_FN vec3 diffuse_normal(RL_IN(MaterialSurface) s, RL_IN(MaterialTraits) traits)
{
    if (traits.has_two_normals != 0) {
        return s.diffuse_n;
    }
    return s.base.n;
}

// What the dielectric part's mirror leaves for the diffuse term: 1 - F.
RL_FN real fresnel_rest(RL_IN(MaterialSurface) s, real weight)
{
    return 1.0f - (s.dielectric_f0 + (s.dielectric_f90 - s.dielectric_f0) * weight);
}

// `diffuse`: Lambert's term, without Fresnel's loss.
RL_FN LightTerms pbr_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light, vec3 diffuse, RL_IN(LightAlbedo) albedo, RL_IN(MaterialTraits) traits)
{
    LightTerms terms;
    terms.ambient = s.base.ambient * (light.ambient * light.attenuation);
    real weight = schlick_weight_between(light.l, s.base.v);
    terms.diffuse = diffuse * fresnel_rest(s, weight);
    vec3 brdf = schlick(s.base.specular, s.f90, weight) * pbr_lobe(s, light.l, traits);
    if (traits.has_scattering != 0) {
        brdf = brdf + s.scattering * scattering_brdf(albedo.lobe, s.albedo, s.albedo_mean);
    }
    terms.specular = radiance_of(brdf, light.specular, lambert_cosine(dot(s.base.n, light.l)), light.attenuation);
    return add_layers(terms, s, light, albedo, traits);
}

// `seen`, 0..1: how much of the light reaches the surface; ambient light always does.
RL_FN LightTerms surface_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light, real seen, RL_IN(LightAlbedo) albedo, RL_IN(MaterialTraits) traits, RL_IN(Reflection) r)
{
    LightTerms terms;
    vec3 n = diffuse_normal(s, traits);
    vec3 lambert = s.base.diffuse * (light.diffuse * (lambert_cosine(dot(n, light.l)) * light.attenuation));
    if (r.model <= RL_BLINN_PHONG) {
        terms = light_terms(s.base, light, r);
        terms.diffuse = lambert;
    }
    if (r.model > RL_BLINN_PHONG) {
        terms.ambient = s.base.ambient * (light.ambient * light.attenuation);
        terms.diffuse = lambert;
        terms.specular = vec3(0.0f);
    }
    if (r.model == RL_OREN_NAYAR) {
        terms.diffuse = lambert * oren_nayar_factor(n, light.l, s.base.v, s.oren_nayar_a, s.oren_nayar_b);
    }
    if (r.model == RL_OREN_NAYAR_FULL) {
        terms.diffuse = lambert * oren_nayar_full_factor(n, light.l, s.base.v, s.oren_nayar_a, s.oren_nayar_b, s.oren_nayar_bounce, s.facet_color);
    }
    if (r.model == RL_WARD) {
        terms.specular = ward_term(s, light, traits);
    }
    if (r.model == RL_PBR) {
        terms = pbr_terms(s, light, lambert, albedo, traits);
    }
    terms.diffuse = terms.diffuse * seen;
    terms.specular = terms.specular * seen;
    return terms;
}
