// SPDX-License-Identifier: Apache-2.0
// Directional albedos, by tables (albedo_tables.h says what columns and rows mean): sample_albedo(maps, table, x, y) reads one
// bilinearly, x, y in 0..1 across all columns and rows.
#define RL_ALBEDO_LOBE_LOSS 0
#define RL_ALBEDO_GRAZING 1
#define RL_ALBEDO_SHEEN 2
#define RL_ALBEDO_MEAN_LOSS 3  // y is not looked at

// Of the GGX lobe with F = 1. roughness: alpha = roughness^2.
RL_MAP_FN real lobe_albedo(RL_IN(Maps) maps, real n_dot_v, real roughness)
{
    real alpha = alpha_of_roughness(roughness);
    real width = alpha / (clamp(n_dot_v, 0.0f, 1.0f) + alpha);
    real x = safe_sqrt((1.0f - width) * (1.0f + alpha));
    return 1.0f - width * width * sample_albedo(maps, RL_ALBEDO_LOBE_LOSS, x, roughness);
}

// The share of lobe_albedo() that Schlick's weight has.
RL_MAP_FN real grazing_share(RL_IN(Maps) maps, real n_dot_v, real roughness)
{
    return sample_albedo(maps, RL_ALBEDO_GRAZING, safe_sqrt(n_dot_v), roughness);
}

// A lobe of unequal alphas sends out as much as one of equal alphas whose slopes have the same mean square, seen where its masking
// (Heitz 2014, eq. 86) is the same. Against quadrature 0.008 off on average, 0.041 at most (roughness 0.1 to 0.9, anisotropy 0.2
// to 1, 0 to 85 degrees).
RL_FN real equal_roughness(real alpha_x, real alpha_y)
{
    return sqrt(sqrt(0.5f * (alpha_x * alpha_x + alpha_y * alpha_y)));
}

// Cosine of the direction there, from those to the normal and to the lobe's axes.
RL_FN real equal_cosine(real n, real t, real b, real alpha_x, real alpha_y)
{
    real along_t = alpha_x * t;
    real along_b = alpha_y * b;
    real across = (along_t * along_t + along_b * along_b) * 2.0f;
    real squares = alpha_x * alpha_x + alpha_y * alpha_y;
    return n * sqrt(squares / max(n * n * squares + across, 1e-30f));
}

// E_mean.
RL_MAP_FN real lobe_mean(RL_IN(Maps) maps, real roughness)
{
    real alpha = alpha_of_roughness(roughness);
    return 1.0f - alpha * alpha * sample_albedo(maps, RL_ALBEDO_MEAN_LOSS, roughness, 0.0f);
}

RL_MAP_FN real sheen_albedo(RL_IN(Maps) maps, real n_dot_v, real alpha)
{
    return sample_albedo(maps, RL_ALBEDO_SHEEN, sqrt(clamp(n_dot_v, 0.0f, 1.0f)), sqrt(alpha));
}
