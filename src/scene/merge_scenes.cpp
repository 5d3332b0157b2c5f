// SPDX-License-Identifier: Apache-2.0
// Merges scenes: every index is offset by the size of the preceding arrays.
#include "scene/merge_scenes.h"

#include <map>

#include <rakelight/base/error.h>

#include "math/linear.h"
#include "scene/charge_arrays.h"
#include "scene/materials/texture_uses.h"

namespace rakelight {
namespace {

void shift(std::uint32_t& index, std::uint32_t by) {
    if (index != no_index) index += by;
}

std::size_t nodes_of(const ScenePart& part) { return part.scene.nodes.size() + (part.root ? 1 : 0); }

/// Sizes of the tables, so that none of them grows by doubling.
struct Counts {
    std::size_t nodes = 0, meshes = 0, materials = 0, textures = 0, skins = 0, animations = 0, lights = 0, cameras = 0;

    void add(const ScenePart& part) {
        const Scene& s = part.scene;
        nodes += nodes_of(part), meshes += s.meshes.size(), materials += s.materials.size();
        textures += s.textures.size(), skins += s.skins.size(), animations += s.animations.size();
        if (part.with_lights) lights += s.lights.size();
        if (part.with_cameras) cameras += s.cameras.size();
        for (const std::size_t count : {nodes, meshes, materials, textures, skins})
            if (count >= no_index) throw Error(ErrorCode::bad_file, "too many elements for 32-bit indices");
    }
    void reserve(Scene& in) const {
        in.nodes.reserve(nodes), in.meshes.reserve(meshes), in.materials.reserve(materials);
        in.textures.reserve(textures), in.skins.reserve(skins), in.animations.reserve(animations);
        in.lights.reserve(lights), in.cameras.reserve(cameras);
    }
};

/// Every use of a part counts, because a few bytes in a file can repeat it. Each node also counts its world matrix.
MemoryCharge charge_for(std::span<const ScenePart> parts, Context& context) {
    std::map<const Scene*, std::uint64_t> tables;
    std::uint64_t bytes = 0;
    for (const ScenePart& part : parts) {
        const auto [entry, is_new] = tables.try_emplace(&part.scene, 0);
        if (is_new) entry->second = table_bytes(part.scene);
        bytes += entry->second + (part.root ? table_bytes(*part.root) : 0) + nodes_of(part) * sizeof(dmat4);
    }
    return {context.memory(), bytes, "the scene of all parts"};
}

Material shifted(Material m, const MergeOffsets& by) {
    for_each_texture_use(m, [&](TextureUse& use) { shift(use.texture, by.textures); });
    return m;
}

void add_nodes(Scene& into, const Scene& part, const std::optional<Node>& root, const MergeOffsets& by) {
    if (root) into.nodes.push_back(*root);
    for (Node node : part.nodes) {
        if (root && node.parent == no_index)
            node.parent = by.nodes - 1;
        else
            shift(node.parent, by.nodes);
        for (std::uint32_t& mesh : node.meshes) shift(mesh, by.meshes);
        shift(node.skin, by.skins);
        into.nodes.push_back(std::move(node));
    }
}

/// Index offset of a channel's target.
std::uint32_t elements_before(AnimationPath path, const MergeOffsets& by) {
    switch (path) {
        case AnimationPath::material:
            return by.materials;
        case AnimationPath::light:
            return by.lights;
        case AnimationPath::camera:
            return by.cameras;
        default:
            return by.nodes;
    }
}

/// Channels follow their lights and cameras.
bool is_kept(const AnimationChannel& channel, const ScenePart& part) {
    return (channel.path != AnimationPath::light || part.with_lights) &&
           (channel.path != AnimationPath::camera || part.with_cameras);
}

void add_motion(Scene& into, const ScenePart& added, const MergeOffsets& by) {
    const Scene& part = added.scene;
    for (Skin skin : part.skins) {
        for (std::uint32_t& joint : skin.joints) shift(joint, by.nodes);
        into.skins.push_back(std::move(skin));
    }
    for (Animation animation : part.animations) {
        std::erase_if(animation.channels, [&](const AnimationChannel& c) { return !is_kept(c, added); });
        for (AnimationChannel& channel : animation.channels) shift(channel.element, elements_before(channel.path, by));
        into.animations.push_back(std::move(animation));
    }
}

/// Lights and cameras in world space are attached to the new node.
class Follower {
public:
    Follower(const std::optional<Node>& root, const MergeOffsets& by) : has_root_(root), by_(by) {
        if (!root) return;
        const Transform& t = root->local;
        to_world_ = t.matrix ? *t.matrix : compose(t.translation, t.rotation, t.scale);
    }

    Light moved(Light light) const {
        if (is_in_world(light.node)) {
            light.position = transform_point(to_world_, light.position);
            light.direction = normalize_or(transform_direction(to_world_, light.direction), light.direction);
        }
        return light;
    }
    Camera moved(Camera camera) const {
        if (is_in_world(camera.node)) {
            const dvec3 eye = camera.to_world[3].xyz();
            const dvec3 target = eye - camera.to_world[2].xyz();
            camera.to_world = look_at(transform_point(to_world_, eye), transform_point(to_world_, target),
                                      transform_direction(to_world_, camera.to_world[1].xyz()));
        }
        return camera;
    }

private:
    bool is_in_world(std::uint32_t& node) const {
        shift(node, by_.nodes);
        return has_root_ && node == no_index;
    }

    bool has_root_;
    const MergeOffsets& by_;
    dmat4 to_world_;
};

MergeOffsets add_part(Scene& into, const ScenePart& added) {
    const Scene& part = added.scene;
    const MergeOffsets by{std::uint32_t(into.nodes.size() + (added.root ? 1 : 0)),
                          std::uint32_t(into.meshes.size()),
                          std::uint32_t(into.materials.size()),
                          std::uint32_t(into.textures.size()),
                          std::uint32_t(into.skins.size()),
                          std::uint32_t(into.lights.size()),
                          std::uint32_t(into.cameras.size())};
    add_nodes(into, part, added.root, by);
    for (Mesh mesh : part.meshes) {
        shift(mesh.material, by.materials);
        into.meshes.push_back(std::move(mesh));
    }
    for (const Material& m : part.materials) into.materials.push_back(shifted(m, by));
    into.textures.insert(into.textures.end(), part.textures.begin(), part.textures.end());
    add_motion(into, added, by);
    const Follower follower(added.root, by);
    if (added.with_lights)
        for (const Light& light : part.lights) into.lights.push_back(follower.moved(light));
    if (added.with_cameras)
        for (const Camera& camera : part.cameras) into.cameras.push_back(follower.moved(camera));
    return by;
}

}  // namespace

MergedScene merge_scenes(std::span<const ScenePart> parts, Context& context) {
    Counts counts;
    for (const ScenePart& part : parts) counts.add(part);
    MergedScene merged;
    merged.scene.charges.push_back(share(charge_for(parts, context)));
    counts.reserve(merged.scene);
    for (const ScenePart& part : parts) {
        context.throw_if_cancelled();
        merged.offsets.push_back(add_part(merged.scene, part));
    }
    return merged;
}

}  // namespace rakelight
