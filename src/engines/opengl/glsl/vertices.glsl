// SPDX-License-Identifier: Apache-2.0
// Vertices: from attributes, or fetched by the number of the triangle (a stream without indices) where a program needs to
// know the triangle: flat shading, channels, lighting in the tangent space of vertices. ES 3.00 has no gl_PrimitiveID.

// rl_object: rows object space -> clip space (4), -> world axes about the eye (3), the same for normals (3), then mirror.
uniform vec4 rl_object[11];

struct Vertex {
    vec3 position;  // object space
    vec3 normal;
    vec4 tangent;
    vec3 bitangent;  // 0: by the cross product
    vec4 texcoords;
    vec4 color;
};

#if RL_HAS_VERTEX_SHADER
void user_vertex(inout Vertex v);  // the user's
#endif

#if RL_FROM_TRIANGLES
uniform highp usampler2D rl_indices;   // of vertices, RL_FETCH_WIDTH a row; behind them a bit a triangle: LitSide::against
uniform highp sampler2D rl_vertices;   // RL_VERTEX_TEXELS a vertex
uniform int rl_first_corner;           // [corners] of the first vertex drawn
uniform int rl_against;                // [texels] where the bits begin; -1: none are set

ivec2 fetch_place(int i) { return ivec2(i & (RL_FETCH_WIDTH - 1), i / RL_FETCH_WIDTH); }

Vertex fetch_vertex(int number)
{
    int texel = number * RL_VERTEX_TEXELS;
    Vertex v;
    v.position = texelFetch(rl_vertices, fetch_place(texel), 0).xyz;
    v.normal = vec3(0.0);
    v.tangent = vec4(0.0, 0.0, 0.0, 1.0);
    v.texcoords = vec4(0.0);
    v.color = vec4(1.0);
#if RL_MESH_NORMALS
    texel += 1;
    v.normal = texelFetch(rl_vertices, fetch_place(texel), 0).xyz;
#endif
#if RL_MESH_TANGENTS
    texel += 1;
    v.tangent = texelFetch(rl_vertices, fetch_place(texel), 0);
#endif
    v.bitangent = vec3(0.0);
#if RL_MESH_BITANGENTS
    texel += 1;
    v.bitangent = texelFetch(rl_vertices, fetch_place(texel), 0).xyz;
#endif
#if RL_MESH_TEXCOORDS
    texel += 1;
    v.texcoords = texelFetch(rl_vertices, fetch_place(texel), 0);
#endif
#if RL_MESH_COLORS
    texel += 1;
    v.color = texelFetch(rl_vertices, fetch_place(texel), 0);
#endif
    return v;
}

Vertex fetch_corner(int corner)
{
    Vertex v = fetch_vertex(int(texelFetch(rl_indices, fetch_place(corner), 0).x));
#if RL_HAS_VERTEX_SHADER
    user_vertex(v);
#endif
    return v;
}

int is_against(int triangle)
{
    if (rl_against < 0) {
        return 0;
    }
    return int(texelFetch(rl_indices, fetch_place(rl_against + triangle / 32), 0).x >> uint(triangle & 31)) & 1;
}
#else
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_texcoords0;
layout(location = 4) in vec2 a_texcoords1;
layout(location = 5) in vec4 a_color;
layout(location = 6) in vec3 a_bitangent;
#endif

// 1; -1 where the object is mirrored: then frames of the world are left-handed where the object's are right-handed.
float mirror() { return rl_object[10].x; }
vec3 by_rows(int first, vec4 v) { return vec3(dot(rl_object[first], v), dot(rl_object[first + 1], v), dot(rl_object[first + 2], v)); }
vec3 to_eye(vec3 position) { return by_rows(4, vec4(position, 1.0)); }
vec4 to_clip(vec3 position) { return vec4(by_rows(0, vec4(position, 1.0)), dot(rl_object[3], vec4(position, 1.0))); }
vec3 tangent_in_world(vec3 tangent) { return safe_normalize_or(by_rows(4, vec4(tangent, 0.0)), vec3(0.0)); }
vec3 normal_in_world(vec3 normal) { return safe_normalize(by_rows(7, vec4(normal, 0.0))); }

#if RL_HAS_VERTEX_SHADER
// For vertex shaders of the user's: the lights, and vectors to them and to the viewer, not unit. position: to_eye().
int light_count()
{
#if RL_LIGHTS_ARE_NEAR
    return RL_LIGHT_COUNT_KNOWN;
#else
    return rl_light_count.x;
#endif
}
vec3 vector_to_light(int i, vec3 position)
{
    return vertex_to_light(position, light_texel(i, 0).xyz, light_texel(i, 1).xyz, int((light_kind(i) & 3) == RL_DIRECTIONAL_LIGHT));
}
vec3 vector_to_viewer(vec3 position) { return vertex_to_viewer(position, rl_view_direction, RL_PARALLEL_VIEWER); }
#endif
