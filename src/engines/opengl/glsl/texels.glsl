// SPDX-License-Identifier: Apache-2.0
// Texels of a material's maps at a pixel. The levels are ours, the filters the driver's.
struct TexCoords {
    vec2 uv;
    vec2 dx;  // change from pixel to pixel
    vec2 dy;
};

struct Point {
    vec3 position;  // about the eye, world axes
    vec3 normal;    // interpolated, not unit
    float side;     // -1: it is to be turned round to be on the seen side
    vec3 tangent;   // interpolated, not unit, 0 where the mesh has none
#if RL_HAS_BITANGENTS
    vec3 bitangent;  // likewise, an attribute of its own
#endif
    float w;        // its handedness
    vec4 color;
    TexCoords texcoords[2];
};

TexCoords transformed(TexCoords c, vec4 turn, vec2 offset)
{
    TexCoords to;
    to.uv = vec2(dot(turn.xy, c.uv), dot(turn.zw, c.uv)) + offset;
    to.dx = vec2(dot(turn.xy, c.dx), dot(turn.zw, c.dx));
    to.dy = vec2(dot(turn.xy, c.dy), dot(turn.zw, c.dy));
    return to;
}

// OpenGL 3.3 core, eq. 3.17 and 3.18, with the maximum of the two lengths.
float level_of_detail(vec2 size, TexCoords c)
{
    vec2 x = c.dx * size;
    vec2 y = c.dy * size;
    return 0.5 * log2_coarse(max(dot(x, x), dot(y, y)));
}

vec4 read_once(sampler2D map, TexCoords c)
{
#if RL_COORDS_ARE_MOVED || RL_SAMPLED
    return textureGrad(map, c.uv, c.dx, c.dy);
#else
    return texture(map, c.uv);
#endif
}

// has_levels: else what stretched footprints cover is not averaged.
vec4 read_map(sampler2D map, TexCoords c, bool has_levels)
{
#if RL_ANISOTROPY > 1
    Probes p = probes_of(c.dx, c.dy, vec2(textureSize(map, 0)), RL_ANISOTROPY);
    if (!has_levels || !p.is_stretched) {
        return textureGrad(map, c.uv, c.dx, c.dy);
    }
    vec4 sum = vec4(0.0);
    for (int i = 0; float(i) < p.count; ++i) {
        sum = sum + textureLod(map, probe_place(p, c.uv, i), p.lod);
    }
    return sum * p.inverse;
#else
    return read_once(map, c);
#endif
}
