// SPDX-License-Identifier: Apache-2.0
// A peer written by hand, not the text of src/lighting: its equations for what the measured scene has alone: point lights, textbook Blinn-Phong that ends at the horizon,
// tangents made perpendicular at every pixel. The eye is at the origin.
#pragma once

namespace rakelight::bench {

inline constexpr const char* lighting_text = R"(
uniform vec3 specular_color;
uniform float shininess;
#if LIGHTS > 0
uniform vec3 light_position[LIGHTS], light_color[LIGHTS], light_ambient[LIGHTS], light_thinning[LIGHTS];
#endif
// diffuse: what the own color of the surface is multiplied by; specular: what is added
void light_up(vec3 position, vec3 n, out vec3 diffuse, out vec3 specular)
{
    diffuse = specular = vec3(0.0);
#if LIGHTS > 0
    vec3 v = normalize(-position);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 to_light = light_position[i] - position;
        float d2 = dot(to_light, to_light), d = sqrt(d2);
        vec3 l = to_light / d;
        float thin = 1.0 / (light_thinning[i].x + light_thinning[i].y * d + light_thinning[i].z * d2);
        float n_dot_l = dot(n, l);
        diffuse += thin * (light_ambient[i] + light_color[i] * max(n_dot_l, 0.0));
        float n_dot_h = max(dot(n, normalize(l + v)), 0.0);
        float lobe = n_dot_l > 0.0 ? pow(n_dot_h, shininess) : 0.0;
        specular += thin * lobe * light_color[i];
    }
    specular *= specular_color;
#endif
}
)";

inline constexpr const char* vertex_text = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 texcoord;
uniform mat4 model, projection;
uniform mat3 rotation;
out vec2 uv;
#if defined(GOURAUD)
out vec3 vertex_diffuse, vertex_specular;
#elif !defined(UNLIT)
out vec3 world, n0;
#ifdef NORMAL_MAP
out vec4 t0;
#endif
#endif
void main()
{
    vec4 p = model * vec4(position, 1.0);
    gl_Position = projection * p;
    uv = texcoord;
#if defined(GOURAUD)
    light_up(p.xyz, normalize(rotation * normal), vertex_diffuse, vertex_specular);
#elif !defined(UNLIT)
    world = p.xyz;
    n0 = rotation * normal;
#ifdef NORMAL_MAP
    t0 = vec4(rotation * tangent.xyz, tangent.w);
#endif
#endif
}
)";

inline constexpr const char* fragment_text = R"(
uniform sampler2D color_map, normal_map;
uniform vec3 base_color;
in vec2 uv;
#if defined(GOURAUD)
in vec3 vertex_diffuse, vertex_specular;
#elif !defined(UNLIT)
in vec3 world, n0;
#ifdef NORMAL_MAP
in vec4 t0;
#endif
#endif
out vec4 color;
void main()
{
#ifdef PLAIN
    vec3 own = base_color;
#else
    vec3 own = base_color * texture(color_map, uv).rgb;
#endif
#if defined(UNLIT)
    color = vec4(own, 1.0);
#elif defined(GOURAUD)
    color = vec4(own * vertex_diffuse + vertex_specular, 1.0);
#else
    vec3 n = normalize(n0), diffuse, specular;
#ifdef NORMAL_MAP
    vec3 t = normalize(t0.xyz - n * dot(n, t0.xyz)), b = cross(n, t) * t0.w, m = 2.0 * texture(normal_map, uv).xyz - 1.0;
    n = normalize(t * m.x + b * m.y + n * m.z);
#endif
    light_up(world, n, diffuse, specular);
    color = vec4(own * diffuse + specular, 1.0);
#endif
}
)";

}  // namespace rakelight::bench
