// SPDX-License-Identifier: Apache-2.0
// What the samplers of the models share. Beside its model each has a function that makes a direction of two random numbers u, even in
// 0..1 without 1, and its probability density [1/sr] for any direction. Sampled directions are unit; some point below the horizon,
// where the BRDF is 0: their probability is part of the density's integral, which is 1 over the sphere.

// Cosine and sine of u turns; absolute error under 1e-7 for u in 0..1. Taylor's series in the nearest quarter.
RL_FN vec2 cos_sin_of_turns(real u)
{
    real quarters = floor(4.0f * u + 0.5f);
    real x = (u - 0.25f * quarters) * 6.28318531f;  // -pi/4..pi/4
    real xx = x * x;
    real s = x * (1.0f + xx * (-0.166666667f + xx * (8.33333333e-3f + xx * (-1.98412698e-4f + xx * 2.75573192e-6f))));
    real c = 1.0f + xx * (-0.5f + xx * (4.16666667e-2f + xx * (-1.38888889e-3f + xx * (2.48015873e-5f - xx * 2.75573192e-7f))));
    real quarter = quarters - 4.0f * floor(0.25f * quarters);  // 0, 1, 2, 3
    mask is_odd = quarter == 1.0f || quarter == 3.0f;
    real cosine = select(is_odd, s, c);
    real sine = select(is_odd, c, s);
    return vec2(select(quarter == 1.0f || quarter == 2.0f, -cosine, cosine), select(quarter >= 2.0f, -sine, sine));
}

// 1 - e^x for x <= 0; relative error under 2e-6. The series where the difference would cancel.
RL_FN real one_minus_exp(real x)
{
    real series = -x * (1.0f + x * (0.5f + x * (0.166666667f + x * 4.16666667e-2f)));
    return select(x > -0.03f, series, 1.0f - exp(x));
}

// Two directions across a unit vector: with it an orthonormal system.
struct Axes {
    vec3 tangent;
    vec3 bitangent;
};

// Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
RL_FN Axes axes_about(vec3 n)
{
    real side = copy_sign(1.0f, n.z);
    real a = -1.0f / (side + n.z);
    real product = n.x * n.y * a;
    Axes axes;
    axes.tangent = vec3(1.0f + side * n.x * n.x * a, side * product, -side * n.x);
    axes.bitangent = vec3(product, side + n.y * n.y * a, -n.y);
    return axes;
}

// The direction at an angle to n, `turns` about it.
RL_FN vec3 direction_about(vec3 n, real cosine, real sine, real turns)
{
    Axes axes = axes_about(n);
    vec2 around = cos_sin_of_turns(turns);
    return axes.tangent * (sine * around.x) + axes.bitangent * (sine * around.y) + n * cosine;
}

RL_FN vec3 mirrored_about(vec3 n, vec3 v)
{
    real n_dot_v = dot(n, v);
    return n * (n_dot_v + n_dot_v) - v;
}

// v.h of h halfway between l and v, at least 1e-6. A density of halfway directions over 4 v.h is that of the mirrored directions:
// Walter 2005, "Notes on the Ward BRDF".
RL_FN real halfway_cosine(vec3 l, vec3 v)
{
    vec3 sum = l + v;
    return max(0.5f * sqrt(dot(sum, sum)), 1e-6f);
}
