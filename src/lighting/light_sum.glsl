// SPDX-License-Identifier: Apache-2.0
// The sum over lights: I = k_a I_a + att (k_d I_d max(0, n.l) + k_s I_s lobe), light by light.
// Units: a light's color is irradiance / pi, so that color 1 on a white Lambert surface facing it gives radiance 1; a BRDF
// [1/sr] is multiplied by pi * color * n.l. Light types, models and forms are the same for all lanes ("uniform").
#define RL_AMBIENT_LIGHT 0
#define RL_DIRECTIONAL_LIGHT 1
#define RL_POINT_LIGHT 2
#define RL_SPOT_LIGHT 3

#define RL_LAMBERT 0
#define RL_PHONG 1
#define RL_BLINN_PHONG 2

#define RL_TEXTBOOK 0
#define RL_NORMALIZED 1

#define RL_PI 3.14159265f

struct Surface {
    vec3 n;         // unit, on the viewer's side
    vec3 v;         // unit, to the viewer
    vec3 ambient;   // k_a
    vec3 diffuse;   // k_d
    vec3 specular;  // k_s
    real exponent;  // >= 1
    real lobe_scale;  // of the specular term: see lobe_scale()
};

// How the terms are formed; the same for all lanes.
struct Reflection {
    int model;    // RL_LAMBERT (no specular term), RL_PHONG, RL_BLINN_PHONG
    int form;     // RL_TEXTBOOK: k_s times the lobe, no cosine; RL_NORMALIZED: BRDF times pi n.l
    int horizon;  // 1: no specular where n.l <= 0; 0: the textbook's print. The normalized form has the cosine anyway
    int whole_exponent;  // that of all surfaces if it is a whole number from 1 on, else 0
};

// One light as a surface point meets it: l unit to the light; colors [irradiance / pi] times attenuation arrive.
struct LightSample {
    vec3 l;
    real attenuation;
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
};

// Classical light: colors and attenuation as design of fixed-function OpenGL; the spot's factors thin ambient light too.
struct ClassicalLight {
    int type;              // RL_..._LIGHT
    vec3 position;         // same space as the surface point
    vec3 direction;        // unit, the way the light travels
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
    real constant_term;    // [1], [1/m], [1/m^2]
    real linear_term;
    real quadratic_term;
    real cos_cutoff;
    real exponent;
};

// Photometric light: intensity already times color; [lx] directional, [cd] point and spot.
struct PhotometricLight {
    int type;
    vec3 position;
    vec3 direction;
    vec3 intensity;
    real inverse_range;    // [1/m], 0: no range
    real cone_scale;       // see photometric_spot
    real cone_offset;
};

// What one light adds, term by term (their sum is the radiance).
struct LightTerms {
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
};

RL_FN LightSample make_sample(vec3 l, real attenuation, vec3 ambient, vec3 diffuse, vec3 specular)
{
    LightSample light;
    light.l = l;
    light.attenuation = attenuation;
    light.ambient = ambient;
    light.diffuse = diffuse;
    light.specular = specular;
    return light;
}

// From a point to a light. At the light itself l is 0, so that nothing arrives but ambient light.
struct LightRay {
    vec3 l;         // unit
    real distance;  // at least 2^-63
    real squared;   // distance, in 2^-126..1e37
};

RL_FN LightRay ray_to(vec3 light_position, vec3 position)
{
    vec3 to_light = light_position - position;
    LightRay ray;
    ray.squared = clamp(dot(to_light, to_light), 1.17549435e-38f, 1e37f);
    real inverse_distance = reciprocal(sqrt(ray.squared));
    ray.l = to_light * inverse_distance;
    ray.distance = ray.squared * inverse_distance;
    return ray;
}

RL_FN LightSample sample_classical(RL_IN(ClassicalLight) light, vec3 position)
{
    if (light.type == RL_AMBIENT_LIGHT) {
        return make_sample(vec3(0.0f, 0.0f, 1.0f), 1.0f, light.ambient, vec3(0.0f), vec3(0.0f));
    }
    if (light.type == RL_DIRECTIONAL_LIGHT) {
        return make_sample(-light.direction, 1.0f, light.ambient, light.diffuse, light.specular);
    }
    LightRay ray = ray_to(light.position, position);
    real factor = classical_attenuation(ray.distance, light.constant_term, light.linear_term, light.quadratic_term);
    if (light.type == RL_SPOT_LIGHT) {
        factor = factor * classical_spot(-dot(light.direction, ray.l), light.cos_cutoff, light.exponent);
    }
    return make_sample(ray.l, factor, light.ambient, light.diffuse, light.specular);
}

RL_FN LightSample sample_photometric(RL_IN(PhotometricLight) light, vec3 position)
{
    vec3 none = vec3(0.0f);
    vec3 color = light.intensity * RL_INVERSE_PI;
    if (light.type == RL_DIRECTIONAL_LIGHT) {
        return make_sample(-light.direction, 1.0f, none, color, color);
    }
    LightRay ray = ray_to(light.position, position);
    real factor = photometric_attenuation(ray.squared, light.inverse_range);
    if (light.type == RL_SPOT_LIGHT) {
        factor = factor * photometric_spot(-dot(light.direction, ray.l), light.cone_scale, light.cone_offset);
    }
    return make_sample(ray.l, factor, none, color, color);
}

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

// What the lobe is a power of: r.v or n.h.
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
    if ((reflection.horizon != 0 || reflection.form == RL_NORMALIZED) && no_lane(cosine > 0.0f)) {
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

// sum + what this light adds: the loop over lights is the caller's and runs in the scene's order.
RL_FN vec3 add_light(vec3 sum, RL_IN(Surface) surface, RL_IN(LightSample) light, RL_IN(Reflection) reflection)
{
    LightTerms terms = light_terms(surface, light, reflection);
    return sum + (terms.ambient + terms.diffuse + terms.specular);
}
