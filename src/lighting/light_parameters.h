// SPDX-License-Identifier: Apache-2.0
// One light as plain floats, made once per frame by ordinary code and read by kernels of every instruction set
// (lighting.h: sample_light). All positions in one space of the caller's choice (the engines': relative to the camera).
#pragma once
#include <stdint.h>

namespace rakelight::lighting {

enum class LightKind : int32_t {
    ambient = 0,
    directional = 1,
    point = 2,
    spot = 3
};  // = RL_..._LIGHT of light/sample_light.glsl

struct LightParameters {
    LightKind kind = LightKind::point;
    bool is_photometric = false;
    bool casts_shadow = true;  ///< reliefs cast shadows on themselves in it
    float position[3] = {0, 0, 0};
    float direction[3] = {0, 0, -1};  ///< unit, the way the light travels
    // classical
    float ambient[3] = {0, 0, 0}, diffuse[3] = {1, 1, 1}, specular[3] = {1, 1, 1};
    float constant_term = 1, linear_term = 0, quadratic_term = 0;
    float cos_cutoff = 0, exponent = 0;
    // photometric
    float intensity[3] = {1, 1, 1};  ///< color times lux (directional) or candela (point, spot)
    float inverse_range = 0;         ///< [1/m] of both kinds; 0: no range
    float cone_scale = 0, cone_offset = 1;
    int32_t shadow = -1;  ///< the caller's number of its shadow map; -1: none
};

/// KHR_lights_punctual's cone from the cosines of its half angles; inner <= outer, so cos_inner >= cos_outer.
void set_cone(LightParameters& light, float cos_inner, float cos_outer);

}  // namespace rakelight::lighting
