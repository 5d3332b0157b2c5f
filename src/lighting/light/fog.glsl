// SPDX-License-Identifier: Apache-2.0
// Fog between the eye and a surface. Source: OpenGL 2.1 specification, section 3.10, equations 3.24 to 3.26.
#define RL_NO_FOG 0
#define RL_LINEAR_FOG 1
#define RL_EXPONENTIAL_FOG 2
#define RL_EXPONENTIAL_SQUARED_FOG 3

// [1] (end - d) / (end - start) in 0..1. The specification leaves start = end open: here it is a step.
RL_FN real linear_fog(real d, real start, real end)
{
    real span = end - start;
    return clamp((end - d) / select(abs(span) > 1e-30f, span, 1e-30f), 0.0f, 1.0f);
}

// [1] e^(-density d)
RL_FN real exponential_fog(real d, real density)
{
    return clamp(exp(-(density * d)), 0.0f, 1.0f);
}

// [1] e^(-(density d)^2)
RL_FN real exponential_squared_fog(real d, real density)
{
    real depth = density * d;
    return clamp(exp(-(depth * depth)), 0.0f, 1.0f);
}

// [1] 0..1: how much of the surface is seen at the distance d >= 0 [m]; the rest is the fog's color. The kind is the
// same for all lanes.
RL_FN real fog_factor(int kind, real d, real start, real end, real density)
{
    if (kind == RL_LINEAR_FOG) {
        return linear_fog(d, start, end);
    }
    if (kind == RL_EXPONENTIAL_FOG) {
        return exponential_fog(d, density);
    }
    if (kind == RL_EXPONENTIAL_SQUARED_FOG) {
        return exponential_squared_fog(d, density);
    }
    return 1.0f;
}

// [m] >= 0 that the ray to a point (about the eye) goes through the fog: from the eye; in parallel views from the plane of the
// camera, view_direction towards the viewer.
RL_FN real fog_distance(vec3 position, vec3 view_direction, int is_parallel)
{
    if (is_parallel != 0) {
        return max(-dot(view_direction, position), 0.0f);
    }
    return length(position);
}

RL_FN vec3 behind_fog(vec3 radiance, vec3 fog_color, real factor)
{
    return radiance * factor + fog_color * (1.0f - factor);
}
