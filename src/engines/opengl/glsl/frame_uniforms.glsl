// SPDX-License-Identifier: Apache-2.0
// What is the same for all of a picture, and the lights.
uniform vec2 rl_samples[8];         // [px] places of a pixel's samples about its center
uniform vec3 rl_view_direction;   // towards the viewer, in parallel views and for a viewer infinitely far away
uniform vec4 rl_ray[3];           // rays of the pixels: change per pixel along x and down y; at the middle of the first one
uniform vec4 rl_fog[2];           // color; start, end, density
uniform vec4 rl_environment_numbers[12];  // irradiance, with intensity and last level in w of the first two; axes of the picture
uniform vec4 rl_behind_view[4];   // rows that lead from a point about the eye to u w, v w, w; last level
uniform ivec4 rl_light_count;     // lights; with lists: squares a row, their side [px], texel where lists begin
#if RL_LIGHTS_ARE_NEAR
uniform vec4 rl_light_numbers[RL_LIGHTS_ARE_NEAR * RL_LIGHT_TEXELS];
vec4 light_texel(int i, int k) { return rl_light_numbers[i * RL_LIGHT_TEXELS + k]; }
#else
uniform highp sampler2D rl_lights;  // RL_LIGHT_TEXELS a light
vec4 light_table(int texel) { return texelFetch(rl_lights, ivec2(texel & (RL_FETCH_WIDTH - 1), texel / RL_FETCH_WIDTH), 0); }
vec4 light_texel(int i, int k) { return light_table(i * RL_LIGHT_TEXELS + k); }
#endif

// The kind of a light, RL_..._LIGHT, and 4: it is photometric, 8: it has a range.
int light_kind(int i)
{
#if RL_LIGHTS_ARE_NEAR
    return int(RL_LIGHT_KINDS >> uint(4 * i) & 15u);
#else
    return int(light_texel(i, 0).w);
#endif
}

// Texels of a light: light_table.cpp writes them.
LightSample light_sample(int i, vec3 position)
{
    int kind = light_kind(i);
    vec4 reach = light_texel(i, 2);
    if ((kind & 4) != 0) {
        PhotometricLight light;
        light.type = kind & 3;
        light.position = light_texel(i, 0).xyz;
        light.direction = light_texel(i, 1).xyz;
        light.intensity = light_texel(i, 3).xyz;
        light.inverse_range = reach.w;
        light.cone_scale = reach.x;
        light.cone_offset = reach.y;
        return sample_photometric(light, position);
    }
    ClassicalLight light;
    vec4 ambient = light_texel(i, 4);
    vec4 specular = light_texel(i, 5);
    light.type = kind & 3;
    light.position = light_texel(i, 0).xyz;
    light.direction = light_texel(i, 1).xyz;
    light.ambient = ambient.xyz;
#if RL_LIGHTS_ARE_NEAR
    if ((RL_LIGHTS_WITHOUT_AMBIENT >> uint(i) & 1u) != 0u) {
        light.ambient = vec3(0.0);  // what is multiplied by it goes away
    }
#endif
    light.diffuse = light_texel(i, 3).xyz;
    light.specular = specular.xyz;
    light.constant_term = reach.x;
    light.linear_term = reach.y;
    light.quadratic_term = reach.z;
    light.cos_cutoff = ambient.w;
    light.exponent = specular.w;
    light.has_range = kind & 8;
    light.inverse_range = reach.w;
    return sample_classical(light, position);
}
