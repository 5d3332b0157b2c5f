// SPDX-License-Identifier: Apache-2.0
// Source: KHR_materials_sheen: distribution and masking of Estevez & Kulla 2017, "Production Friendly Microfacet Sheen BRDF".

// D [1/sr]: (2 + 1 / alpha) sin^(1 / alpha) / (2 pi) of the angle between n and h.
RL_FN real sheen_distribution(vec3 n, vec3 h, real alpha)
{
    real inverse = 1.0f / alpha;
    vec3 across = cross(n, h);
    real squared = clamp(dot(across, across), 0.0f, 1.0f);
    return (2.0f + inverse) * pow_positive(squared, 0.5f * inverse) * (0.5f * RL_INVERSE_PI);
}

// Their fit of ln Lambda (eq. 3, table 1), of the cosine x.
RL_FN real sheen_fit(real x, real alpha)
{
    real rest = 1.0f - alpha;
    real w = rest * rest;
    real a = mix(21.5473f, 25.3245f, w);
    real b = mix(3.82987f, 3.32435f, w);
    real c = mix(0.19823f, 0.16801f, w);
    real d = mix(-1.97760f, -1.27393f, w);
    real e = mix(-4.32054f, -4.85967f, w);
    return a / (1.0f + b * pow_positive(x, c)) + d * x + e;
}

RL_FN real sheen_lambda(real cosine, real alpha)
{
    mask is_low = cosine < 0.5f;
    real fit = sheen_fit(select(is_low, cosine, 1.0f - cosine), alpha);
    return exp(select(is_low, fit, 2.0f * sheen_fit(0.5f, alpha) - fit));
}

// [1/sr] per unit of the sheen color; 0 where l or v is below the horizon. 0 < alpha <= 1.
RL_FN real sheen_brdf(vec3 n, vec3 l, vec3 v, real alpha)
{
    vec3 h = half_vector(l, v, n);
    real n_dot_l = clamp(dot(n, l), 1e-4f, 1.0f);
    real n_dot_v = clamp(dot(n, v), 1e-4f, 1.0f);
    real masked = 1.0f + sheen_lambda(n_dot_l, alpha) + sheen_lambda(n_dot_v, alpha);
    real visibility = 0.25f / (n_dot_l * n_dot_v * masked);
    return select(min(dot(n, l), dot(n, v)) > 0.0f, sheen_distribution(n, h, alpha) * visibility, 0.0f);
}

// 0..1: what is left for the material under the sheen; albedos of sheen_brdf towards l and v.
RL_FN real sheen_rest(vec3 color, real albedo_l, real albedo_v)
{
    real greatest = max(color.x, max(color.y, color.z));
    return clamp(1.0f - greatest * max(albedo_l, albedo_v), 0.0f, 1.0f);
}

// Evenly over the hemisphere. The weight, BRDF n.l over density, is at most 5 times its mean from alpha 0.05 on (10
// times at 30 degrees there). It would be 6 to 100 times with the cosine's density, which vanishes at the horizon where
// sheen is bright. Halfway directions by the distribution mirror v below the horizon for the most part (deviation of
// the weights 1.5 to 60 times their mean, evenly 0.2 to 2.2).
RL_FN vec3 sample_sheen(vec3 n, vec2 u)
{
    real cosine = max(1.0f - u.x, 0.0f);
    return direction_about(n, cosine, safe_sqrt(u.x * (1.0f + cosine)), u.y);
}

// [1/sr] 1 / (2 pi) above the horizon.
RL_FN real sheen_pdf(vec3 n, vec3 l)
{
    return select(dot(n, l) > 0.0f, real(0.5f * RL_INVERSE_PI), 0.0f);
}
