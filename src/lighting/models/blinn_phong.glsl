// SPDX-License-Identifier: Apache-2.0
// Source: Blinn 1977, "Models of Light Reflection for Computer Synthesized Pictures": (n.h)^exponent, h halfway between l, v.
// Normalized: Giesen 2009, "Phong and Blinn-Phong Normalization Factors": the exact integral at normal incidence.

// n.h, -1..1 except for a rounding; goes to 0 where l comes to -v within 1e-6 (no halfway direction). NaN where l + v
// is not finite, which gives no lobe.
RL_FN real blinn_phong_n_dot_h(vec3 n, vec3 l, vec3 v)
{
    vec3 twice_h = l + v;
    return dot(n, twice_h) * reciprocal(sqrt(max(dot(twice_h, twice_h), 1e-12f)));
}

// [1], 0..1; exponent >= 1. Textbook form: times k_s and the light's color, no cosine, no energy factor.
RL_FN real blinn_phong_lobe(real n_dot_h, real exponent)
{
    return pow_positive(min(1.0f, n_dot_h), exponent);  // 0 for n.h <= 0 on every engine
}

// (e + 2)(e + 4) / (8 pi (2^(-e/2) + e)): with it the albedo is k_s at normal incidence and at most k_s elsewhere.
RL_FN real blinn_phong_normalization(real exponent)
{
    real e = clamp(exponent, 0.0f, 1e18f);  // so that its square is finite
    return (e + 2.0f) * (e + 4.0f) * (0.125f * RL_INVERSE_PI) / (exp2(-0.5f * e) + e);
}

// [1/sr] per unit of k_s. Times irradiance and n.l it gives radiance.
RL_FN real blinn_phong_brdf(real n_dot_h, real exponent)
{
    return blinn_phong_normalization(exponent) * blinn_phong_lobe(n_dot_h, exponent);
}

// v mirrored on a halfway direction about n. The weight, BRDF n.l over density, is at most 4.4, and 1 in the middle of narrow lobes.
RL_FN vec3 sample_blinn_phong(vec3 n, vec3 v, real exponent, vec2 u)
{
    return mirrored_about(sample_power_cosine(n, exponent, u), v);
}

// [1/sr] `lobe`: blinn_phong_lobe() of |n.h|: facets seen from behind mirror v, too, to directions whose n.h is below 0.
RL_FN real blinn_phong_pdf(real lobe, real exponent, vec3 l, vec3 v)
{
    return power_cosine_pdf(lobe, exponent) * 0.25f / halfway_cosine(l, v);
}
