// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/lights.h"

#include <algorithm>
#include <cmath>

#include <rakelight/scene/light_limits.h>

#include "math/functions.h"
#include "math/linear.h"

namespace rakelight::shading {
namespace {

using lighting::LightKind;
using lighting::LightParameters;

LightKind kind_of(LightType type) {
    switch (type) {
        case LightType::ambient:
            return LightKind::ambient;
        case LightType::directional:
            return LightKind::directional;
        case LightType::point:
            return LightKind::point;
        case LightType::spot:
            return LightKind::spot;
    }
    return LightKind::point;
}

void copy(float (&to)[3], vec3 from) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

void set_classical(LightParameters& p, const Light& light) {
    copy(p.ambient, light.ambient);
    copy(p.diffuse, light.diffuse);
    copy(p.specular, light.specular);
    p.constant_term = light.constant;
    p.linear_term = light.linear;
    p.quadratic_term = light.quadratic;
    p.cos_cutoff = float(math::cos(light.cutoff_rad));
    p.exponent = light.exponent;
}

void set_photometric(LightParameters& p, const Light& light) {
    p.is_photometric = true;
    copy(p.intensity, light.color * light.intensity);
    lighting::set_cone(p, float(math::cos(light.inner_cone_rad)), float(math::cos(light.outer_cone_rad)));
}

}  // namespace

LightPlace place_of(const Light& light, const std::vector<dmat4>& node_to_world) {
    LightPlace out{light.position, light.direction};
    if (light.node != no_index) {
        const dmat4& m = node_to_world[light.node];
        out = {m[3].xyz(), -m[2].xyz()};
    }
    out.direction = normalize_or(out.direction, {0, 0, -1});
    return out;
}

bool casts_shadow(const Light& light) { return light.type != LightType::ambient && light.casts_shadow; }

std::vector<LightParameters> make_lights(const Scene& scene, const std::vector<dmat4>& node_to_world, dvec3 eye) {
    std::vector<LightParameters> lights;
    for (const Light& light : scene.lights) {
        const LightPlace at = place_of(light, node_to_world);
        LightParameters p;
        p.kind = kind_of(light.type);
        p.casts_shadow = casts_shadow(light);
        copy(p.position, cast<float>(at.position - eye));
        copy(p.direction, cast<float>(at.direction));
        if (std::isfinite(light.range)) p.inverse_range = 1.0f / std::max(light.range, float(min_light_range));
        if (light.units == LightUnits::photometric)
            set_photometric(p, light);
        else
            set_classical(p, light);
        lights.push_back(p);
    }
    return lights;
}

}  // namespace rakelight::shading
