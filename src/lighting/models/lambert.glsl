// SPDX-License-Identifier: Apache-2.0
// Source: Lambert 1760, "Photometria": radiance of a diffuse surface does not depend on the direction it is seen from.
// Directions in all files here: unit, pointing away from the surface (n normal, l to the light, v to the viewer).
#define RL_INVERSE_PI 0.318309886f

// [1/sr] per unit of albedo. Times irradiance and n.l it gives radiance.
RL_FN real lambert_brdf() { return RL_INVERSE_PI; }

// The cosine of the sum over lights: n.l, 0 below the horizon and for NaN, at most 1 for vectors a rounding too long.
RL_FN real lambert_cosine(real n_dot_l) { return clamp(n_dot_l, 0.0f, 1.0f); }

// As many directions as the cosine lets count. Malley's method (Pharr, Jakob & Humphreys 2016, "Physically Based Rendering", section
// 13.6.3): evenly over the unit disk, lifted to the hemisphere.
RL_FN vec3 sample_cosine(vec3 n, vec2 u)
{
    return direction_about(n, sqrt(max(1.0f - u.x, 0.0f)), sqrt(max(u.x, 0.0f)), u.y);
}

// [1/sr] max(0, n.l) / pi
RL_FN real cosine_pdf(vec3 n, vec3 l)
{
    return RL_INVERSE_PI * lambert_cosine(dot(n, l));
}

// Halfway between the directions to light and viewer; `n` where they are opposite.
RL_FN vec3 half_vector(vec3 l, vec3 v, vec3 n)
{
    return safe_normalize_or(l + v, n);
}
