// SPDX-License-Identifier: Apache-2.0
// Source: Blinn 1978, "Simulation of Wrinkled Surfaces", N' = N + (F_u (N x P_v) - F_v (N x P_u)) / |N|: in an orthonormal
// frame the normal (-dF/dt, -dF/db, 1) of a height F along the normal.

// log2(sqrt(3) / 2): how much finer than a pixel's level its slope is read. Box of the level (variance w^2 / 12 of a texel's
// width w), linear filter (w^2 / 6) and difference (w^2 / 12) together are then as wide, along the slope, as box and linear
// filter of a normal map at the pixel's level.
#define RL_SLOPE_DETAIL -0.20751875f

// Change of height per unit of u and of v, by differences over width_u and width_v. These are the widths of a texel of
// the level that is read, so the slope is filtered like the height and has no steps where the map is magnified.
RL_MAP_FN vec2 height_slope(RL_IN(Maps) maps, vec2 uv, real width_u, real width_v, real lod)
{
    vec2 along_u = vec2(0.5f * width_u, 0.0f);
    vec2 along_v = vec2(0.0f, 0.5f * width_v);
    real du = sample_height(maps, uv + along_u, lod) - sample_height(maps, uv - along_u, lod);
    real dv = sample_height(maps, uv + along_v, lod) - sample_height(maps, uv - along_v, lod);
    return vec2(du / width_u, dv / width_v);
}

// In (tangent, bitangent, normal), not unit: slopes are height per length along tangent and bitangent.
RL_FN vec3 bumped_normal(real slope_t, real slope_b)
{
    return vec3(-slope_t, -slope_b, 1.0f);
}
