// SPDX-License-Identifier: Apache-2.0
// The color of a surface.
layout(location = 0) out vec4 o_color;  // premultiplied

void main()
{
    Pixel x;
    find_place(x);
    find_surface(x);
    vec3 radiance = own_radiance(x);
#if RL_PAINTS_LAST
    radiance += painted(x.point, x.base, light_on(x));
#else
    radiance += light_on(x);
#endif
    radiance = in_fog(x.point.position, radiance);
#if RL_IS_BLENDED
    float alpha = clamp(x.alpha, 0.0, 1.0);
    o_color = vec4(radiance * alpha, alpha);
#else
    o_color = vec4(radiance, 1.0);
#endif
#if RL_IS_MASKED
    if (x.alpha < m_mask_cutoff) {
        discard;  // last: textures are read with what changes to the pixels beside
    }
#endif
}
