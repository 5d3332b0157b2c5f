// SPDX-License-Identifier: Apache-2.0
// What a surface shows of the environment, as set_pbr_albedos() or set_around() have weighed it.
#define RL_FAN_FACETS 16

// Of a surface that is rougher along one axis: each direction of the fan reflects a lobe as wide as the surface is
// across, or as wide as their spacing. 1.2 times a direction's share of the width is a heuristic, as fan_width() is.
// Held to the lobe is the fan's mean alone, 7 degrees off at most (tests/unit/lighting/models/anisotropic_fan_test.cpp), not its
// spread. Lanes of equal widths have `even`.
RL_MAP_FN vec3 mirrored_by_fan(RL_IN(Maps) maps, RL_IN(Environment) e, RL_IN(MaterialSurface) s, vec3 even)
{
    mask is_along_t = s.alpha_x > s.alpha_y;
    mask is_uneven = is_along_t || s.alpha_y > s.alpha_x;
    if (no_lane(is_uneven)) {
        return even;
    }
    vec3 t = select(is_along_t, s.tangent, s.bitangent);
    real wide = min(max(s.alpha_x, s.alpha_y), 1.0f);
    real narrow = min(min(s.alpha_x, s.alpha_y), wide);
    real width = fan_width(wide, narrow);
    real roughness = sqrt(max(narrow, width * (1.2f / float(RL_FAN_FACETS))));
    vec3 sum = vec3(0.0f);
    real weights = 0.0f;
    for (int i = 0; i < RL_FAN_FACETS; ++i) {
        FacetRay ray = facet_ray(s.base.n, t, s.base.v, width, (float(i) + 0.5f) / float(RL_FAN_FACETS));
        sum = sum + mirrored(maps, e, ray.l, roughness) * ray.weight;
        weights = weights + ray.weight;
    }
    mask has_fan = is_uneven && weights > 1e-6f;
    return select(has_fan, sum / max(weights, 1e-6f), even);
}

// What the glossy lobe about the surface's mirror direction mirrors.
RL_MAP_FN vec3 glossy(RL_IN(Maps) maps, RL_IN(Environment) e, RL_IN(MaterialSurface) s, RL_IN(MaterialTraits) traits, int model)
{
    vec3 even = mirrored(maps, e, mirrored_about(s.base.n, s.base.v), s.roughness);
    if (model == RL_WARD || (model == RL_PBR && traits.is_anisotropic != 0)) {
        return mirrored_by_fan(maps, e, s, even);
    }
    return even;
}

RL_MAP_FN vec3 mirrored_by_coat(RL_IN(Maps) maps, RL_IN(Environment) e, RL_IN(MaterialSurface) s)
{
    return mirrored(maps, e, mirrored_about(s.coat_n, s.base.v), sqrt(s.coat_alpha));
}

// ambient: diffuse reflection; specular: gloss, sheen and coat.
RL_MAP_FN LightTerms environment_terms(RL_IN(Maps) maps, RL_IN(Environment) e, RL_IN(MaterialSurface) s, RL_IN(MaterialTraits) traits, int model)
{
    LightTerms terms;
    terms.ambient = s.around_diffuse * irradiance(e, diffuse_normal(s, traits));
    terms.diffuse = vec3(0.0f);
    terms.specular = s.around_specular * glossy(maps, e, s, traits, model);
    if (traits.has_sheen != 0) {
        terms.specular = terms.specular + s.around_sheen * irradiance(e, s.base.n);
    }
    if (traits.has_coat != 0) {
        terms.specular = terms.specular + mirrored_by_coat(maps, e, s) * s.around_coat;
    }
    return terms;
}
