// SPDX-License-Identifier: Apache-2.0
// The sum over lights: I = k_a I_a + att (k_d I_d max(0, n.l) + k_s I_s lobe), light by light.

// Energy factor of the specular term, the same for all lights: pi times the lobe's normalization, or 1 in textbook form.
RL_FN real lobe_scale(real exponent, RL_IN(Reflection) reflection)
{
    if (reflection.form == RL_NORMALIZED && reflection.model == RL_PHONG) {
        return RL_PI * phong_normalization(exponent);
    }
    if (reflection.form == RL_NORMALIZED && reflection.model == RL_BLINN_PHONG) {
        return RL_PI * blinn_phong_normalization(exponent);
    }
    return 1.0f;
}

// The base of the lobe's power: r.v or n.h.
RL_FN real lobe_cosine(RL_IN(Surface) surface, vec3 l, RL_IN(Reflection) reflection)
{
    if (reflection.model == RL_PHONG) {
        return phong_r_dot_v(surface.n, l, surface.v);
    }
    return blinn_phong_n_dot_h(surface.n, l, surface.v);
}

// c^exponent for c in 0..1, 0 outside of it below; a whole exponent takes a sixth of the operations.
RL_FN real lobe(real c, real exponent, RL_IN(Reflection) reflection)
{
    if (reflection.whole_exponent > 0) {
        return whole_power(clamp(c, 0.0f, 1.0f), reflection.whole_exponent);
    }
    return pow_positive(min(1.0f, c), exponent);
}

// What k_s and the light's color are multiplied by; cosine is max(0, n.l).
RL_FN real specular_factor(RL_IN(Surface) surface, vec3 l, real cosine, RL_IN(Reflection) reflection)
{
    real response = lobe(lobe_cosine(surface, l, reflection), surface.exponent, reflection);
    if (reflection.form == RL_NORMALIZED) {
        return response * (surface.lobe_scale * cosine);
    }
    if (reflection.horizon != 0) {
        return select(cosine > 0.0f, response, 0.0f);
    }
    return response;
}

// What the products of the surface's and the light's colors are multiplied by.
struct LightWeights {
    real ambient;
    real diffuse;
    real specular;
};

RL_FN LightWeights light_weights(RL_IN(Surface) surface, RL_IN(LightSample) light, RL_IN(Reflection) reflection)
{
    LightWeights weights;
    weights.ambient = light.attenuation;
    weights.diffuse = 0.0f;
    weights.specular = 0.0f;
    real cosine = lambert_cosine(dot(surface.n, light.l));
    if ((reflection.horizon != 0 || reflection.form == RL_NORMALIZED) && RL_CAN_SKIP(cosine > 0.0f)) {
        return weights;
    }
    weights.diffuse = cosine * light.attenuation;
    if (reflection.model != RL_LAMBERT) {
        weights.specular = specular_factor(surface, light.l, cosine, reflection) * light.attenuation;
    }
    return weights;
}

RL_FN LightTerms light_terms(RL_IN(Surface) surface, RL_IN(LightSample) light, RL_IN(Reflection) reflection)
{
    LightWeights weights = light_weights(surface, light, reflection);
    LightTerms terms;
    terms.ambient = surface.ambient * (light.ambient * weights.ambient);
    terms.diffuse = surface.diffuse * (light.diffuse * weights.diffuse);
    terms.specular = surface.specular * (light.specular * weights.specular);
    return terms;
}

RL_FN LightTerms no_terms()
{
    LightTerms terms;
    terms.ambient = vec3(0.0f);
    terms.diffuse = vec3(0.0f);
    terms.specular = vec3(0.0f);
    return terms;
}

RL_FN LightTerms both_terms(RL_IN(LightTerms) a, RL_IN(LightTerms) b)
{
    LightTerms terms;
    terms.ambient = a.ambient + b.ambient;
    terms.diffuse = a.diffuse + b.diffuse;
    terms.specular = a.specular + b.specular;
    return terms;
}

RL_FN LightTerms dimmed_terms(RL_IN(LightTerms) terms, real share)
{
    LightTerms dimmed;
    dimmed.ambient = terms.ambient * share;
    dimmed.diffuse = terms.diffuse * share;
    dimmed.specular = terms.specular * share;
    return dimmed;
}

RL_FN vec3 radiance_of_terms(RL_IN(LightTerms) terms)
{
    return terms.ambient + terms.diffuse + terms.specular;
}

// sum + what this light adds: the loop over lights is the caller's and runs in the scene's order.
RL_FN vec3 add_light(vec3 sum, RL_IN(Surface) surface, RL_IN(LightSample) light, RL_IN(Reflection) reflection)
{
    return sum + radiance_of_terms(light_terms(surface, light, reflection));
}

// Flat and Gouraud shading: what the corners have received per unit of reflectance, times what the pixel reflects.
RL_FN LightTerms corner_terms(RL_IN(Surface) surface, RL_IN(LightTerms) received)
{
    LightTerms terms;
    terms.ambient = surface.ambient * received.ambient;
    terms.diffuse = surface.diffuse * received.diffuse;
    terms.specular = surface.specular * received.specular;
    return terms;
}
