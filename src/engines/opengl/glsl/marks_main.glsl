// SPDX-License-Identifier: Apache-2.0
// Lines and points: edges and vertices of triangles, and those that scenes hold, as quadrangles on the screen; coverage by
// the distance of a pixel's center, as engines/raster/marks/mark_coverage.h has it. Both stages.
#define RL_HALF_DIAGONAL 0.70711  // [px] of a pixel
uniform vec4 rl_mark;             // [px] size; 0 lines, 1 points, 2 edges, 3 vertices; shape: 0 line, 1 square, 2 disc, + 4: only pixels that it fills; nearest w
uniform vec4 rl_mark_color;       // linear, opacity; times vertex colors where RL_HAS_COLORS
uniform vec4 rl_mark_view;        // [px] width, height of what is drawn; DepthRange::nearness(): scale, offset
uniform vec4 rl_mark_cull;        // 1: back faces are left out; 1: front faces; 1: fronts are negative with y down; a point's radius: of its distance, in parallel views of nearness

#if RL_IS_VERTEX
RL_CONSTANT out vec4 v_ends;   // [px]
RL_CONSTANT out vec2 v_keys;   // nearness there; affine on the screen
RL_CONSTANT out vec2 v_parts;  // where they lie between the line's own ends
RL_CONSTANT out vec4 v_color_0;
RL_CONSTANT out vec4 v_color_1;

// away: along the view axis.
vec3 on_screen(vec4 clip, float away)
{
    vec2 at = (clip.xy / clip.w * 0.5 + vec2(0.5)) * rl_mark_view.xy;
    float key = RL_PARALLEL != 0 ? rl_mark_view.z * away + rl_mark_view.w : rl_mark_view.z + rl_mark_view.w / away;
    return vec3(at, key);
}

bool is_culled(int triangle)
{
    if (rl_mark_cull.x + rl_mark_cull.y == 0.0) {
        return false;
    }
    vec3 v[3];
    for (int k = 0; k < 3; ++k) {
        v[k] = to_clip(fetch_corner(3 * triangle + k).position).xyw;
    }
    float area = dot(v[0], cross(v[1], v[2]));
    bool is_back = (area > 0.0) == (rl_mark_cull.z != 0.0);
    return area == 0.0 || (is_back ? rl_mark_cull.x : rl_mark_cull.y) != 0.0;
}

void main()
{
    int number = gl_VertexID / 6;
    int kind = int(rl_mark.y);
    int first = kind == 0 ? 2 * number : number;
    int second = kind == 0 ? first + 1 : kind == 2 && number % 3 == 2 ? number - 2 : kind == 2 ? number + 1 : number;
    Vertex a = fetch_corner(first);
    Vertex b = fetch_corner(second);
    vec4 from = to_clip(a.position);
    vec4 to = to_clip(b.position);
    vec2 away = vec2(-dot(rl_view_direction, to_eye(a.position)), -dot(rl_view_direction, to_eye(b.position)));
    float least = rl_mark.w;
    gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // nowhere
    v_ends = vec4(0.0);
    v_keys = vec2(0.0);
    v_parts = vec2(0.0, 1.0);
    v_color_0 = vec4(0.0);
    v_color_1 = vec4(0.0);
    if ((from.w < least && to.w < least) || (kind >= 2 && is_culled(number / 3))) {
        return;
    }
    if (from.w < least) {
        v_parts.x = (least - from.w) / (to.w - from.w);
        from = mix(from, to, v_parts.x);
    } else if (to.w < least) {
        v_parts.y = (least - from.w) / (to.w - from.w);
        to = mix(from, to, v_parts.y);
    }
    vec3 p = on_screen(from, mix(away.x, away.y, v_parts.x));
    vec3 q = on_screen(to, mix(away.x, away.y, v_parts.y));
    vec2 along = q.xy - p.xy;
    float length_px = length(along);
    along = length_px > 1e-6 ? along / length_px : vec2(1.0, 0.0);
    float reach = 0.5 * rl_mark.x + RL_HALF_DIAGONAL + 0.5;
    int corner = gl_VertexID % 6;
    bool is_end = corner == 2 || corner == 3 || corner == 5;
    bool is_left = corner == 1 || corner == 4 || corner == 5;
    vec2 at = (is_end ? q.xy + along * reach : p.xy - along * reach) + vec2(-along.y, along.x) * (is_left ? reach : -reach);
    gl_Position = vec4(at / rl_mark_view.xy * 2.0 - vec2(1.0), 0.0, 1.0);
    v_ends = vec4(p.xy, q.xy);
    v_keys = vec2(p.z, q.z);
    v_color_0 = rl_mark_color;
    v_color_1 = rl_mark_color;
#if RL_HAS_COLORS
    v_color_0 = vec4(rl_mark_color.xyz * a.color.xyz, rl_mark_color.w);
    v_color_1 = vec4(rl_mark_color.xyz * b.color.xyz, rl_mark_color.w);
#endif
}
#else
RL_CONSTANT in vec4 v_ends;
RL_CONSTANT in vec2 v_keys;
RL_CONSTANT in vec2 v_parts;
RL_CONSTANT in vec4 v_color_0;
RL_CONSTANT in vec4 v_color_1;
uniform highp sampler2D rl_depth;  // of the surfaces
#if RL_OUTPUT == RL_OUTPUT_NUMBERS
uniform highp uvec4 rl_numbers;
layout(location = 0) out highp uvec4 o_numbers;
#else
layout(location = 0) out vec4 o_first;
#if RL_OUTPUT != RL_OUTPUT_COLOR
layout(location = 1) out vec4 o_second;
layout(location = 2) out vec4 o_third;
layout(location = 3) out vec4 o_fourth;
#endif
#endif

float half_plane(float inside, vec2 n)
{
    vec2 m = abs(n);
    float longer = max(m.x, m.y);
    float shorter = min(m.x, m.y);
    float end = 0.5 * (longer + shorter);
    float even = 0.5 * (longer - shorter);
    float x = abs(inside);
    float outer = x >= end ? 0.0 : x <= even ? 0.5 - x / longer : (end - x) * (end - x) / max(2.0 * longer * shorter, 1e-9);
    return inside < 0.0 ? outer : 1.0 - outer;
}

float strip_coverage(vec2 d, float distance, vec2 across, float width)
{
    if (distance + RL_HALF_DIAGONAL <= width) {
        return 1.0;
    }
    vec2 n = distance > 1e-6 ? d / distance : across;
    float near_border = half_plane(width - distance, n);
    if (distance + width >= RL_HALF_DIAGONAL) {
        return near_border;
    }
    return max(0.0, near_border - half_plane(-width - distance, n));
}

float nearness_at(ivec2 at)
{
    float depth = texelFetch(rl_depth, clamp(at, ivec2(0), ivec2(rl_mark_view.xy) - ivec2(1)), 0).x;
    return RL_IS_REVERSED != 0 ? depth : 1.0 - depth;
}

// A number that is 1 / distance in perspective, up to a factor.
float inverse_of(float key) { return RL_PARALLEL != 0 ? 1.0 : key - rl_mark_view.z; }

// Farther than the surface by more than its depth changes over the mark's reach, and than rounding makes.
bool is_hidden(float key, float reach)
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    float there = nearness_at(at);
    float x = min(abs(nearness_at(at + ivec2(1, 0)) - there), abs(nearness_at(at - ivec2(1, 0)) - there));
    float y = min(abs(nearness_at(at + ivec2(0, 1)) - there), abs(nearness_at(at - ivec2(0, 1)) - there));
    float rounding = 4e-6 * (RL_PARALLEL != 0 ? abs(key) : inverse_of(key)) + (RL_IS_REVERSED != 0 ? 0.0 : 1.2e-7);
    return key + (x + y) * reach + rounding < there;
}

// Of the paraboloid by which points hide each other: raster/marks/tile_marks.h, PointParaboloid. sunk: 1 at the border.
float paraboloid_key(float key, float sunk)
{
    float part = rl_mark_cull.w * sunk;
    float far = RL_PARALLEL != 0 ? key - part : rl_mark_view.z + inverse_of(key) / (1.0 + part);
    return max(far, 1e-7);  // before nothing
}

void main()
{
    vec2 along = v_ends.zw - v_ends.xy;
    float squared = dot(along, along);
    float t = squared > 0.0 ? clamp(dot(gl_FragCoord.xy - v_ends.xy, along) / squared, 0.0, 1.0) : 0.0;
    vec2 d = gl_FragCoord.xy - (v_ends.xy + along * t);
    float width = 0.5 * rl_mark.x;
    vec2 across = squared > 0.0 ? vec2(-along.y, along.x) * inversesqrt(squared) : vec2(1.0, 0.0);
    float coverage = 0.0;
    int shape = int(rl_mark.z) % 4;
    if (shape == 1) {
        coverage = strip_coverage(vec2(d.x, 0.0), abs(d.x), vec2(1.0, 0.0), width) * strip_coverage(vec2(0.0, d.y), abs(d.y), vec2(0.0, 1.0), width);
    } else {
        coverage = strip_coverage(d, length(d), across, width);
    }
    float key = mix(v_keys.x, v_keys.y, t);
    if (!(coverage > (rl_mark.z >= 4.0 ? 0.999 : 1e-6)) || key < 0.0 || key > 1.0 || is_hidden(key, width + RL_HALF_DIAGONAL)) {
        discard;
    }
    // Colors are linear along the line in space: part / w is on the screen.
    vec2 per_w = vec2(inverse_of(v_keys.x) * (1.0 - t), inverse_of(v_keys.y) * t);
    vec4 color = mix(v_color_0, v_color_1, dot(v_parts, per_w) / (per_w.x + per_w.y));
    float order = shape == 0 ? key : paraboloid_key(key, dot(d, d) / (width * width));
    gl_FragDepth = RL_IS_REVERSED != 0 ? order : 1.0 - order;
#if RL_OUTPUT == RL_OUTPUT_COLOR
    float alpha = clamp(color.w, 0.0, 1.0) * coverage;
    o_first = vec4(color.xyz * alpha, alpha);
#else
    bool has_center = shape == 1 ? max(abs(d.x), abs(d.y)) <= max(width, 0.5) : dot(d, d) <= max(width, 0.5) * max(width, 0.5);
    if (!has_center || color.w < 1.0) {
        discard;
    }
#if RL_OUTPUT == RL_OUTPUT_NUMBERS
    o_numbers = uvec4(rl_numbers.xyz, 0xffffffffu);
#elif RL_OUTPUT == RL_OUTPUT_PLACES
    vec3 ray = rl_ray[0].xyz * (gl_FragCoord.x - 0.5) + rl_ray[1].xyz * (gl_FragCoord.y - 0.5) + rl_ray[2].xyz;
    float away = RL_PARALLEL != 0 ? (key - rl_mark_view.w) / rl_mark_view.z : rl_mark_view.w / (key - rl_mark_view.z);
    o_first = vec4(RL_PARALLEL != 0 ? ray - rl_view_direction * away : ray * away, away);
    o_second = vec4(0.0);
    o_third = vec4(color.xyz, 1.0);
    o_fourth = vec4(0.0);
#else
    o_first = vec4(0.0);
    o_second = vec4(0.0);
    o_third = vec4(0.0);
    o_fourth = RL_OUTPUT == RL_OUTPUT_TERMS ? vec4(color.xyz, 1.0) : vec4(0.0);
#endif
#endif
}
#endif
