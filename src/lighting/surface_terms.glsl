// SPDX-License-Identifier: Apache-2.0
// One light's terms for a surface of any lighting model: the classical ones of light_sum.glsl and those of more parameters.

struct MaterialSurface {
    Surface base;     // n: the normal of the specular term
    vec3 diffuse_n;   // unit, the normal of the diffuse term: bumps may act on one of them alone
};

// `seen`, 0..1: how much of the light reaches the surface; ambient light always does.
RL_FN LightTerms surface_terms(RL_IN(MaterialSurface) surface, RL_IN(LightSample) light, real seen, RL_IN(Reflection) reflection)
{
    LightTerms terms = light_terms(surface.base, light, reflection);
    real cosine = lambert_cosine(dot(surface.diffuse_n, light.l));
    terms.diffuse = surface.base.diffuse * (light.diffuse * (cosine * light.attenuation)) * seen;
    terms.specular = terms.specular * seen;
    return terms;
}
