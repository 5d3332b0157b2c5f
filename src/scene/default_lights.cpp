// SPDX-License-Identifier: Apache-2.0
// The default lights.
#include "math/linear.h"

#include <rakelight/scene/scene_queries.h>
#include "scene/placement.h"

namespace rakelight {
namespace {

Light directional(const char* name, float strength, const dmat4& camera_to_world, dvec3 toward_light_camera) {
    Light light;
    light.name = name;
    light.type = LightType::directional;
    light.diffuse = light.specular = {strength, strength, strength};
    light.direction = normalize_or(-transform_direction(camera_to_world, toward_light_camera), dvec3{0, 0, -1});
    return light;
}

}  // namespace

std::vector<Light> default_lights(const dmat4& camera_to_world) {
    Light ambient;
    ambient.name = "default ambient";
    ambient.type = LightType::ambient;
    ambient.ambient = {0.12f, 0.12f, 0.12f};
    ambient.diffuse = ambient.specular = {0, 0, 0};
    return {ambient, directional("default key", 0.68f, camera_to_world, {-0.5, 0.7, 0.8}),
            directional("default fill", 0.2f, camera_to_world, {0.8, 0.1, 0.6})};
}

std::vector<Light> studio_lights(const dmat4& camera_to_world) {
    return {directional("studio key", 0.3f, camera_to_world, {-0.5, 0.7, 0.8})};
}

}  // namespace rakelight
