// SPDX-License-Identifier: Apache-2.0
// Source: Oren & Nayar 1994, "Generalization of Lambert's Reflectance Model", eq. 27 to 29, with interreflection. The radiance over
// rho / pi E cos(theta_i), rho a facet's albedo, sigma [rad] the standard deviation of the facets' angles, phi = phi_r - phi_i, alpha
// the greater, beta the smaller of both angles to the normal, s = sigma^2 / (sigma^2 + 0.09):
//   C1 + C2 cos phi tan beta + C3 (1 - |cos phi|) tan((alpha + beta) / 2)
//     + 0.17 rho sigma^2 / (sigma^2 + 0.13) (1 - cos phi (2 beta / pi)^2)
//   C1 = 1 - 0.5 sigma^2 / (sigma^2 + 0.33)
//   C2 = 0.45 s sin alpha; where cos phi < 0: 0.45 s (sin alpha - (2 beta / pi)^3)
//   C3 = 0.125 s (4 alpha beta / pi^2)^2
// oren_nayar_a() is C1, oren_nayar_b() 0.45 s. Its sampler is sample_cosine() of lambert.glsl.

// What interreflection is multiplied by, of rho.
RL_FN real oren_nayar_bounce(real sigma)
{
    real squared = min(sigma * sigma, 100.0f);
    return 0.17f * squared / (squared + 0.13f);
}

// 0..1: an angle of sine and cosine, both >= 0, over pi / 2. Abramowitz & Stegun 1964, eq. 4.4.46: acos(x) = sqrt(1 - x) p(x), within 2e-8;
// sqrt(1 - x) is sin / sqrt(1 + x), which is exact near 0 too.
RL_FN real quarter_share(real sine, real cosine)
{
    real x = min(cosine, 1.0f);
    real p = 0.0308918810f + x * (-0.0170881256f + x * (0.0066700901f - x * 0.0012624911f));
    p = 1.5707963050f + x * (-0.2145988016f + x * (0.0889789874f + x * (-0.0501743046f + x * p)));
    return sine / sqrt(1.0f + x) * p * 0.636619772f;
}

// The angles of both directions. What is below the horizon counts as on it; cosines that divide count as at least 1e-4.
struct FacetAngles {
    real cos_phi;
    real sin_alpha;
    real tan_beta;
    real tan_middle;  // of (alpha + beta) / 2
    real alpha;       // 0..1: over pi / 2
    real beta;
    real behind;      // sin alpha - (2 beta / pi)^3, which is small where tan beta is large
};

RL_FN FacetAngles facet_angles(vec3 n, vec3 l, vec3 v)
{
    vec3 across_l = cross(n, l);
    vec3 across_v = cross(n, v);
    real length_l = sqrt(dot(across_l, across_l));
    real length_v = sqrt(dot(across_v, across_v));
    real cos_l = clamp(dot(n, l), 0.0f, 1.0f);
    real cos_v = clamp(dot(n, v), 0.0f, 1.0f);
    real sin_l = select(cos_l > 0.0f, min(length_l, 1.0f), 1.0f);
    real sin_v = select(cos_v > 0.0f, min(length_v, 1.0f), 1.0f);
    real rise_l = quarter_share(cos_l, sin_l);  // over the horizon: what is left of the angle to the normal
    real rise_v = quarter_share(cos_v, sin_v);
    real rise = max(rise_l, rise_v);
    real least = min(cos_l, cos_v);
    FacetAngles a;
    a.cos_phi = clamp(dot(across_l, across_v) / max(length_l * length_v, 1e-20f), -1.0f, 1.0f);
    a.sin_alpha = max(sin_l, sin_v);
    a.tan_beta = min(sin_l, sin_v) / max(max(cos_l, cos_v), 1e-4f);
    a.tan_middle = (sin_l + sin_v) / max(cos_l + cos_v, 1e-4f);
    a.alpha = 1.0f - min(rise_l, rise_v);
    a.beta = 1.0f - rise;
    // 1 - (1 - rise)^3 less 1 - sin alpha
    a.behind = rise * (3.0f - rise * (3.0f - rise)) - least * least / (1.0f + a.sin_alpha);
    return a;
}

// What Lambert's term is multiplied by: without interreflection (eq. 27), c1 and s45 of oren_nayar_a() and oren_nayar_b().
RL_FN real oren_nayar_direct(RL_IN(FacetAngles) a, real c1, real s45)
{
    real c2 = s45 * select(a.cos_phi < 0.0f, a.behind, a.sin_alpha);
    real both = a.alpha * a.beta;
    real c3 = s45 * 0.277777778f * both * both;  // 0.125 / 0.45
    return c1 + c2 * (a.cos_phi * a.tan_beta) + c3 * ((1.0f - abs(a.cos_phi)) * a.tan_middle);
}

// The same of interreflection (eq. 28), without rho.
RL_FN real oren_nayar_bounced(RL_IN(FacetAngles) a, real bounce)
{
    return bounce * (1.0f - a.cos_phi * (a.beta * a.beta));
}

// Both. rho: a facet's albedo.
RL_FN vec3 oren_nayar_full_factor(vec3 n, vec3 l, vec3 v, real c1, real s45, real bounce, vec3 rho)
{
    FacetAngles a = facet_angles(n, l, v);
    return vec3(oren_nayar_direct(a, c1, s45)) + rho * oren_nayar_bounced(a, bounce);
}

// [1/sr] per unit of rho. Times irradiance and n.l it gives radiance.
RL_FN vec3 oren_nayar_full_brdf(vec3 n, vec3 l, vec3 v, real sigma, vec3 rho)
{
    return oren_nayar_full_factor(n, l, v, oren_nayar_a(sigma), oren_nayar_b(sigma), oren_nayar_bounce(sigma), rho) * RL_INVERSE_PI;
}
