// SPDX-License-Identifier: Apache-2.0
// One light's terms for a surface of any lighting model: the classical ones of light_sum.glsl and those of more parameters.
// Layers of metallic-roughness surfaces, from below: diffuse and GGX (glTF 2.0, appendix B), sheen, clearcoat.
#define RL_OREN_NAYAR 3
#define RL_WARD 4
#define RL_PBR 5

struct MaterialSurface {
    Surface base;     // n: the normal of the specular term. Ward: specular is rho_s; pbr: f0
    vec3 diffuse_n;   // unit, the normal of the diffuse term: bumps may act on one of them alone
    vec3 tangent;     // unit, across base.n: the axes of Ward's and GGX's lobe
    vec3 bitangent;
    real oren_nayar_a;
    real oren_nayar_b;
    real alpha_x;     // widths of Ward's and GGX's lobe, > 0
    real alpha_y;
    vec3 f90;
    real dielectric_f0;   // greatest component of what does not come from a metal: the diffuse term gets the rest
    real dielectric_f90;
    vec3 scattering;      // color of the light between the facets
    real albedo;          // of D V with F = 1, towards v, and its mean
    real albedo_mean;
    vec3 sheen;
    real sheen_alpha;
    real sheen_albedo;    // of sheen_brdf, towards v
    vec3 coat_n;
    real coat_alpha;
    real coat_reflectance;  // 0..1, towards v
    vec3 around_diffuse;    // reflectance of even light from all around, times occlusion, layer by layer: for surroundings
    vec3 around_specular;   // about the mirror direction of base.n, as wide as `roughness`
    vec3 around_sheen;      // wide
    real around_coat;       // about the mirror direction of coat_n
    real roughness;         // of around_specular, alpha = roughness^2; coat_alpha is that of around_coat
    real table_roughness;   // at which the tables of the lobe's albedos are read
};

// What a material has; the same for all lanes.
struct MaterialTraits {
    int ward_form;        // RL_WARD_1992, RL_WARD_DUER, RL_WARD_BOUNDED
    int is_anisotropic;   // pbr: the tangents are looked at
    int has_scattering;
    int has_sheen;
    int has_coat;
};

// Albedos towards the light, of tables: of D V with F = 1, and of sheen_brdf.
struct LightAlbedo {
    real lobe;
    real sheen;
};

// Albedos towards v: of D V with F = 1, its part by Schlick's weight, and of D V with the coat's alpha.
struct ViewAlbedo {
    real lobe;
    real grazing;
    real coat;
};

// Even light from all around under pbr: what each layer reflects of it, from `occlusion` and the parts that depend on v.
RL_FN MaterialSurface pbr_around(RL_IN(MaterialSurface) from, RL_IN(ViewAlbedo) albedo, real occlusion)
{
    MaterialSurface s = from;
    real steep = albedo.lobe - albedo.grazing;
    vec3 specular = s.base.specular * steep + s.f90 * albedo.grazing + s.scattering * (1.0f - albedo.lobe);
    real lost = s.dielectric_f0 * steep + s.dielectric_f90 * albedo.grazing;
    real under_sheen = sheen_rest(s.sheen, s.sheen_albedo, s.sheen_albedo);
    real under_coat = (1.0f - s.coat_reflectance) * occlusion;
    s.around_diffuse = s.base.ambient * ((1.0f - lost) * under_sheen * under_coat);
    s.around_specular = specular * (under_sheen * under_coat);
    s.around_sheen = s.sheen * (s.sheen_albedo * under_coat);
    s.around_coat = s.coat_reflectance * albedo.coat * occlusion;
    s.base.ambient = s.around_diffuse + s.around_specular + s.around_sheen + vec3(s.around_coat);
    return s;
}

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

// `diffuse`: Lambert's term, without Fresnel's loss.
RL_FN LightTerms pbr_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light, vec3 diffuse, RL_IN(LightAlbedo) albedo, RL_IN(MaterialTraits) traits)
{
    LightTerms terms;
    terms.ambient = s.base.ambient * (light.ambient * light.attenuation);
    vec3 h = safe_normalize_or(light.l + s.base.v, s.base.n);
    real weight = schlick_weight(dot(s.base.v, h));
    terms.diffuse = diffuse * (1.0f - (s.dielectric_f0 + (s.dielectric_f90 - s.dielectric_f0) * weight));
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
    vec3 lambert = s.base.diffuse * (light.diffuse * (lambert_cosine(dot(s.diffuse_n, light.l)) * light.attenuation));
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
        terms.diffuse = lambert * oren_nayar_factor(s.diffuse_n, light.l, s.base.v, s.oren_nayar_a, s.oren_nayar_b);
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
