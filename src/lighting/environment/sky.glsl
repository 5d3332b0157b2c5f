// SPDX-License-Identifier: Apache-2.0
// The environment's picture behind everything, equirectangular.

// Angle of (x, y) from +X, -pi..pi; y = 0 and x = 0 give 0. Error under 1e-7: Abramowitz & Stegun 1964, 4.4.49, for the ratio of the
// smaller to the larger.
RL_FN real angle_of(real y, real x)
{
    real ax = abs(x);
    real ay = abs(y);
    real t = min(ax, ay) / max(max(ax, ay), 1e-20f);
    real s = t * t;
    real sum = 0.0028662257f;
    sum = sum * s - 0.0161657367f;
    sum = sum * s + 0.0429096138f;
    sum = sum * s - 0.0752896400f;
    sum = sum * s + 0.1065626393f;
    sum = sum * s - 0.1420889944f;
    sum = sum * s + 0.1999355085f;
    sum = sum * s - 0.3333314528f;
    real small = t + t * s * sum;
    real steep = select(ay > ax, 1.57079633f - small, small);
    return copy_sign(select(x < 0.0f, 3.14159265f - steep, steep), y);
}

// u, v of a direction in the picture's own axes: its middle is -Z, its top +Y.
RL_FN vec2 equirectangular(vec3 d)
{
    real u = 0.5f + angle_of(d.x, -d.z) * 0.159154943f;
    return vec2(u, angle_of(safe_sqrt(d.x * d.x + d.z * d.z), d.y) * 0.318309886f);
}

// Along a ray, unit; pixel_angle [rad] a pixel covers; height [texels] of the picture, which is nowhere squeezed along v.
RL_MAP_FN vec3 sky_color(RL_IN(Maps) maps, RL_IN(Environment) e, vec3 ray, real pixel_angle, real height)
{
    real texels = pixel_angle * (height * 0.318309886f);
    return sample_sky(maps, equirectangular(to_environment(e, ray)), log2_coarse(texels)) * e.intensity;
}
