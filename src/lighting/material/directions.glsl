// SPDX-License-Identifier: Apache-2.0
// Normals of the terms, axes of the lobes, normal of the coat.
#define RL_BUMP_BOTH 0
#define RL_BUMP_DIFFUSE 1
#define RL_BUMP_SPECULAR 2

// bumped: the normal with bumps, even: without; both unit, on the side that is lit.
RL_FN void set_normals(RL_INOUT(MaterialSurface) s, vec3 bumped, vec3 even, int bump_terms)
{
    s.base.n = bumped;
    s.diffuse_n = bumped;
    if (bump_terms == RL_BUMP_DIFFUSE) {
        s.base.n = even;
    }
    if (bump_terms == RL_BUMP_SPECULAR) {
        s.diffuse_n = even;
    }
}

// n turned as little as keeps the mirror direction of v above the surface, whose own normal is `plane`: no black fringes where bumps
// and smooth normals lead below it. All unit, v above the plane. Source: Keller et al. 2017, "The Iray Light Transport Simulation and
// Rendering System", appendix A.3.
RL_FN vec3 valid_normal(vec3 n, vec3 v, vec3 plane)
{
    vec3 mirrored_v = n * (2.0f * dot(n, v)) - v;
    real depth = dot(mirrored_v, plane);
    real least = min(0.9f * dot(v, plane), 0.01f);
    vec3 raised = safe_normalize_or(mirrored_v + plane * (least - depth), plane);
    return select(depth < least, safe_normalize_or(v + raised, plane), n);
}

// tangent not unit; bitangent = cross(n, t) * w.
RL_FN void set_lobe_axes(RL_INOUT(MaterialSurface) s, vec3 tangent, real w)
{
    s.tangent = orthogonal_tangent(s.base.n, tangent);
    s.bitangent = cross(s.base.n, s.tangent) * w;
}

// KHR_materials_anisotropy: axis (cosine, sine) in tangent and bitangent, turned by the map. The neutral texel is (1, 0.5, 1, 1).
RL_FN void turn_lobe_axes(RL_INOUT(MaterialSurface) s, vec2 axis, vec4 texel)
{
    vec2 d = vec2(2.0f * texel.x - 1.0f, 2.0f * texel.y - 1.0f);
    vec2 turned_axis = vec2(axis.x * d.x - axis.y * d.y, axis.y * d.x + axis.x * d.y);
    s.tangent = safe_normalize_or(s.tangent * turned_axis.x + s.bitangent * turned_axis.y, s.tangent);
    s.bitangent = cross(s.base.n, s.tangent);
}

// n: without the bumps of the base, unit; texel of the coat's own normal map.
RL_FN vec3 coat_normal(vec3 n, vec3 tangent, real w, vec4 texel, real scale)
{
    vec3 mapped = decode_normal(vec3(texel.x, texel.y, texel.z), scale);
    return perturb_normal(n, orthogonal_tangent(n, tangent), w, mapped);
}
