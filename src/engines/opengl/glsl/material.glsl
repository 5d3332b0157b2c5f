// SPDX-License-Identifier: Apache-2.0
// What a material of any lighting model is at a pixel: its factors and texels given to the lighting text, as
// cpu_shading/kernels/material.h gives them. RL_HAS_<ROLE>_MAP, <role>_texel(p): program_text.cpp.
struct BaseColor {
    vec4 paint;  // vertex color times texture
    vec4 color;  // that times the material's factor; alpha with the opacity map
};

BaseColor base_color(Point p)
{
    BaseColor base;
    base.paint = base_color_texel(p);
#if RL_HAS_COLORS
    base.paint = p.color * base.paint;
#endif
    base.color = m_base_color * base.paint;
    base.color.w = base.color.w * opacity_texel(p).x;
    return base;
}

struct MaterialTexels {
    vec4 metallic_roughness;
    float occlusion;  // 0..1
};

MaterialTexels material_texels(Point p)
{
    MaterialTexels t;
    t.metallic_roughness = metallic_roughness_texel(p);
    t.occlusion = 1.0;
#if RL_HAS_OCCLUSION_MAP && (RL_MODEL != RL_PBR || RL_HAS_LIGHT_AROUND)
    t.occlusion = occlusion_factor(m_occlusion_strength, RL_OCCLUSION_IN_METALLIC != 0 ? t.metallic_roughness : occlusion_texel(p));
#endif
    return t;
}

MetallicRoughness metallic_roughness_at(Point p, MaterialTexels t)
{
    MetallicRoughness at;
    at.metallic = m_metallic;
    at.roughness = m_roughness;
    apply_metallic_roughness(at, t.metallic_roughness);
    apply_specular(at, m_dielectric_color, m_specular_strength, specular_color_texel(p), specular_strength_texel(p));
    return at;
}

// Where lights fall on the material's factors alone (RL_PAINTS_LAST), what they give is multiplied by the texels after their
// sum: fewer numbers live through it.
vec3 painted(Point p, BaseColor base, MatteAndGloss sum)
{
    return base.paint.xyz * sum.matte + specular_texel(p).xyz * sum.gloss;
}

void set_factors(inout Surface s)
{
    s.diffuse = m_base_color.xyz;
    set_classical_reflectance(s, m_ambient, m_specular, m_shininess, vec3(1.0), vec4(1.0));
    s.lobe_scale = lobe_scale(s.exponent, reflection());
}

void set_classical(Point p, vec3 paint, inout Surface s)
{
    set_classical_reflectance(s, m_ambient, m_specular, m_shininess, paint, specular_texel(p));
}

// What the material reflects under the sums of light_sum.glsl.
void set_classical_sum(Point p, MaterialTexels t, BaseColor base, inout Surface s)
{
    s.diffuse = base.color.xyz;
    if (RL_IS_METALLIC != 0) {
        MetallicRoughness at = metallic_roughness_at(p, t);
        set_metallic_reflectance(s, at, base.color.xyz);
        s.exponent = exponent_of_roughness(at.roughness);
    } else {
        set_classical(p, base.paint.xyz, s);
    }
    s.ambient = s.ambient * t.occlusion;
    s.lobe_scale = lobe_scale(s.exponent, reflection());
}

// KHR_materials_anisotropy: a missing map turns nothing.
vec4 anisotropy_at(Point p)
{
#if RL_HAS_ANISOTROPY_MAP
    return anisotropy_texel(p);
#else
    return vec4(1.0, 0.5, 1.0, 1.0);
#endif
}

void set_widths(Point p, inout MaterialSurface s)
{
    set_even_widths(s);
    if ((RL_MODEL == RL_WARD || RL_IS_USER != 0) && m_ward_alpha.x > 0.0) {
        set_ward_widths(s, m_ward_alpha);
    } else if (RL_IS_METALLIC != 0 && m_anisotropy > 0.0) {
        apply_anisotropy(s, m_anisotropy, anisotropy_at(p));
    }
}

void set_layers(Point p, inout MaterialSurface s)
{
    set_no_layers(s);
    if (RL_HAS_SHEEN != 0) {
        set_sheen(s, m_sheen_color, m_sheen_roughness, sheen_color_texel(p), sheen_roughness_texel(p));
    }
    if (RL_HAS_COAT != 0) {
        set_coat(s, m_clearcoat, m_clearcoat_roughness, clearcoat_texel(p), clearcoat_roughness_texel(p));
    }
    if (RL_HAS_TRANSMISSION != 0) {
        set_transmission(s, m_transmission, transmission_texel(p));
    }
}

#if RL_HAS_TRANSMISSION
// What is seen through the surface.
LightTerms terms_from_behind_at(Point p, MaterialSurface s)
{
    Body body;
    body.thickness = m_body_thickness * thickness_texel(p).y;
    body.eta = m_through_eta;
    body.attenuation = m_attenuation;
    body.blur = m_through_blur;
    body.bends = RL_BODY_BENDS;
    body.parts = RL_BODY_PARTS;
    BehindView view;
    view.to_u = rl_behind_view[0];
    view.to_v = rl_behind_view[1];
    view.to_w = rl_behind_view[2];
    view.last_level = rl_behind_view[3].x;
    return terms_from_behind(plain_maps(), view, body, s, p.position);
}
#endif

// A lighting of the user's has the numbers of all models: k_a, k_d, k_s and the exponent in s.base, as Phong takes them; beside
// them the widths of microfacets, and Oren-Nayar's terms.
void set_for_user(Point p, MaterialTexels t, BaseColor base, inout MaterialSurface s)
{
    set_slopes(base.color.xyz, s);
    s.scattering = vec3(0.0);
    s.albedo = 1.0;
    s.albedo_mean = 1.0;
    s.sheen_albedo = 0.0;
    set_classical_sum(p, t, base, s.base);
}

// All of a surface but its directions and what depends on them.
void set_material(Point p, MaterialTexels t, BaseColor base, inout MaterialSurface s)
{
#if RL_HAS_CLASSICAL_SUM
    set_classical_sum(p, t, base, s.base);
#else
    s.base.diffuse = base.color.xyz;
    s.base.exponent = 1.0;
    s.base.lobe_scale = 1.0;
    if (RL_IS_METALLIC != 0) {
        set_metallic_lobe(s, metallic_roughness_at(p, t), base.color.xyz, RL_MODEL);
    } else {
        set_classical(p, base.paint.xyz, s.base);
        set_classical_lobe(s, m_lobe_roughness, RL_FORM);
    }
    set_widths(p, s);
    show_base_color(s, base.color.xyz, RL_MODEL);
    if (RL_MODEL == RL_OREN_NAYAR || RL_MODEL == RL_OREN_NAYAR_FULL) {
        set_slopes(s.base.diffuse, s);
    }
    set_layers(p, s);
    if (RL_IS_USER != 0) {
        set_for_user(p, t, base, s);
    } else if (RL_MODEL != RL_PBR) {
        s.base.ambient = s.base.ambient * t.occlusion;
    }
#endif
}

void set_axes(Point p, inout MaterialSurface s)
{
    set_lobe_axes(s, p.tangent, p.w * p.side);
    if (RL_IS_METALLIC != 0 && m_anisotropy > 0.0) {
        turn_lobe_axes(s, m_anisotropy_axis, anisotropy_at(p));
    }
}

// even: without the bumps of the base, unit, on the seen side.
vec3 coat_normal_at(Point p, vec3 even)
{
#if RL_HAS_COAT && RL_HAS_CLEARCOAT_NORMAL_MAP
    return coat_normal(even, p.tangent, p.w * p.side, clearcoat_normal_texel(p), m_clearcoat_normal_scale);
#else
    return even;
#endif
}

// What depends on directions, once they are known; the emission, dimmed by what lies over it.
vec3 finish_surface(Point p, MaterialTexels t, vec3 even, vec3 emission, inout MaterialSurface s)
{
#if RL_MODEL != RL_PBR && RL_HAS_ENVIRONMENT
    set_around(s, t.occlusion, reflection());
    if (RL_IS_METALLIC != 0 && (RL_MODEL == RL_PHONG || RL_MODEL == RL_BLINN_PHONG)) {
        set_split_sum(s, plain_maps(), metallic_f90(metallic_roughness_at(p, t)), t.occlusion);
    }
#endif
#if RL_MODEL == RL_WARD || RL_IS_ANISOTROPIC || RL_IS_USER
    set_axes(p, s);
#endif
#if RL_MODEL == RL_PBR
    s.coat_n = coat_normal_at(p, even);
#if RL_HAS_IRIDESCENCE
    float film = film_thickness(m_iridescence_thickness_min_nm, m_iridescence_thickness_max_nm, iridescence_thickness_texel(p));
    set_iridescence(s, m_iridescence * iridescence_texel(p).x, film, m_iridescence_ior);
#endif
    set_pbr_albedos(s, plain_maps(), t.occlusion, RL_HAS_LIGHT_AROUND, traits(1));
    return emission_under_coat(s, emission);
#else
    return emission;
#endif
}
