// SPDX-License-Identifier: Apache-2.0
// A pixel of a surface, stage by stage in the order of cpu_shading/kernels/shade_points.h: its point, the relief, what the
// material is there, its directions; then the lights, the environment and the fog.
struct Pixel {
    Point point;
    Bumps bumps;
    BaseColor base;
    MaterialSurface surface;
    vec3 emission;
    float alpha;  // < 0: it is not there
};

#if RL_SAMPLED && RL_HAS_SAMPLE_MASK
// [px] from the pixel's center to the middle of the samples that the triangle covers: it is shaded there.
vec2 middle_of_samples()
{
    vec2 sum = vec2(0.0);
    float count = 0.0;
    for (int i = 0; i < RL_SAMPLED; ++i) {
        if ((gl_SampleMaskIn[0] >> i & 1) != 0) {
            sum += rl_samples[i];
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : vec2(0.0);
}
#define RL_MOVED(v) (v + dFdx(v) * middle.x + dFdy(v) * middle.y)
#else
#define RL_MOVED(v) v
#endif

// 1: the front is seen, -1: the back.
float seen_side()
{
#if RL_SEEN_SIDES == RL_SEEN_FRONT
    int turns = RL_FRONT_TURNS;
#elif RL_SEEN_SIDES == RL_SEEN_BACK
    int turns = 1 + RL_FRONT_TURNS;
#else
    int turns = int(!gl_FrontFacing) + RL_FRONT_TURNS;
#endif
#if RL_FROM_TRIANGLES
    turns += v_triangle.y;
#endif
    return (turns & 1) != 0 ? -1.0 : 1.0;
}

Point this_point()
{
    Point p;
#if RL_SAMPLED && RL_HAS_SAMPLE_MASK
    vec2 middle = middle_of_samples();
#endif
    p.position = RL_MOVED(v_position);
    p.side = seen_side();
#if RL_LIT_AT == RL_AT_FACES
    p.normal = v_face_normal;
    p.side = 1.0;
#elif RL_HAS_NORMALS
    p.normal = RL_MOVED(RL_GIVEN(v_normal));
#else
    p.normal = vec3(0.0, 0.0, 1.0);
#endif
#if RL_HAS_TANGENTS
    p.tangent = RL_MOVED(RL_GIVEN(v_tangent)).xyz;
    p.w = RL_GIVEN(v_tangent.w);  // the same at all corners of a triangle
#else
    p.tangent = vec3(0.0);
    p.w = 1.0;
#endif
#if RL_HAS_BITANGENTS
    p.bitangent = RL_MOVED(RL_GIVEN(v_bitangent));
#endif
    p.color = vec4(1.0);
#if RL_HAS_COLORS
    p.color = RL_MOVED(RL_GIVEN(v_color));
#endif
#if RL_HAS_TEXCOORDS
#if RL_SAMPLED && !RL_HAS_SAMPLE_MASK
    RL_TEXCOORDS at = v_center_texcoords;
#if RL_SCREEN_LINEAR
    at = at * gl_FragCoord.w;
#endif
#else
    RL_TEXCOORDS at = RL_GIVEN(v_texcoords);
#endif
#if RL_SCREEN_LINEAR
    RL_TEXCOORDS dx = dFdx(at);
    RL_TEXCOORDS dy = dFdy(at);
#else
    // Over w they are linear on the screen: so these are the changes at this very pixel, as the soft engine has them.
    float per_w = gl_FragCoord.w;
    RL_TEXCOORDS dx = (dFdx(at * per_w) - at * dFdx(per_w)) / per_w;
    RL_TEXCOORDS dy = (dFdy(at * per_w) - at * dFdy(per_w)) / per_w;
#endif
    RL_TEXCOORDS uv = RL_MOVED(RL_GIVEN(v_texcoords));
    p.texcoords[0].uv = uv.xy;
    p.texcoords[0].dx = dx.xy;
    p.texcoords[0].dy = dy.xy;
#if RL_HAS_SECOND_SET
    p.texcoords[1].uv = uv.zw;
    p.texcoords[1].dx = dx.zw;
    p.texcoords[1].dy = dy.zw;
#else
    p.texcoords[1] = p.texcoords[0];
#endif
#endif
    return p;
}

// The first that is known: what masks and shadow maps ask for.
void find_place(inout Pixel x)
{
    x.point = this_point();
    x.bumps.frame = frame_at(x.point);
#if RL_RELIEF != RL_RELIEF_NONE
    enter_relief(x.point, x.bumps);
#endif
    x.base = base_color(x.point);
    x.alpha = alpha_in_silhouette(x.bumps, x.base.color.w);
}

// All that is known of it before light falls on it.
void find_surface(inout Pixel x)
{
    x.emission = vec3(0.0);
#if RL_HAS_EMISSION
    x.emission = emission_of(m_emission, emission_texel(x.point));
#endif
#if !RL_IS_UNLIT
#if RL_PAINTS_LAST
    MaterialTexels texels;
    set_factors(x.surface.base);
#else
    MaterialTexels texels = material_texels(x.point);
    set_material(x.point, texels, x.base, x.surface);
#endif
    vec3 even = x.bumps.frame.normal * x.bumps.frame.side;
    set_normals(x.surface, normal_of_maps(x.point, x.bumps), even, RL_BUMP_TERMS);
    x.surface.base.v = viewer_at(x.bumps.frame, x.point.position);
#if RL_IS_USER
    set_lit_point(x.point.position, vec4(x.point.texcoords[0].uv, x.point.texcoords[1].uv), mapped_vector(x.point), x.point.side);
#endif
    x.emission = finish_surface(x.point, texels, even, x.emission, x.surface);
#else
    x.surface.base.n = normal_of_maps(x.point, x.bumps);
#endif
}

vec3 own_radiance(Pixel x)
{
#if RL_IS_UNLIT
    return unlit(x.base.color.xyz, x.emission);
#else
    return x.emission;
#endif
}

#if RL_HAS_SHADOWS
// Normal of the triangle's plane, on the side that is seen.
vec3 plane_normal_at(vec3 position)
{
    vec3 otherwise = to_viewer(position, rl_view_direction, RL_PARALLEL);
#if RL_PARALLEL
    float away = -dot(rl_view_direction, position);
    return parallel_plane_normal(rl_ray[0].xyz, rl_ray[1].xyz, rl_view_direction, dFdx(away), dFdy(away), otherwise);
#else
    vec3 ray = rl_ray[0].xyz * (gl_FragCoord.x - 0.5) + rl_ray[1].xyz * (gl_FragCoord.y - 0.5) + rl_ray[2].xyz;
    return plane_normal(rl_ray[0].xyz, rl_ray[1].xyz, ray, dFdx(gl_FragCoord.w), dFdy(gl_FragCoord.w), gl_FragCoord.w, otherwise);
#endif
}

// 0..1: how much of light i arrives. Texels 7 to 10 of a light: its shadow map.
float shadow_of(int i, vec3 position, vec3 normal)
{
    vec4 numbers = light_texel(i, 7);
    if (numbers.x < 0.0) {
        return 1.0;
    }
    vec4 right = light_texel(i, 8);
    vec4 up = light_texel(i, 9);
    vec4 ahead = light_texel(i, 10);
    vec4 more = light_texel(i, 6);
    Maps maps = plain_maps();
    maps.shadow_origin = ivec2(int(numbers.x), int(more.z));
    ShadowMap s;
    s.size = RL_SHADOW_SIZE;
    s.is_cube = int(numbers.y == 6.0);
    s.is_parallel = int(numbers.z);
    s.radius = RL_SHADOW_FILTER;
    s.right = right.xyz;
    s.up = up.xyz;
    s.ahead = ahead.xyz;
    s.origin = vec3(right.w, up.w, ahead.w);
    s.texels = numbers.w;
    set_reach(s, more.y);
    return shadow_factor(maps, s, position, normal);
}
#endif

LightTerms terms_of_light(Pixel x, int i, vec3 plane)
{
    LightSample light = light_sample(i, x.point.position);
    light.l = light_direction_at(x.bumps.frame, i, light.l);
#if RL_IS_USER
    rl_point.light = i;
#endif
    float seen = relief_shadow_of(x.bumps, i, light.l);
#if RL_HAS_SHADOWS
    seen = seen * shadow_of(i, x.point.position, plane);
#endif
    return material_terms(x.surface, light, seen, traits(1));
}

#if RL_LIT_AT == RL_AT_FACES
#define RL_GIVEN_LIGHT(v) (v)
#else
#define RL_GIVEN_LIGHT(v) RL_GIVEN(v)
#endif
// The light of the vertices, of the side that is seen.
LightTerms light_of_corners(float side)
{
    LightTerms received = no_terms();
#if RL_LIT_AT != RL_AT_PIXELS
    received.diffuse = RL_GIVEN_LIGHT(v_diffuse);
    received.specular = RL_GIVEN_LIGHT(v_specular);
#if !RL_PAINTS_LAST || RL_LIT_AT == RL_AT_FACES
    received.ambient = RL_GIVEN_LIGHT(v_ambient);
#endif
#if RL_LIT_AT == RL_AT_VERTICES && RL_TWO_SIDES
    if (side < 0.0) {
        received.diffuse = RL_GIVEN(v_turned_diffuse);
        received.specular = RL_GIVEN(v_turned_specular);
#if !RL_PAINTS_LAST
        received.ambient = RL_GIVEN(v_turned_ambient);
#endif
    }
#endif
#endif
    return received;
}

#if RL_HAS_LISTS
// The lights that may reach the square of pixels: where its list begins, and its end.
ivec2 light_list()
{
    ivec2 square = ivec2(gl_FragCoord.xy) / rl_light_count.z;
    vec4 range = light_table(rl_light_count.w + square.y * rl_light_count.y + square.x);
    return ivec2(int(range.x), int(range.y));
}
int listed_light(int at)
{
    vec4 four = light_table(at / 4);
    return int(four[at & 3]);
}
#endif

// What is summed: channels need each term, colors their sum.
#if RL_OUTPUT == RL_OUTPUT_TERMS
#define RL_SUM LightTerms
#define RL_NOTHING no_terms()
#define RL_PLUS(sum, terms) both_terms(sum, terms)
#elif RL_PAINTS_LAST
#define RL_SUM MatteAndGloss
#define RL_NOTHING MatteAndGloss(vec3(0.0), vec3(0.0))
#define RL_PLUS(sum, terms) matte_and_gloss(sum, terms)
#else
#define RL_SUM vec3
#define RL_NOTHING vec3(0.0)
#define RL_PLUS(sum, terms) (sum + radiance_of_terms(terms))
#endif
#define RL_ADD_LIGHT(i) sum = RL_PLUS(sum, terms_of_light(x, i, plane));

// All that falls on the surface: the lights in their order, then the environment, then what is seen through it.
RL_SUM light_on(Pixel x)
{
    RL_SUM sum = RL_NOTHING;
#if !RL_IS_UNLIT
#if RL_LIT_AT != RL_AT_PIXELS
#if RL_PAINTS_LAST
    LightTerms received = light_of_corners(x.point.side);
    sum.matte = received.diffuse;
    sum.gloss = received.specular;
#else
    sum = RL_PLUS(sum, corner_terms(x.surface.base, light_of_corners(x.point.side)));
#endif
#else
    vec3 plane = vec3(0.0, 0.0, 1.0);
#if RL_HAS_SHADOWS
    plane = plane_normal_at(x.point.position);
#endif
#if RL_LIGHTS_ARE_NEAR
    RL_EACH_LIGHT(RL_ADD_LIGHT)
#elif RL_HAS_LISTS
    ivec2 list = light_list();
    for (int at = list.x; at < list.y; ++at) {
        RL_ADD_LIGHT(listed_light(at))
    }
#else
    for (int i = 0; i < rl_light_count.x; ++i) {
        RL_ADD_LIGHT(i)
    }
#endif
#endif
#if RL_HAS_ENVIRONMENT
    sum = RL_PLUS(sum, environment_terms(plain_maps(), environment(), x.surface, traits(1), RL_MODEL));
#endif
#if RL_HAS_TRANSMISSION
    sum = RL_PLUS(sum, terms_from_behind_at(x.point, x.surface));
#endif
#endif
    return sum;
}

// 0..1: how much is seen through the fog.
float fog_at(vec3 position)
{
    return fog_factor(RL_FOG, fog_distance(position, rl_view_direction, RL_PARALLEL), rl_fog[1].x, rl_fog[1].y, rl_fog[1].z);
}

vec3 in_fog(vec3 position, vec3 radiance)
{
#if RL_FOG != RL_NO_FOG
    return behind_fog(radiance, rl_fog[0].xyz, fog_at(position));
#else
    return radiance;
#endif
}
