// SPDX-License-Identifier: Apache-2.0
// The maps that the lighting text reads, for GLSL: samplers are the program's globals, since a struct that holds one can neither be
// local nor be chosen per pixel. The C++ kernels have a struct Maps of views with the same functions. Levels are explicit everywhere.
//
// What the program binds:
// - heights in 16 bits or more (filters of 8-bit texels give whole codes), with mip levels mixed and linear filters, also where they are
//   magnified; wrapped as the texture says;
// - the octahedral environment as one picture, its levels beside each other, each with a border of one texel that
//   continues across its edges as the sphere does (bordered_texel() of image/maps/environment.h). No way to wrap does
//   that, and its levels do not halve. It has a linear filter and no mip levels; 16-bit floats are enough, bright suns
//   ending at their greatest number;
// - the sky repeated along u and ended along v, with mip levels mixed;
// - the shadow maps of all lights in one picture of two 32-bit whole numbers per texel: the bits of the nearness, and the codes of the
//   slopes along x and (above them) down y. Of a cube's faces three stand below each other, the other three to the right of them.
#define RL_ENVIRONMENT_LEVELS 8

struct Maps {
    float height_scale;   // height = height_offset + height_scale * texel: HeightSense of relief/relief.glsl
    float height_offset;
    ivec2 shadow_origin;  // [texels] of the light's shadow map
};

uniform sampler2D rl_heights;
uniform sampler2D rl_environment;      // each level prefiltered for a rougher surface
uniform vec3 rl_environment_levels[RL_ENVIRONMENT_LEVELS];  // [texels] x, y of a level's first one behind its border; its size
uniform sampler2D rl_sky;              // equirectangular
uniform highp usampler2D rl_shadow_atlas;
uniform int rl_shadow_size;            // [texels] a side of a map
uniform sampler2D rl_behind;           // the picture of what is behind transmissive surfaces; levels mixed, ended at its edges
vec2 decode_slopes(vec2 codes);        // shadow/shadow_map.glsl

float sample_height(Maps maps, vec2 uv, float level) { return maps.height_offset + maps.height_scale * textureLod(rl_heights, uv, level).x; }
vec3 environment_level(vec2 uv, int level)
{
    vec3 place = rl_environment_levels[level];
    vec2 size = vec2(textureSize(rl_environment, 0));
    return textureLod(rl_environment, vec2(place.x + uv.x * place.z, place.y + uv.y * place.z) / size, 0.0).xyz;
}
vec3 sample_environment(Maps maps, vec2 uv, float level)
{
    float inside = clamp(level, 0.0, float(RL_ENVIRONMENT_LEVELS - 1));
    int lower = int(inside);
    return mix(environment_level(uv, lower), environment_level(uv, min(lower + 1, RL_ENVIRONMENT_LEVELS - 1)), inside - float(lower));
}
vec3 sample_behind(Maps maps, vec2 uv, float level) { return textureLod(rl_behind, uv, level).xyz; }
vec3 sample_sky(Maps maps, vec2 uv, float level) { return textureLod(rl_sky, uv, level).xyz; }

uvec2 shadow_texel(Maps maps, float column, float row)
{
    ivec2 place = ivec2(int(column), int(row));
    if (place.y >= 3 * rl_shadow_size) {
        place += ivec2(rl_shadow_size, -3 * rl_shadow_size);
    }
    return texelFetch(rl_shadow_atlas, maps.shadow_origin + place, 0).xy;
}
float fetch_nearness(Maps maps, float column, float row) { return uintBitsToFloat(shadow_texel(maps, column, row).x); }
vec2 fetch_slopes(Maps maps, float column, float row)
{
    uint codes = shadow_texel(maps, column, row).y;
    return decode_slopes(vec2(float(codes & 0xffffu), float(codes >> 16)));
}
