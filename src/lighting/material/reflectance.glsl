// SPDX-License-Identifier: Apache-2.0
// Material parameters and texels -> what a surface reflects. A missing map is its neutral texel, white.
// Sources: glTF 2.0, appendix B; KHR_materials_specular; Karis 2013, "Specular BRDF Reference" (alpha^2 = 2 / (n + 2)).

RL_FN real greatest(vec3 v)
{
    return max(v.x, max(v.y, v.z));
}

// Widths count as at least 1e-3.
RL_FN real alpha_of_roughness(real roughness)
{
    return max(roughness * roughness, 1e-3f);
}

// Exponent of the Blinn-Phong lobe that is as wide as a GGX lobe of this roughness, 1..10000.
RL_FN real exponent_of_roughness(real roughness)
{
    real alpha = alpha_of_roughness(roughness);
    return clamp(2.0f / (alpha * alpha) - 2.0f, 1.0f, 10000.0f);
}

RL_FN real alpha_squared_of_exponent(real exponent)
{
    return 2.0f / (exponent + 2.0f);
}

// What a metallic-roughness material is at a pixel, for every lighting model.
struct MetallicRoughness {
    real metallic;
    real roughness;
    vec3 dielectric_f0;   // of what is no metal
    real dielectric_f90;
};

RL_FN void apply_metallic_roughness(RL_INOUT(MetallicRoughness) at, vec4 texel)
{
    at.roughness = at.roughness * texel.y;
    at.metallic = at.metallic * texel.z;
}

// color: that of the index of refraction times the specular color. Texels of its map, and of the strength's.
RL_FN void apply_specular(RL_INOUT(MetallicRoughness) at, vec3 color, real strength, vec4 color_texel, vec4 strength_texel)
{
    at.dielectric_f90 = strength * strength_texel.w;
    at.dielectric_f0 = dielectric_f0(color * vec3(color_texel.x, color_texel.y, color_texel.z), at.dielectric_f90);
}

// Metals reflect all at grazing angles.
RL_FN vec3 metallic_f90(RL_IN(MetallicRoughness) at)
{
    return vec3(mix(at.dielectric_f90, 1.0f, at.metallic));
}

// k_d and k_s, or f0; ambient light shows metals in their color.
RL_FN void set_metallic_reflectance(RL_INOUT(Surface) s, RL_IN(MetallicRoughness) at, vec3 base)
{
    s.ambient = base;
    s.diffuse = base * (1.0f - at.metallic);
    s.specular = mix(at.dielectric_f0, base, at.metallic);
}

// paint: vertex color times texture, without the material's factor, which is k_d.
RL_FN void set_classical_reflectance(RL_INOUT(Surface) s, vec3 k_a, vec3 k_s, real exponent, vec3 paint, vec4 specular_texel)
{
    s.ambient = k_a * paint;
    s.specular = k_s * vec3(specular_texel.x, specular_texel.y, specular_texel.z);
    s.exponent = exponent;
}

// 0..1 of an occlusion map's texel.
RL_FN real occlusion_factor(real strength, vec4 texel)
{
    return 1.0f + strength * (texel.x - 1.0f);
}

// An occlusion map darkens ambient light alone.
RL_FN void apply_occlusion(RL_INOUT(Surface) s, real strength, vec4 texel)
{
    s.ambient = s.ambient * occlusion_factor(strength, texel);
}

RL_FN vec3 emission_of(vec3 factor, vec4 texel)
{
    return factor * vec3(texel.x, texel.y, texel.z);
}
