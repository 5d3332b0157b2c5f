// SPDX-License-Identifier: Apache-2.0
// The environment's diffuse light. Source: Ramamoorthi & Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps".

// Spherical harmonics of irradiance / pi, scaled for the polynomials of irradiance_sum().
struct Irradiance {
    vec3 constant_part;
    vec3 by_y;
    vec3 by_z;
    vec3 by_x;
    vec3 by_xy;
    vec3 by_yz;
    vec3 by_zz;
    vec3 by_xz;
    vec3 by_xx_yy;
};

// The environment; the same for all lanes.
struct Environment {
    vec3 to_x;        // the axes of its picture, in the world
    vec3 to_y;
    vec3 to_z;
    real intensity;
    real last_level;  // of the prefiltered maps: roughness 1
    Irradiance irradiance;
};

// A direction of the world in the picture's own axes.
RL_FN vec3 to_environment(RL_IN(Environment) e, vec3 d)
{
    return vec3(dot(e.to_x, d), dot(e.to_y, d), dot(e.to_z, d));
}

// [irradiance / pi] on a surface that looks along the unit vector n, not negative.
RL_FN vec3 irradiance_sum(RL_IN(Irradiance) e, vec3 n)
{
    vec3 sum = e.constant_part + e.by_y * n.y + e.by_z * n.z + e.by_x * n.x + e.by_xy * (n.x * n.y) + e.by_yz * (n.y * n.z);
    sum = sum + e.by_zz * (3.0f * n.z * n.z - 1.0f) + e.by_xz * (n.x * n.z) + e.by_xx_yy * (n.x * n.x - n.y * n.y);
    return max(sum, vec3(0.0f));
}

RL_FN vec3 irradiance(RL_IN(Environment) e, vec3 direction)
{
    return irradiance_sum(e.irradiance, to_environment(e, direction)) * e.intensity;
}
