// SPDX-License-Identifier: Apache-2.0
// The tables of directional albedos for GLSL, all in one texture of 32 x 82 texels: rows of lobe_loss, grazing and sheen of
// albedo_tables.h, then two of loss.
uniform sampler2D rl_albedos;

// By four texels and a mix: the weights of the hardware may have 8 bits.
float sample_albedo(Maps maps, int table, float x, float y)
{
    int rows = table == 2 ? 16 : table == 3 ? 2 : 32;
    int first = table == 0 ? 0 : table == 1 ? 32 : table == 2 ? 64 : 80;
    float column = clamp(x, 0.0f, 1.0f) * 31.0f;
    float row = clamp(y, 0.0f, 1.0f) * float(rows - 1);
    ivec2 at = ivec2(min(int(column), 30), min(int(row), rows - 2));
    vec2 share = vec2(column, row) - vec2(at);
    at.y += first;
    float upper = mix(texelFetch(rl_albedos, at, 0).x, texelFetch(rl_albedos, at + ivec2(1, 0), 0).x, share.x);
    float lower = mix(texelFetch(rl_albedos, at + ivec2(0, 1), 0).x, texelFetch(rl_albedos, at + ivec2(1, 1), 0).x, share.x);
    return mix(upper, lower, share.y);
}
