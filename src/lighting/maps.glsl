// SPDX-License-Identifier: Apache-2.0
// The maps that the lighting text reads, for GLSL: samplers are the program's globals, since a struct that holds one can neither be
// local nor be chosen per pixel. The C++ kernels have a struct Maps of views with the same functions. Levels are explicit everywhere.
//
// What the program binds: heights with linear filters, also where they are magnified; the octahedral environment with its levels mixed,
// its texels going on across the map's edges as the sphere does; nearness and slopes of one light's shadow map, for one light a pass.
struct Maps {
    float height_scale;   // height = height_offset + height_scale * texel: HeightSense of relief/relief.glsl
    float height_offset;
};

uniform sampler2D rl_heights;
uniform sampler2D rl_environment;      // octahedral, each level prefiltered for a rougher surface
uniform sampler2D rl_sky;              // equirectangular
uniform sampler2D rl_shadow_nearness;  // faces of a cube below each other
uniform sampler2D rl_shadow_slopes;    // along x, down y

float sample_height(Maps maps, vec2 uv, float level) { return maps.height_offset + maps.height_scale * textureLod(rl_heights, uv, level).x; }
vec3 sample_environment(Maps maps, vec2 uv, float level) { return textureLod(rl_environment, uv, level).xyz; }
vec3 sample_sky(Maps maps, vec2 uv, float level) { return textureLod(rl_sky, uv, level).xyz; }

float fetch_nearness(Maps maps, float column, float row) { return texelFetch(rl_shadow_nearness, ivec2(int(column), int(row)), 0).x; }
vec2 fetch_slopes(Maps maps, float column, float row) { return texelFetch(rl_shadow_slopes, ivec2(int(column), int(row)), 0).xy; }
