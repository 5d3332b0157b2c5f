// Normal mapping in tangent space, second half: Phong's model with the normal as the map has it, and with the vectors that
// tangent_space.vertex.glsl hands on. The same picture as --lighting phong --tangent-space vertex.
in vec3 to_light[8];
in vec3 to_viewer_t;

RL_FN LightTerms user_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light)
{
    vec3 n = safe_normalize(rl_point.mapped) * rl_point.side;
    vec3 l = safe_normalize(to_light[min(rl_point.light, 7)]);
    vec3 v = safe_normalize(to_viewer_t);
    real n_dot_l = dot(n, l);
    vec3 r = n * (2.0f * n_dot_l) - l;
    real lobe = n_dot_l > 0.0f ? pow_positive(min(dot(r, v), 1.0f), s.base.exponent) : 0.0f;
    LightTerms terms;
    terms.ambient = s.base.ambient * (light.ambient * light.attenuation);
    terms.diffuse = s.base.diffuse * (light.diffuse * (max(n_dot_l, 0.0f) * light.attenuation));
    terms.specular = s.base.specular * (light.specular * (lobe * light.attenuation));
    return terms;
}
