// SPDX-License-Identifier: Apache-2.0
// Source: glTF 2.0, appendix B: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 33;
// Heitz 2014, "Understanding the Masking-Shadowing Function", eq. 99 (height-correlated Smith), 85 and 86 (anisotropic, as
// KHR_materials_anisotropy); Schlick 1994, "An Inexpensive BRDF Model", eq. 15.

// (1 - c)^5 of Schlick's F = f0 + (f90 - f0) (1 - c)^5; c = v.h, 0..1.
RL_FN real schlick_weight(real c)
{
    real x = clamp(1.0f - c, 0.0f, 1.0f);
    real squared = x * x;
    return squared * squared * x;
}

// The same of the directions l and v: |l + v| = 2 v.h.
RL_FN real schlick_weight_between(vec3 l, vec3 v)
{
    vec3 sum = l + v;
    return schlick_weight(0.5f * sqrt(dot(sum, sum)));
}

// f0 of what is no metal (KHR_materials_specular). `color`: that of the index of refraction (KHR_materials_ior) times
// specularColorFactor and its texture, may exceed 1; `strength`: specularFactor times its texture, f90 too.
RL_FN vec3 dielectric_f0(vec3 color, real strength)
{
    return min(color, vec3(1.0f)) * strength;
}

RL_FN vec3 schlick(vec3 f0, vec3 f90, real weight)
{
    return f0 + (f90 - f0) * weight;
}

// D [1/sr] of the unit halfway direction h: 1 / (pi ax ay ((h.t / ax)^2 + (h.b / ay)^2 + (h.n)^2)^2).
RL_FN real ggx_distribution(vec3 n, vec3 t, vec3 b, vec3 h, real alpha_x, real alpha_y)
{
    real along_t = dot(h, t) / alpha_x;
    real along_b = dot(h, b) / alpha_y;
    real n_dot_h = dot(n, h);
    real sum = along_t * along_t + along_b * along_b + n_dot_h * n_dot_h;
    return RL_INVERSE_PI / max(alpha_x * alpha_y * sum * sum, 1e-18f);
}

// The same for equal alphas, with no tangent: sin^2 from the cross product does not cancel.
RL_FN real ggx_distribution_isotropic(vec3 n, vec3 h, real alpha)
{
    vec3 across = cross(n, h);
    real n_dot_h = dot(n, h);
    real sum = dot(across, across) / alpha + alpha * n_dot_h * n_dot_h;
    return RL_INVERSE_PI / max(sum * sum, 1e-18f);
}

// Length of the direction stretched by the alphas: of it stands in Smith's masking.
RL_FN real ggx_stretch(vec3 n, vec3 t, vec3 b, vec3 d, real alpha_x, real alpha_y)
{
    real along_t = alpha_x * dot(d, t);
    real along_b = alpha_y * dot(d, b);
    real along_n = dot(n, d);
    return sqrt(along_t * along_t + along_b * along_b + along_n * along_n);
}

RL_FN real ggx_stretch_isotropic(real n_dot_d, real alpha)
{
    real c = clamp(n_dot_d, 0.0f, 1.0f);
    return sqrt(alpha * alpha * (1.0f - c * c) + c * c);
}

// V = G / (4 n.l n.v) = 1 / (2 (n.l stretch(v) + n.v stretch(l))).
RL_FN real smith_visibility(real n_dot_l, real n_dot_v, real stretch_l, real stretch_v)
{
    return 0.5f / max(n_dot_l * stretch_v + n_dot_v * stretch_l, 1e-9f);
}

// ggx_distribution_isotropic() times 1 / (2 rest) without a unit halfway direction and with one division: with s = l + v,
// D = alpha^2 |s|^4 / (pi (|n x s|^2 + alpha^2 (n.s)^2)^2).
RL_FN real ggx_over_twice(vec3 n, vec3 sum, real alpha, real rest)
{
    vec3 across = cross(n, sum);
    real along = alpha * dot(n, sum);
    real spread = dot(across, across) + along * along;
    real peak = alpha * min(dot(sum, sum), 4.0f);
    return (0.5f * RL_INVERSE_PI) * peak * peak / (max(spread * spread, 1e-26f) * max(rest, 1e-9f));
}

// [1/sr] D V with F = 1; 0 where l or v is below the horizon. 1e-3 <= alpha <= 1. ggx_distribution_isotropic() times
// smith_visibility().
RL_FN real ggx_brdf(vec3 n, vec3 l, vec3 v, real alpha)
{
    real n_dot_l = dot(n, l);
    real n_dot_v = dot(n, v);
    real masked = n_dot_l * ggx_stretch_isotropic(n_dot_v, alpha) + n_dot_v * ggx_stretch_isotropic(n_dot_l, alpha);
    real value = ggx_over_twice(n, l + v, alpha, masked);
    return select(min(n_dot_l, n_dot_v) > 0.0f, value, 0.0f);
}

RL_FN real ggx_anisotropic_brdf(vec3 n, vec3 t, vec3 b, vec3 l, vec3 v, real alpha_x, real alpha_y)
{
    vec3 h = half_vector(l, v, n);
    real n_dot_l = dot(n, l);
    real n_dot_v = dot(n, v);
    real visibility = smith_visibility(n_dot_l, n_dot_v, ggx_stretch(n, t, b, l, alpha_x, alpha_y), ggx_stretch(n, t, b, v, alpha_x, alpha_y));
    return select(min(n_dot_l, n_dot_v) > 0.0f, ggx_distribution(n, t, b, h, alpha_x, alpha_y) * visibility, 0.0f);
}

// The mean loss between the facets, 1 - E_mean, that what two directions lose is divided by.
RL_FN real scattering_mean(real albedo_mean)
{
    return max(1.0f - albedo_mean, 1e-6f);
}

// What single scattering loses between the facets, Kulla & Conty 2017, "Revisiting Physically Based Shading at Imageworks":
// (1 - E(l)) (1 - E(v)) / (pi (1 - E_mean)) [1/sr], E the albedo of D V with F = 1, E_mean its mean weighted by the cosine.
RL_FN real scattering_brdf(real albedo_l, real albedo_v, real albedo_mean)
{
    return RL_INVERSE_PI * (1.0f - albedo_l) * (1.0f - albedo_v) / scattering_mean(albedo_mean);
}

// Its color: each further bounce is reflected by F_mean = f0 + (f90 - f0) / 21, F_mean^2 E_mean / (1 - F_mean (1 - E_mean)) in all.
RL_FN vec3 scattering_color(vec3 f0, vec3 f90, real albedo_mean)
{
    vec3 f = f0 + (f90 - f0) * (1.0f / 21.0f);
    vec3 rest = vec3(1.0f) - f * (1.0f - albedo_mean);
    return f * f * albedo_mean / max(rest, vec3(1e-6f));
}

// Mirrors v on a facet, of those that v sees evenly by the area that it sees of them (Dupuy & Benyoub 2023, "Sampling
// Visible GGX Normals with Spherical Caps"). In the space stretched by the alphas, h is the sum of v and a point of the
// unit sphere above the height of -v. A negative n.v counts as 0.
RL_FN vec3 sample_ggx(vec3 n, vec3 t, vec3 b, vec3 v, real alpha_x, real alpha_y, vec2 u)
{
    vec3 stretched = vec3(alpha_x * dot(v, t), alpha_y * dot(v, b), max(dot(v, n), 0.0f));
    vec3 s = safe_normalize(stretched);
    real top = 1.0f + s.z;
    real h_n = max(1.0f - u.x, 0.0f) * top;  // s.z and the point's height, from 0 to 1 + s.z
    real sine = safe_sqrt((h_n + 1.0f - s.z) * u.x * top);  // 1 + the point's height, 1 - it
    vec2 around = cos_sin_of_turns(u.y);
    real h_t = alpha_x * (sine * around.x + s.x);
    real h_b = alpha_y * (sine * around.y + s.y);
    return mirrored_about(safe_normalize_or(t * h_t + b * h_b + n * h_n, n), v);
}

RL_FN vec3 sample_ggx_isotropic(vec3 n, vec3 v, real alpha, vec2 u)
{
    Axes axes = axes_about(n);
    return sample_ggx(n, axes.tangent, axes.bitangent, v, alpha, alpha, u);
}

// [1/sr] of sample_ggx(): D G1(v) v.h / n.v / (4 v.h) = D / (2 (n.v + stretch(v))), Heitz 2018, "Sampling the GGX Distribution of
// Visible Normals", eq. 3 and 17. The weight, ggx_anisotropic_brdf() n.l over it, is G / G1(v) <= 1. 0 for n.v <= 0.
RL_FN real ggx_anisotropic_pdf(vec3 n, vec3 t, vec3 b, vec3 l, vec3 v, real alpha_x, real alpha_y)
{
    vec3 h = half_vector(l, v, n);
    real n_dot_v = dot(n, v);
    real seen = 0.5f / max(n_dot_v + ggx_stretch(n, t, b, v, alpha_x, alpha_y), 1e-9f);
    return select(min(n_dot_v, dot(n, l + v)) > 0.0f, ggx_distribution(n, t, b, h, alpha_x, alpha_y) * seen, 0.0f);
}

// The same for equal alphas, with the roundings of ggx_brdf().
RL_FN real ggx_pdf(vec3 n, vec3 l, vec3 v, real alpha)
{
    vec3 sum = l + v;
    real n_dot_v = dot(n, v);
    real value = ggx_over_twice(n, sum, alpha, n_dot_v + ggx_stretch_isotropic(n_dot_v, alpha));
    return select(min(n_dot_v, dot(n, sum)) > 0.0f, value, 0.0f);
}
