// SPDX-License-Identifier: Apache-2.0
#include "radiosity/static_scene.h"

namespace rakelight::radiosity {

Scene static_scene(Scene scene) {
    scene.lights.clear();
    if (scene.environment) scene.environment->is_light = false;
    for (std::size_t i = 0; scene.pose && i < scene.nodes.size(); ++i) scene.nodes[i].local = scene.pose->local[i];
    scene.pose = {};
    for (Node& node : scene.nodes) node.skin = no_index, node.morph_weights.clear();
    scene.skins.clear(), scene.animations.clear();
    scene.normal_sides.reset();
    return scene;
}

}  // namespace rakelight::radiosity
