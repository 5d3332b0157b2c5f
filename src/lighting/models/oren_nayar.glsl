// SPDX-License-Identifier: Apache-2.0
// Source: Oren & Nayar 1994, "Generalization of Lambert's Reflectance Model", eq. 30, the full qualitative model:
// rho / pi (A + B max(0, cos(phi_r - phi_i)) sin alpha tan beta), alpha the greater, beta the smaller of both angles.
// sigma [rad]: standard deviation of the facets' angles; 0 is Lambert. Its albedo reaches 1.015 of rho at grazing angles.
// Its sampler is sample_cosine() of lambert.glsl: what is left in the weight, oren_nayar_factor(), is bounded.

RL_FN real oren_nayar_a(real sigma)
{
    real squared = min(sigma * sigma, 100.0f);
    return 1.0f - 0.5f * squared / (squared + 0.33f);
}

RL_FN real oren_nayar_b(real sigma)
{
    real squared = min(sigma * sigma, 100.0f);
    return 0.45f * squared / (squared + 0.09f);
}

// A + B ...: what Lambert's term is multiplied by. sin alpha tan beta cos(phi_r - phi_i) is n x l . n x v over the greater
// cosine, which counts as at least 1e-4. Viewers below the horizon count as on it.
RL_FN real oren_nayar_factor(vec3 n, vec3 l, vec3 v, real a, real b)
{
    real greater = max(max(dot(n, l), dot(n, v)), 1e-4f);
    return a + b * (clamp(dot(cross(n, l), cross(n, v)), 0.0f, 1.0f) / greater);
}

// [1/sr] per unit of rho. Times irradiance and n.l it gives radiance.
RL_FN real oren_nayar_brdf(vec3 n, vec3 l, vec3 v, real sigma)
{
    return RL_INVERSE_PI * oren_nayar_factor(n, l, v, oren_nayar_a(sigma), oren_nayar_b(sigma));
}
