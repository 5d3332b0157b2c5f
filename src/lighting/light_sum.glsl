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
};

// How the terms are formed; the same for all lanes.
struct Reflection {
    int model;    // RL_LAMBERT (no specular term), RL_PHONG, RL_BLINN_PHONG
    int form;     // RL_TEXTBOOK: k_s times the lobe, no cosine; RL_NORMALIZED: BRDF times pi n.l
    int horizon;  // 1: no specular where n.l <= 0; 0: the textbook's print. The normalized form has the cosine anyway
};

// One light as a surface point meets it: l unit to the light, colors already attenuated [irradiance / pi].
struct LightSample {
    vec3 l;
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

// Colors of a sample, thinned.
RL_FN LightSample scaled_sample(vec3 l, vec3 ambient, vec3 diffuse, vec3 specular, real factor)
{
    LightSample light;
    light.l = l;
    light.ambient = ambient * factor;
    light.diffuse = diffuse * factor;
    light.specular = specular * factor;
    return light;
}

RL_FN LightSample sample_classical(ClassicalLight light, vec3 position)
{
    if (light.type == RL_AMBIENT_LIGHT) {
        return scaled_sample(vec3(0.0f, 0.0f, 1.0f), light.ambient, vec3(0.0f), vec3(0.0f), 1.0f);
    }
    if (light.type == RL_DIRECTIONAL_LIGHT) {
        return scaled_sample(-light.direction, light.ambient, light.diffuse, light.specular, 1.0f);
    }
    vec3 to_light = light.position - position;
    vec3 l = safe_normalize(to_light);
    real factor = classical_attenuation(dot(to_light, to_light), light.constant_term, light.linear_term, light.quadratic_term);
    if (light.type == RL_SPOT_LIGHT) {
        factor = factor * classical_spot(-dot(light.direction, l), light.cos_cutoff, light.exponent);
    }
    return scaled_sample(l, light.ambient, light.diffuse, light.specular, factor);
}

RL_FN LightSample sample_photometric(PhotometricLight light, vec3 position)
{
    vec3 none = vec3(0.0f);
    vec3 color = light.intensity * RL_INVERSE_PI;
    if (light.type == RL_DIRECTIONAL_LIGHT) {
        return scaled_sample(-light.direction, none, color, color, 1.0f);
    }
    vec3 to_light = light.position - position;
    vec3 l = safe_normalize(to_light);
    real factor = photometric_attenuation(dot(to_light, to_light), light.inverse_range);
    if (light.type == RL_SPOT_LIGHT) {
        factor = factor * photometric_spot(-dot(light.direction, l), light.cone_scale, light.cone_offset);
    }
    return scaled_sample(l, none, color, color, factor);
}

// What k_s and the light's color are multiplied by; cosine is max(0, n.l).
RL_FN real specular_factor(vec3 n, vec3 l, vec3 v, real cosine, real exponent, Reflection reflection)
{
    real response = 0.0f;
    real normalization = 0.0f;
    if (reflection.model == RL_PHONG) {
        response = phong_lobe(phong_r_dot_v(n, l, v), exponent);
        normalization = phong_normalization(exponent);
    }
    if (reflection.model == RL_BLINN_PHONG) {
        response = blinn_phong_lobe(blinn_phong_n_dot_h(n, l, v), exponent);
        normalization = blinn_phong_normalization(exponent);
    }
    if (reflection.form == RL_NORMALIZED) {
        response = response * (RL_PI * normalization * cosine);
    }
    return response;
}

RL_FN LightTerms light_terms(Surface surface, LightSample light, Reflection reflection)
{
    LightTerms terms;
    terms.ambient = surface.ambient * light.ambient;
    terms.diffuse = vec3(0.0f);
    terms.specular = vec3(0.0f);
    real n_dot_l = dot(surface.n, light.l);
    mask is_lit = n_dot_l > 0.0f;
    bool ends_at_horizon = reflection.horizon != 0 || reflection.form == RL_NORMALIZED;
    if (ends_at_horizon && no_lane(is_lit)) {
        return terms;
    }
    real cosine = lambert_cosine(n_dot_l);
    terms.diffuse = select(is_lit, surface.diffuse * light.diffuse * cosine, terms.diffuse);
    if (reflection.model != RL_LAMBERT) {
        real factor = specular_factor(surface.n, light.l, surface.v, cosine, surface.exponent, reflection);
        vec3 specular = surface.specular * light.specular * factor;
        terms.specular = select(is_lit || !ends_at_horizon, specular, terms.specular);
    }
    return terms;
}

// sum + what this light adds: the loop over lights is the caller's and runs in the scene's order.
RL_FN vec3 add_light(vec3 sum, Surface surface, LightSample light, Reflection reflection)
{
    LightTerms terms = light_terms(surface, light, reflection);
    return sum + (terms.ambient + terms.diffuse + terms.specular);
}
