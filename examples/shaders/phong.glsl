// Phong's model as the classical texts print it: I = k_a I_a + att (k_d I_d (n.l) + k_s I_s (r.v)^n), with r = 2 (n.l) n - l.
// The same picture as --lighting phong --specular textbook, which is the default of classical materials.
//
//     rakelight render SCENE --engine gl --lighting phong.glsl -o picture.png
RL_FN LightTerms user_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light)
{
    real n_dot_l = dot(s.base.n, light.l);
    real diffuse = max(dot(s.diffuse_n, light.l), 0.0f);
    vec3 r = s.base.n * (2.0f * n_dot_l) - light.l;
    real lobe = n_dot_l > 0.0f ? pow_positive(min(dot(r, s.base.v), 1.0f), s.base.exponent) : 0.0f;
    LightTerms terms;
    terms.ambient = s.base.ambient * (light.ambient * light.attenuation);
    terms.diffuse = s.base.diffuse * (light.diffuse * (diffuse * light.attenuation));
    terms.specular = s.base.specular * (light.specular * (lobe * light.attenuation));
    return terms;
}
