// SPDX-License-Identifier: Apache-2.0
// Data channels of a surface, from the same functions as its color. A program for each group: RL_OUTPUT.
uniform highp uvec4 rl_numbers;  // of object, material, mesh
#if RL_OUTPUT == RL_OUTPUT_NUMBERS
layout(location = 0) out highp uvec4 o_numbers;
#elif RL_OUTPUT == RL_OUTPUT_COUNT
layout(location = 0) out vec4 o_count;
#else
layout(location = 0) out vec4 o_first;
layout(location = 1) out vec4 o_second;
layout(location = 2) out vec4 o_third;
layout(location = 3) out vec4 o_fourth;
#endif

#if RL_OUTPUT == RL_OUTPUT_DIRECTIONS
// As normal maps use it; bitangent = cross(normal on the side that is lit, tangent) w. 0 where the mesh has none.
vec4 tangent_at(Point p)
{
    if (!(dot(p.tangent, p.tangent) > 0.0)) {
        return vec4(0.0);
    }
    return vec4(map_tangent(safe_normalize(p.normal), p.tangent, RL_ORTHOGONALIZE), p.w * p.side);
}
#endif

// 0 where the sum is not finite, component by component: none of a color's parts says more than their sum.
float where_finite(float sum, float v) { return abs(sum) <= 3.40282347e38 ? v : 0.0; }
vec4 finite_part(vec3 sum, vec3 v) { return vec4(where_finite(sum.x, v.x), where_finite(sum.y, v.y), where_finite(sum.z, v.z), 1.0); }

void main()
{
    Pixel x;
    find_place(x);
#if RL_OUTPUT == RL_OUTPUT_NUMBERS
    uint triangle = 0u;
#if RL_FROM_TRIANGLES
    triangle = uint(v_triangle.x);
#endif
    o_numbers = uvec4(rl_numbers.xyz, triangle);
#elif RL_OUTPUT == RL_OUTPUT_COUNT
    o_count = vec4(1.0);
#elif RL_OUTPUT == RL_OUTPUT_PLACES
    float away = RL_PARALLEL != 0 ? -dot(rl_view_direction, v_position) : 1.0 / gl_FragCoord.w;
    o_first = vec4(v_position, away);
    o_second = vec4(0.0);
#if RL_HAS_TEXCOORDS
    o_second = RL_GIVEN(v_texcoords);
#endif
    o_third = finite_part(x.base.color.xyz, x.base.color.xyz);
    o_fourth = vec4(0.0);
#elif RL_OUTPUT == RL_OUTPUT_DIRECTIONS
    find_surface(x);
    o_first = vec4(x.surface.base.n, 1.0);
    o_second = vec4(0.0);
    o_fourth = vec4(0.0);
#if RL_FROM_TRIANGLES
    o_second = vec4(v_face_normal, 1.0);
    o_fourth = vec4(RL_GIVEN(v_barycentric), 1.0);
#endif
    o_third = tangent_at(x.point);
#else
    find_surface(x);
    LightTerms light = light_on(x);
    vec3 own = own_radiance(x);
#if RL_FOG != RL_NO_FOG
    light = dimmed_terms(light, fog_at(x.point.position));
    own = in_fog(x.point.position, own);
#endif
    vec3 sum = radiance_of_terms(light) + own;
    o_first = finite_part(sum, light.ambient);
    o_second = finite_part(sum, light.diffuse);
    o_third = finite_part(sum, light.specular);
    o_fourth = finite_part(sum, own);
#endif
#if RL_IS_MASKED
    if (x.alpha < m_mask_cutoff) {
        discard;
    }
#endif
}
