// SPDX-License-Identifier: Apache-2.0
// A point of a draw that is lit before there are pixels (flat and Gouraud shading), whose terms are those per unit of reflectance.

RL_FN Surface unit_surface(vec3 n, vec3 v, real exponent, RL_IN(Reflection) r)
{
    Surface s;
    s.n = n;
    s.v = v;
    s.ambient = vec3(1.0f);
    s.diffuse = vec3(1.0f);
    s.specular = vec3(1.0f);
    s.exponent = exponent;
    s.lobe_scale = lobe_scale(exponent, r);
    return s;
}

// The same for models of more parameters: of equal widths (0: those of the roughness), with no layers and no rise of Fresnel's term.
// Its dielectric_f0 and dielectric_f90, and Oren-Nayar's terms, are the caller's.
RL_MAP_FN MaterialSurface unit_material(RL_IN(Surface) base, RL_IN(Maps) maps, real roughness, vec2 ward_alpha)
{
    MaterialSurface s;
    s.base = base;
    s.diffuse_n = base.n;
    s.coat_n = base.n;
    s.roughness = roughness;
    s.table_roughness = roughness;
    s.alpha_x = max(select(ward_alpha.x > 0.0f, sqrt(ward_alpha.x * ward_alpha.y), roughness * roughness), 1e-3f);
    s.alpha_y = s.alpha_x;
    s.tangent = orthogonal_tangent(base.n, vec3(1.0f, 0.0f, 0.0f));
    s.bitangent = cross(base.n, s.tangent);
    s.f90 = vec3(1.0f);
    s.scattering = vec3(1.0f);
    s.albedo = lobe_albedo(maps, dot(base.n, base.v), roughness);
    s.albedo_mean = lobe_mean(maps, roughness);
    return s;
}

// Of metallic-roughness points: what the dielectric part's mirror takes of the diffuse term.
RL_FN void set_point_dielectric(RL_INOUT(MaterialSurface) s, vec3 dielectric_color, real strength)
{
    s.dielectric_f90 = strength;
    s.dielectric_f0 = greatest(dielectric_f0(dielectric_color, strength));
}
