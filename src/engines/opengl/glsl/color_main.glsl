// SPDX-License-Identifier: Apache-2.0
// The color of a surface.
layout(location = 0) out vec4 o_color;  // premultiplied

void main()
{
    Pixel x;
    find_place(x);
#if RL_IS_MASKED
    if (x.alpha < m_mask_cutoff) {
        discard;
    }
#endif
    find_surface(x);
    vec3 radiance = shown_color(in_fog(x.point.position, own_radiance(x) + radiance_of_terms(light_on(x))));
#if RL_IS_BLENDED
    float alpha = clamp(shown_number(x.alpha), 0.0, 1.0);
    o_color = vec4(radiance * alpha, alpha);
#else
    o_color = vec4(radiance, 1.0);
#endif
}
