// SPDX-License-Identifier: Apache-2.0
// What both stages know of a draw, and points that are lit before there are pixels (flat and Gouraud shading).
// The numbers of the material (m_...) are put before this text, as choices RL_... are: program_text.cpp.

Reflection reflection()
{
    Reflection r;
    r.model = RL_MODEL;
    r.form = RL_FORM;
    r.horizon = RL_HORIZON;
    r.whole_exponent = 0;  // pow() is the faster one here
    return r;
}

MaterialTraits traits(int has_layers)
{
    MaterialTraits t;
    t.ward_form = RL_WARD_FORM;
    t.is_anisotropic = RL_IS_ANISOTROPIC * has_layers;
    t.has_scattering = RL_HAS_SCATTERING;
    t.has_sheen = RL_HAS_SHEEN * has_layers;
    t.has_coat = RL_HAS_COAT * has_layers;
    t.has_two_normals = RL_HAS_TWO_NORMALS * has_layers;
    t.has_transmission = RL_HAS_TRANSMISSION * has_layers;
    t.has_iridescence = RL_HAS_IRIDESCENCE * has_layers;
    return t;
}

Maps plain_maps()
{
    Maps maps;
    maps.height_scale = 1.0;
    maps.height_offset = 0.0;
    maps.shadow_origin = ivec2(0);
    return maps;
}

void set_slopes(vec3 facet_color, inout MaterialSurface s) { set_oren_nayar(s, m_sigma >= 0.0 ? m_sigma : sigma_of_roughness(s.roughness), facet_color); }

// One light's terms; `seen`, 0..1: how much of it reaches the surface.
LightTerms material_terms(MaterialSurface s, LightSample light, float seen, MaterialTraits t)
{
#if RL_CALLS_LIGHTING
    clear_terms();
    LightTerms terms = user_terms(s, light);
    terms.diffuse = terms.diffuse * seen;
    terms.specular = terms.specular * seen;
    return terms;
#else
    LightAlbedo albedo = light_albedo(s, plain_maps(), light.l, t, RL_MODEL);
    return surface_terms(s, light, seen, albedo, t, reflection());
#endif
}

// Ambient and diffuse terms, specular terms.
struct MatteAndGloss {
    vec3 matte;
    vec3 gloss;
};

MatteAndGloss matte_and_gloss(MatteAndGloss sum, LightTerms terms)
{
    sum.matte = sum.matte + (terms.ambient + terms.diffuse);
    sum.gloss = sum.gloss + terms.specular;
    return sum;
}

#if RL_LIT_AT != RL_AT_PIXELS
// m_mean_roughness: of the material, with the mean of its map.
MaterialSurface surface_of_vertex(vec3 position, vec3 normal)
{
    vec3 v = to_viewer(position, rl_view_direction, RL_PARALLEL_VIEWER);
    float exponent = RL_IS_METALLIC != 0 ? exponent_of_roughness(m_mean_roughness) : m_shininess;
    Surface base = unit_surface(normal, v, exponent, reflection());
    MaterialSurface s = unit_material(base, plain_maps(), RL_IS_METALLIC != 0 ? m_mean_roughness : m_lobe_roughness, m_ward_alpha);
    set_slopes(m_base_color.xyz, s);
    if (RL_IS_METALLIC != 0) {
        set_point_dielectric(s, m_dielectric_color, m_specular_strength);
    } else {
        set_classical_dielectric(s, classical_f0(m_specular, m_lobe_roughness, RL_FORM));
    }
    return s;
}

LightTerms light_of_vertex(vec3 position, vec3 normal)
{
    MaterialSurface s = surface_of_vertex(position, normal);
    LightTerms sum = no_terms();
#if RL_IS_USER
    set_lit_point(position, vec4(0.0), vec3(0.0, 0.0, 1.0), 1.0);
#define RL_ADD_VERTEX_LIGHT(i) rl_point.light = i; sum = both_terms(sum, material_terms(s, light_sample(i, position), 1.0, traits(0)));
#else
#define RL_ADD_VERTEX_LIGHT(i) sum = both_terms(sum, material_terms(s, light_sample(i, position), 1.0, traits(0)));
#endif
#if RL_LIGHTS_ARE_NEAR
    RL_EACH_LIGHT(RL_ADD_VERTEX_LIGHT)
#else
    for (int i = 0; i < rl_light_count.x; ++i) {
        RL_ADD_VERTEX_LIGHT(i)
    }
#endif
    return sum;
}

// What the stage hands on: per unit of reflectance, or of the material's factors.
void hand_on(LightTerms light, inout vec3 ambient, inout vec3 diffuse, inout vec3 specular)
{
    ambient = light.ambient;
    diffuse = light.diffuse;
    specular = light.specular;
#if RL_PAINTS_LAST
    diffuse = light.ambient * m_ambient + light.diffuse * m_base_color.xyz;
    specular = light.specular * m_specular;
#endif
}
#endif
