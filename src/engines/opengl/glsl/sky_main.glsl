// SPDX-License-Identifier: Apache-2.0
// The environment's picture behind everything. rl_ray: of the pixels; w of its first: [rad] a pixel covers at the middle;
// of its second: [texels] height of the picture.
layout(location = 0) out vec4 o_color;

void main()
{
#if RL_PARALLEL
    vec3 ray = -rl_view_direction;
#else
    vec2 at = gl_FragCoord.xy - vec2(0.5);
    vec3 ray = rl_ray[0].xyz * at.x + rl_ray[1].xyz * at.y + rl_ray[2].xyz;
#endif
    float scale = reciprocal(sqrt(max(dot(ray, ray), 1e-20)));
    vec3 color = sky_color(plain_maps(), environment(), ray * scale, rl_ray[0].w * scale, rl_ray[1].w);
    o_color = vec4(color, 1.0);
}
