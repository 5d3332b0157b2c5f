// SPDX-License-Identifier: Apache-2.0
// The environment as the lighting text has it, and colors as targets hold them.
Environment environment()
{
    Environment e;
    vec4 n[10] = rl_environment_numbers;
    e.turn = vec2(n[0].w, n[1].w);
    e.intensity = n[2].w;
    e.last_level = n[3].w;
    e.irradiance.constant_part = n[0].xyz;
    e.irradiance.by_y = n[1].xyz;
    e.irradiance.by_z = n[2].xyz;
    e.irradiance.by_x = n[3].xyz;
    e.irradiance.by_xy = n[4].xyz;
    e.irradiance.by_yz = n[5].xyz;
    e.irradiance.by_zz = n[6].xyz;
    e.irradiance.by_xz = n[7].xyz;
    e.irradiance.by_xx_yy = n[8].xyz;
    return e;
}

// What half floats hold; what is not finite is shown black.
float shown_number(float x) { return isnan(x) || isinf(x) ? 0.0 : min(x, 65504.0); }
vec3 shown_color(vec3 c) { return vec3(shown_number(c.x), shown_number(c.y), shown_number(c.z)); }
