// SPDX-License-Identifier: Apache-2.0
// One scene into another: every number that refers to an array grows by what was there before.
#include <rakelight/error.h>

#include "math/linear.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

void shift(std::uint32_t& index, std::uint32_t by) {
    if (index != none) index += by;
}

std::uint32_t sum(std::size_t a, std::size_t b) {
    if (a + b >= none) throw Error(ErrorCode::bad_file, "too many elements for 32-bit indices");
    return std::uint32_t(a);
}

Material shifted(Material m, const MergeOffsets& by) {
    for_each_texture_use(m, [&](TextureUse& use) { shift(use.texture, by.textures); });
    return m;
}

void add_nodes(Scene& into, const Scene& part, const Node* root, const MergeOffsets& by) {
    if (root) into.nodes.push_back(*root);
    for (Node node : part.nodes) {
        if (root && node.parent == none)
            node.parent = by.nodes - 1;
        else
            shift(node.parent, by.nodes);
        for (std::uint32_t& mesh : node.meshes) shift(mesh, by.meshes);
        shift(node.skin, by.skins);
        into.nodes.push_back(std::move(node));
    }
}

void add_motion(Scene& into, const Scene& part, const MergeOffsets& by) {
    for (Skin skin : part.skins) {
        for (std::uint32_t& joint : skin.joints) shift(joint, by.nodes);
        into.skins.push_back(std::move(skin));
    }
    for (Animation animation : part.animations) {
        for (AnimationChannel& channel : animation.channels) shift(channel.node, by.nodes);
        into.animations.push_back(std::move(animation));
    }
}

/// What stands in the world and not at a node follows the new node, too.
void add_lights_and_cameras(Scene& into, const Scene& part, const Node* root, const MergeOffsets& by) {
    const auto place = [&](std::uint32_t& node) {
        shift(node, by.nodes);
        return root && node == none;
    };
    const dmat4 to_world = root ? root->local.matrix
                                      ? *root->local.matrix
                                      : compose(root->local.translation, root->local.rotation, root->local.scale)
                                : dmat4{};
    for (Light light : part.lights) {
        if (place(light.node)) {
            light.position = transform_point(to_world, light.position);
            light.direction = normalize_or(transform_direction(to_world, light.direction), light.direction);
        }
        into.lights.push_back(std::move(light));
    }
    for (Camera camera : part.cameras) {
        if (place(camera.node)) {
            const dvec3 eye = camera.to_world[3].xyz();
            const dvec3 target = eye - camera.to_world[2].xyz();
            camera.to_world = look_at(transform_point(to_world, eye), transform_point(to_world, target),
                                      transform_direction(to_world, camera.to_world[1].xyz()));
        }
        into.cameras.push_back(std::move(camera));
    }
}

}  // namespace

MergeOffsets merge_scene(Scene& into, const Scene& part, const Node* root) {
    const MergeOffsets by{sum(into.nodes.size() + (root ? 1 : 0), part.nodes.size()),
                          sum(into.meshes.size(), part.meshes.size()),
                          sum(into.materials.size(), part.materials.size()),
                          sum(into.textures.size(), part.textures.size()), sum(into.skins.size(), part.skins.size())};
    add_nodes(into, part, root, by);
    for (Mesh mesh : part.meshes) {
        shift(mesh.material, by.materials);
        into.meshes.push_back(std::move(mesh));
    }
    for (const Material& m : part.materials) into.materials.push_back(shifted(m, by));
    into.textures.insert(into.textures.end(), part.textures.begin(), part.textures.end());
    add_motion(into, part, by);
    add_lights_and_cameras(into, part, root, by);
    into.charges.insert(into.charges.end(), part.charges.begin(), part.charges.end());
    return by;
}

}  // namespace rakelight
