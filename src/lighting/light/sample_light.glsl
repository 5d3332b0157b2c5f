// SPDX-License-Identifier: Apache-2.0
// Lights as a surface point meets them.
// Units: a light's color is irradiance / pi, so that color 1 on a white Lambert surface facing it gives radiance 1; a BRDF
// [1/sr] is multiplied by pi * color * n.l. Light types are the same for all lanes ("uniform").
#define RL_AMBIENT_LIGHT 0
#define RL_DIRECTIONAL_LIGHT 1
#define RL_POINT_LIGHT 2
#define RL_SPOT_LIGHT 3

#define RL_PI 3.14159265f

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
    int has_range;         // point and spot lights: they end at 1 / inverse_range
    real inverse_range;    // [1/m]
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
    if (light.has_range != 0) {
        factor = factor * range_window(ray.squared, light.inverse_range);
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
