// SPDX-License-Identifier: Apache-2.0
// A texel of a shadow map: how near to the light it is, and how steep (lighting/shadow/shadow_map.glsl).
layout(location = 0) out highp uvec2 o_texel;
uniform float rl_map_texels;  // a meter (perspective: a meter at a distance of one) has; negative: a parallel map

uint slope_code(float slope) { return uint((clamp(slope, -RL_STEEPEST_SLOPE, RL_STEEPEST_SLOPE) + RL_STEEPEST_SLOPE) * RL_SLOPE_CODES + 0.5); }

void main()
{
    bool is_parallel = rl_map_texels < 0.0;
    float nearness = is_parallel ? dot(rl_view_direction, v_position) : gl_FragCoord.w;
    vec2 slopes = vec2(dFdx(nearness), dFdy(nearness)) * (is_parallel ? rl_map_texels : -rl_map_texels / nearness);
#if RL_IS_MASKED
    Pixel x;
    find_place(x);
    if (x.alpha < m_mask_cutoff) {
        discard;
    }
#endif
    o_texel = uvec2(floatBitsToUint(nearness), slope_code(slopes.x) | slope_code(slopes.y) << 16);
}
