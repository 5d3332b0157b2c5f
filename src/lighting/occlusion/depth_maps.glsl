// SPDX-License-Identifier: Apache-2.0
// What horizons.glsl reads, for GLSL: the depth keys of a whole picture as a texture of floats, row 0 on top.
uniform sampler2D rl_keys;  // < 0: nothing is there

float fetch_key(Maps maps, float column, float row)
{
    ivec2 at = ivec2(int(column), int(row));
    ivec2 size = textureSize(rl_keys, 0);
    bool is_inside = at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
    return is_inside ? texelFetch(rl_keys, at, 0).x : -1.0;
}

// The directions of a pixel's slices, by its place in a square of 4 x 4.
int occlusion_place(int column, int row) { return (((column + row) & 3) << 2) + (column & 3); }

uniform int rl_slices;
vec2 slice_turn(Maps maps, int slice)
{
    float place = float(occlusion_place(int(gl_FragCoord.x), int(gl_FragCoord.y)));
    float angle = 3.14159265 * (float(slice) + place / 16.0) / float(rl_slices);
    return vec2(cos(angle), sin(angle));
}
