// SPDX-License-Identifier: Apache-2.0
// The environment's glossy light, of maps prefiltered for surfaces of growing roughness (Karis 2013, "Real Shading in Unreal Engine
// 4"), octahedral ones: Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors".

// u, v of a direction in an octahedral map, 0..1: octahedral() of image/maps/environment.h.
RL_FN vec2 octahedral(vec3 d)
{
    real scale = reciprocal(max(abs(d.x) + abs(d.y) + abs(d.z), 1e-20f));
    real x = d.x * scale;
    real z = d.z * scale;
    mask is_below = d.y < 0.0f;
    real u = select(is_below, copy_sign(1.0f - abs(z), x), x);
    real v = select(is_below, copy_sign(1.0f - abs(x), z), z);
    return vec2(0.5f + 0.5f * u, 0.5f + 0.5f * v);
}

// What a lobe of this roughness about the direction mirrors.
RL_MAP_FN vec3 mirrored(RL_IN(Maps) maps, RL_IN(Environment) e, vec3 direction, real roughness)
{
    real level = clamp(roughness, 0.0f, 1.0f) * e.last_level;
    return sample_environment(maps, octahedral(to_environment(e, direction)), level) * e.intensity;
}
