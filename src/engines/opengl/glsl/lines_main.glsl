// SPDX-License-Identifier: Apache-2.0
// Lines as quadrangles on the screen, anti-aliased by the distance to their middle.
#if RL_IS_VERTEX
layout(location = 0) in vec4 a_place;   // x, y in -1..1; DepthRange::nearness(); [px] across from the middle
layout(location = 1) in vec4 a_color;
layout(location = 2) in vec2 a_line;    // [px] half the width; 1: seen through surfaces
out vec4 v_color;
out vec3 v_line;
out float v_nearness;
void main()
{
    gl_Position = vec4(a_place.xy, 0.0, 1.0);
    v_color = a_color;
    v_line = vec3(a_line, a_place.w);
    v_nearness = a_place.z;
}
#else
uniform sampler2D rl_depth;
uniform vec4 rl_show;       // [px] of the viewport's corner; 1 where rl_depth holds what is on the screen; its height
in vec4 v_color;
in vec3 v_line;
in float v_nearness;
uniform float rl_show_scale;  // of DepthRange::nearness(); 0 in parallel views
out vec4 o_color;
void main()
{
    float coverage = clamp(v_line.x + 0.5 - abs(v_line.z), 0.0, 1.0);
    if (rl_show.z != 0.0 && v_line.y == 0.0) {
        vec2 at = gl_FragCoord.xy - rl_show.xy;
        float there = texelFetch(rl_depth, ivec2(int(at.x), int(rl_show.w - at.y)), 0).x;
        float nearness = RL_IS_REVERSED != 0 ? there : 1.0 - there;
        if (v_nearness < nearness - 1e-4 * abs(nearness - rl_show_scale) - (RL_IS_REVERSED != 0 ? 0.0 : 1.2e-7)) {
            discard;
        }
    }
    o_color = vec4(v_color.xyz * v_color.w, v_color.w) * coverage;
}
#endif
