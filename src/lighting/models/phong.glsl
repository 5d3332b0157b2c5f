// SPDX-License-Identifier: Apache-2.0
// Source: Phong 1975, "Illumination for Computer Generated Pictures": (r.v)^exponent with r the mirrored light direction.
// Normalized: Lafortune & Willems 1994, "Using the Modified Phong Reflectance Model for Physically Based Rendering", eq. 5.

// x^n for x in 0..1 and n >= 1 by squaring (Knuth 1969, "Seminumerical Algorithms", 4.6.3, algorithm A); 0 where it is below
// 2^-126. Relative error under n 2^-24.
RL_FN real whole_power(real x, int n)
{
    real square = x;
    int rest = n;
    for (; (rest & 1) == 0; rest = rest >> 1) {
        square = square * square;
    }
    real result = square;
    for (rest = rest >> 1; rest > 0; rest = rest >> 1) {
        square = square * square;
        if ((rest & 1) != 0) {
            result = result * square;
        }
    }
    return select(result >= 1.17549435e-38f, result, 0.0f);
}

// r.v with r = 2 (n.l) n - l: symmetric in l and v.
RL_FN real phong_r_dot_v(vec3 n, vec3 l, vec3 v)
{
    return 2.0f * dot(n, l) * dot(n, v) - dot(l, v);
}

// [1], 0..1; exponent >= 1. Textbook form: times k_s and the light's color, no cosine, no energy factor.
RL_FN real phong_lobe(real r_dot_v, real exponent)
{
    return pow_positive(min(1.0f, r_dot_v), exponent);  // 0 for r.v <= 0 on every engine
}

// (e + 2) / (2 pi): with it the albedo is k_s at normal incidence and less elsewhere.
RL_FN real phong_normalization(real exponent)
{
    return (min(exponent, 1e18f) + 2.0f) * (0.5f * RL_INVERSE_PI);
}

// [1/sr] per unit of k_s. Times irradiance and n.l it gives radiance.
RL_FN real phong_brdf(real r_dot_v, real exponent)
{
    return phong_normalization(exponent) * phong_lobe(r_dot_v, exponent);
}

// Directions about the axis whose cosine c to it has the density (exponent + 1) / (2 pi) c^exponent: Lafortune & Willems 1994.
// c = x^(1 / (exponent + 1)) of the random number x; the sine comes without cancellation, so that narrow lobes keep their shape.
RL_FN vec3 sample_power_cosine(vec3 axis, real exponent, vec2 u)
{
    real power = log2(max(1.0f - u.x, 5.96e-8f)) / (max(exponent, 0.0f) + 1.0f);
    real sine = safe_sqrt(one_minus_exp(1.38629436f * power));  // 2 ln 2
    return direction_about(axis, exp2(power), sine, u.y);
}

// [1/sr] of c^exponent.
RL_FN real power_cosine_pdf(real power_of_cosine, real exponent)
{
    return (clamp(exponent, 0.0f, 1e18f) + 1.0f) * (0.5f * RL_INVERSE_PI) * power_of_cosine;
}

// About the mirror direction of v.
RL_FN vec3 sample_phong(vec3 n, vec3 v, real exponent, vec2 u)
{
    return sample_power_cosine(mirrored_about(n, v), exponent, u);
}

// [1/sr] `lobe`: phong_lobe() of the direction.
RL_FN real phong_pdf(real lobe, real exponent)
{
    return power_cosine_pdf(lobe, exponent);
}
