// SPDX-License-Identifier: Apache-2.0
// The environment as the lighting text has it.
Environment environment()
{
    Environment e;
    vec4 n[12] = rl_environment_numbers;
    e.intensity = n[0].w;
    e.last_level = n[1].w;
    e.to_x = n[9].xyz;
    e.to_y = n[10].xyz;
    e.to_z = n[11].xyz;
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
