// SPDX-License-Identifier: Apache-2.0
// Widths and reflectances of the lobes of Ward and GGX, of the layers above them, and Oren-Nayar's slopes.

// f0 of a microfacet lobe as wide as the classical one. A textbook k_s is how bright the highlight's center is, not an albedo:
// k_s = f0 / (4 alpha^2) there, so f0 = 4 alpha^2 k_s, at most k_s.
RL_FN vec3 classical_f0(vec3 k_s, real lobe_roughness, int form)
{
    if (form == RL_NORMALIZED) {
        return min(k_s, vec3(1.0f));
    }
    real alpha = lobe_roughness * lobe_roughness;
    return min(k_s * min(4.0f * alpha * alpha, 1.0f), vec3(1.0f));
}

// What the diffuse light of a classical surface loses to its highlight: nothing where there is none at all.
RL_FN void set_classical_dielectric(RL_INOUT(MaterialSurface) s, vec3 f0)
{
    s.dielectric_f0 = greatest(f0);
    s.dielectric_f90 = min(1.0f, s.dielectric_f0 * 50.0f);
}

// Classical parameters, which s.base has, as those of a microfacet lobe as wide.
RL_FN void set_classical_lobe(RL_INOUT(MaterialSurface) s, real lobe_roughness, int form)
{
    s.roughness = lobe_roughness;
    s.base.specular = classical_f0(s.base.specular, lobe_roughness, form);
    set_classical_dielectric(s, s.base.specular);
    s.f90 = vec3(s.dielectric_f90);
}

// glTF 2.0, appendix B, with KHR_materials_ior and KHR_materials_specular.
RL_FN void set_metallic_lobe(RL_INOUT(MaterialSurface) s, RL_IN(MetallicRoughness) at, vec3 base, int model)
{
    set_metallic_reflectance(s.base, at, base);
    s.roughness = at.roughness;
    s.dielectric_f0 = greatest(at.dielectric_f0);
    s.dielectric_f90 = at.dielectric_f90;
    s.f90 = metallic_f90(at);
    if (model == RL_PBR) {
        s.base.ambient = s.base.diffuse;  // the lobe's share is that of the albedo tables
    }
}

// Matte models have no highlight that would show a metal's color: they show the base color of all materials.
RL_FN void show_base_color(RL_INOUT(MaterialSurface) s, vec3 base, int model)
{
    if (RL_IS_MATTE(model)) {
        s.base.diffuse = base;
    }
}

// A lobe as wide along the tangent as along the bitangent, of s.roughness.
RL_FN void set_even_widths(RL_INOUT(MaterialSurface) s)
{
    s.alpha_x = alpha_of_roughness(s.roughness);
    s.alpha_y = s.alpha_x;
    s.table_roughness = s.roughness;
}

// Ward's own widths, along tangent and bitangent.
RL_FN void set_ward_widths(RL_INOUT(MaterialSurface) s, vec2 alpha)
{
    s.alpha_x = max(alpha.x, 1e-3f);
    s.alpha_y = max(alpha.y, 1e-3f);
    s.roughness = sqrt(sqrt(s.alpha_x * s.alpha_y));
}

// KHR_materials_anisotropy: alpha_t = mix(alpha, 1, strength^2), alpha_b = alpha. The neutral texel is (1, 0.5, 1, 1).
RL_FN void apply_anisotropy(RL_INOUT(MaterialSurface) s, real strength, vec4 texel)
{
    real alpha = s.alpha_x;
    real part = strength * texel.z;
    s.alpha_x = mix(alpha, 1.0f, part * part);
    mask is_uneven = s.alpha_x > alpha;
    s.table_roughness = select(is_uneven, equal_roughness(s.alpha_x, s.alpha_y), s.roughness);
    s.roughness = select(is_uneven, sqrt(sqrt(s.alpha_x * s.alpha_y)), s.roughness);
}

RL_FN void set_no_layers(RL_INOUT(MaterialSurface) s)
{
    s.sheen = vec3(0.0f);
    s.sheen_alpha = 1.0f;
    s.coat_alpha = 1.0f;
    s.coat_reflectance = 0.0f;
}

RL_FN void set_sheen(RL_INOUT(MaterialSurface) s, vec3 color, real roughness, vec4 color_texel, vec4 roughness_texel)
{
    real rough = roughness * roughness_texel.w;
    s.sheen = color * vec3(color_texel.x, color_texel.y, color_texel.z);
    s.sheen_alpha = max(rough * rough, 5e-3f);
}

// coat_reflectance holds the coat's strength until set_pbr_albedos().
RL_FN void set_coat(RL_INOUT(MaterialSurface) s, real coat, real roughness, vec4 coat_texel, vec4 roughness_texel)
{
    s.coat_reflectance = coat * coat_texel.x;
    s.coat_alpha = alpha_of_roughness(roughness * roughness_texel.y);
}

// Deviation of the facets' angles [rad] for Oren-Nayar. Slopes of a surface of Beckmann's facets with this alpha have the deviation
// alpha / sqrt(2), which is taken for that of their angles: the tangent for its angle, 0.71 for 0.62 at most.
RL_FN real sigma_of_roughness(real roughness)
{
    return roughness * roughness * 0.707106781f;
}

// facet_color: of the full model's interreflection.
RL_FN void set_oren_nayar(RL_INOUT(MaterialSurface) s, real sigma, vec3 facet_color)
{
    s.oren_nayar_a = oren_nayar_a(sigma);
    s.oren_nayar_b = oren_nayar_b(sigma);
    s.oren_nayar_bounce = oren_nayar_bounce(sigma);
    s.facet_color = facet_color;
}
