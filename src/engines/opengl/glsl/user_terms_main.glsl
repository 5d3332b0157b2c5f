// SPDX-License-Identifier: Apache-2.0
// Terms that a lighting of the user's declares: what it makes of one light at the pixel.
layout(location = 0) out vec4 o_first;
layout(location = 1) out vec4 o_second;
layout(location = 2) out vec4 o_third;
layout(location = 3) out vec4 o_fourth;
uniform int rl_term_light;

void main()
{
    o_first = vec4(0.0);
    o_second = vec4(0.0);
    o_third = vec4(0.0);
    o_fourth = vec4(0.0);
    Pixel x;
    find_place(x);
#if RL_CALLS_LIGHTING
    find_surface(x);
    rl_point.light = rl_term_light;
    LightSample light = light_sample(rl_term_light, x.point.position);
    light.l = light_direction_at(x.bumps.frame, rl_term_light, light.l);
    LightTerms unused = material_terms(x.surface, light, 1.0, traits(1));
    o_first = RL_TERM_0;
    o_second = RL_TERM_1;
    o_third = RL_TERM_2;
    o_fourth = RL_TERM_3;
#endif
#if RL_IS_MASKED
    if (x.alpha < m_mask_cutoff) {
        discard;
    }
#endif
}
