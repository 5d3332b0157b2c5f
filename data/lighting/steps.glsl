// Three steps of diffuse light, and no highlight: a lighting model that no fixed pipeline has. docs/opengl.md
RL_FN LightTerms user_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light)
{
    LightTerms terms;
    real steps = floor(lambert_cosine(dot(s.diffuse_n, light.l)) * 3.0f + 0.5f) / 3.0f;
    terms.ambient = s.base.ambient * (light.ambient * light.attenuation);
    terms.diffuse = s.base.diffuse * (light.diffuse * (steps * light.attenuation));
    terms.specular = vec3(0.0f);
    return terms;
}
