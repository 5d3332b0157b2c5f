// SPDX-License-Identifier: Apache-2.0
// What a lighting of the user's can ask beside the arguments of its function (docs/user-shaders.md).

// The point that is lit. At vertices and faces (flat and Gouraud shading): no texture coordinates, no map.
struct LitPoint {
    vec3 position;   // about the eye, world axes
    vec4 texcoords;  // set 0, set 1: where textures are read
    vec3 mapped;     // the normal map's vector in (tangent, bitangent, normal), not unit; (0, 0, 1) without a map
    float side;      // 1: the front is seen, -1: the back
    int light;       // number of the light
};
LitPoint rl_point;

void set_lit_point(vec3 position, vec4 texcoords, vec3 mapped, float side)
{
    rl_point.position = position;
    rl_point.texcoords = texcoords;
    rl_point.mapped = mapped;
    rl_point.side = side;
    rl_point.light = 0;
}

// f0 of a microfacet lobe as wide as the material's: s.base.specular is k_s of classical materials.
vec3 lobe_f0(MaterialSurface s)
{
#if RL_IS_METALLIC
    return s.base.specular;
#else
    return classical_f0(s.base.specular, m_lobe_roughness, RL_FORM);
#endif
}
