// SPDX-License-Identifier: Apache-2.0
// The node hierarchy of the default scene: parents first, instances as children, meshes and skins attached.
#pragma once
#include "io/gltf/meshes.h"
#include "io/gltf/motion/skins.h"

namespace rakelight::io::gltf {

/// A node of the file that the scene holds.
struct PlacedNode {
    std::uint32_t file = no_index;   ///< index in the file
    std::uint32_t scene = no_index;  ///< index in Scene::nodes
};

class Nodes {
public:
    Nodes(Accessors& accessors, Meshes& meshes, Scene& scene) : accessors_(accessors), meshes_(meshes), scene_(scene) {}

    /// Places the nodes of the default scene (`scene`, else scene 0, else all nodes that are nobody's children), depth
    /// first without recursion. Others are left out.
    /// @throws Error: a node reached twice (a cycle, two parents), children or meshes that do not exist.
    void read();

    const std::vector<PlacedNode>& placed() const { return placed_; }
    /// Scene index of the file's node, `no_index` when it is not part of the scene.
    std::uint32_t scene_index(std::uint32_t file) const { return file < scene_of_.size() ? scene_of_[file] : no_index; }

private:
    /// Small: a list of children may be longer than the file has nodes.
    struct Waiting {
        std::uint32_t file, parent;
    };
    std::vector<Waiting> roots();
    void place(const Waiting& waiting, std::vector<Waiting>& stack);
    void attach_mesh(const Value& source, std::uint32_t node);
    void say_what_other_scenes_show() const;
    void add_instances(const Value& source, const Value& extension, std::uint32_t node);
    const Document& document() const { return accessors_.document(); }

    Accessors& accessors_;
    Meshes& meshes_;
    Scene& scene_;
    std::vector<PlacedNode> placed_;
    std::vector<std::uint32_t> scene_of_;
    Value roots_from_;  ///< what lists the roots: the place of messages about them
};

}  // namespace rakelight::io::gltf
