// SPDX-License-Identifier: Apache-2.0
// Where rays are followed on: how much of what comes along the mirror direction and the refracted one reaches the viewer, and
// what is left of the surface's own terms then.
// Sources: Whitted 1980, "An Improved Illumination Model for Shaded Display", eq. 2 (k_s S + k_t T); glTF's KHR_materials_transmission,
// KHR_materials_volume; Schlick 1994.

// GGX lobes of at most this alpha are mirrors: half of their light lies within 2 alpha = 1.2 degrees of the mirror direction.
#define RL_MIRROR_ALPHA 0.0101f

#define RL_MIRROR_NONE 0
#define RL_MIRROR_CONSTANT 1
#define RL_MIRROR_FRESNEL 2

// Weights of the light that rays bring.
struct Transport {
    vec3 reflected;  // along the mirror direction of base.n
    vec3 coat;       // along that of coat_n
    vec3 refracted;  // from behind
};

// What a border leaves of the light that the two sides send: `mirror` reflected, `filter` times the rest let through.
RL_FN Transport transport_of(vec3 mirror, vec3 through, mask is_total)
{
    Transport t;
    vec3 rest = through * max(vec3(1.0f) - mirror, vec3(0.0f));
    vec3 none = vec3(0.0f);
    t.coat = none;
    t.reflected = mirror + select(is_total, rest, none);
    t.refracted = select(is_total, none, rest);
    return t;
}

// k_s mirrors as `mirror` (RL_MIRROR_...) says, k_t goes through; bends: the body has an index of refraction. cosine: n.v.
RL_FN Transport classical_transport(vec3 k_s, vec3 k_t, int mirror, int bends, real cosine, real eta)
{
    vec3 reflected = vec3(0.0f);
    mask is_total = mask(false);
    if (mirror == RL_MIRROR_CONSTANT) {
        reflected = k_s;
    }
    if (mirror == RL_MIRROR_FRESNEL) {
        reflected = schlick(k_s, max(k_s, vec3(1.0f)), schlick_weight(cosine));
    }
    if (bends != 0) {
        is_total = refracted_cosine_squared(cosine, eta) <= 0.0f;
        if (mirror == RL_MIRROR_FRESNEL) {
            reflected = vec3(fresnel(cosine, eta));
        }
    }
    return transport_of(reflected, k_t, is_total);
}

// base: its color; transmission 0..1. The dielectric part of a body reflects by Fresnel's equations instead of Schlick's formula, unless
// there is a film over it: has_film, whose f0 set_iridescence() has found.
RL_FN Transport metallic_transport(RL_IN(MetallicRoughness) at, vec3 base, real transmission, int bends, real cosine, real eta, int has_film, vec3 film_f0)
{
    real weight = schlick_weight(cosine);
    vec3 f0 = mix(at.dielectric_f0, base, at.metallic);
    if (has_film != 0) {
        f0 = film_f0;
    }
    vec3 mirror = schlick(f0, metallic_f90(at), weight);
    vec3 through = base * (transmission * (1.0f - at.metallic));
    mask is_total = mask(false);
    if (bends != 0) {
        is_total = refracted_cosine_squared(cosine, eta) <= 0.0f;
        vec3 exact = mix(vec3(fresnel(cosine, eta) * at.dielectric_f90), schlick(base, vec3(1.0f), weight), at.metallic);
        if (has_film == 0) {
            mirror = select(transmission > 0.0f, exact, mirror);
        }
    }
    return transport_of(mirror, through, is_total);
}

// Layers of pbr above, once s is complete: what they leave, and the coat's own mirror.
RL_FN void add_transport_layers(RL_INOUT(Transport) t, RL_IN(MaterialSurface) s, int has_sheen, int has_coat)
{
    real rest = 1.0f;
    if (has_sheen != 0) {
        rest = sheen_rest(s.sheen, s.sheen_albedo, s.sheen_albedo);
    }
    if (has_coat != 0) {
        rest = rest * (1.0f - s.coat_reflectance);
        t.coat = select(s.coat_alpha <= RL_MIRROR_ALPHA, vec3(s.coat_reflectance), vec3(0.0f));
    }
    t.reflected = t.reflected * rest;
    t.refracted = t.refracted * rest;
}

// What rays bring is not shown a second time. kept: of the diffuse terms; mirrors: lanes whose gloss rays bring, coats: likewise.
// has_sum: base.ambient is the sum of the around terms, as set_pbr_around() leaves it.
RL_FN void leave_to_rays(RL_INOUT(MaterialSurface) s, real kept, mask mirrors, mask coats, int has_sum)
{
    vec3 none = vec3(0.0f);
    s.base.diffuse = s.base.diffuse * kept;
    s.base.ambient = s.base.ambient * kept;
    s.around_diffuse = s.around_diffuse * kept;
    s.around_specular = select(mirrors, none, s.around_specular);
    s.around_coat = select(coats, 0.0f, s.around_coat);
    if (has_sum != 0) {
        s.base.ambient = s.around_diffuse + s.around_specular + s.around_sheen + vec3(s.around_coat);
    }
}
