// Toon shading: a few steps of diffuse light, a highlight with a hard edge, and a rim where the surface turns away. No
// built-in model draws this.
//
//     rakelight render SCENE --engine gl --lighting toon.glsl --uniform steps=4 --uniform rim_color=0.2,0.3,0.5 -o picture.png
uniform int steps = 3;                      // of diffuse light
uniform float highlight = 0.5;              // 0 to 1: where the lobe of the highlight is cut
uniform vec3 rim_color = vec3(0.0);

out float band;   // terms that `explain` prints
out vec3 rim;

RL_FN LightTerms user_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light)
{
    real count = float(steps);
    real n_dot_l = lambert_cosine(dot(s.diffuse_n, light.l));
    vec3 h = safe_normalize(light.l + s.base.v);
    real lobe = n_dot_l > 0.0f ? pow_positive(dot(s.base.n, h), s.base.exponent) : 0.0f;
    real facing = lambert_cosine(dot(s.base.n, s.base.v));
    band = floor(n_dot_l * count + 0.5f) / count;
    rim = rim_color * (facing < 0.3f ? 1.0f : 0.0f);
    LightTerms terms;
    terms.ambient = s.base.ambient * (light.ambient * light.attenuation);
    terms.diffuse = s.base.diffuse * (light.diffuse * (band * light.attenuation));
    terms.specular = (s.base.specular * (lobe > highlight ? 1.0f : 0.0f) + rim) * (light.specular * light.attenuation);
    return terms;
}
