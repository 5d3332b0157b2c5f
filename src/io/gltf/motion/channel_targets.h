// SPDX-License-Identifier: Apache-2.0
// What a channel of an animation moves: nodes, and what pointers name (KHR_animation_pointer).
#pragma once
#include <map>
#include <string>
#include <vector>

#include "io/gltf/nodes.h"

namespace rakelight::io::gltf {

/// One light, camera or material of the file may be several elements of the scene, or none.
struct ChannelTarget {
    AnimationPath path = AnimationPath::translation;
    std::string property{};
    std::vector<std::uint32_t> elements{};  ///< of the scene
    std::uint32_t width = 1;                ///< components of the accessor of key values
    /// What the file's key values are multiplied by: one factor for all; or three, and each number becomes three. Empty: nothing.
    std::vector<float> factors{};
};

class ChannelTargets {
public:
    /// @param cameras, lights  [of the scene] their numbers in the file
    ChannelTargets(const Document& document, const Nodes& nodes, const Materials& materials,
                   const std::vector<std::uint32_t>& cameras, const std::vector<std::uint32_t>& lights,
                   const Scene& scene);

    /// @throws Error bad_file: what it names does not exist, or cannot be moved
    ChannelTarget of(const Value& channel) const;

private:
    ChannelTarget of_node(const Value& target) const;
    ChannelTarget of_pointer(const std::string& pointer, const Value& channel) const;
    ChannelTarget of_node_part(std::uint32_t node, const std::string& part, const Value& channel) const;
    ChannelTarget of_mesh_weights(std::uint32_t mesh, const Value& channel) const;
    ChannelTarget of_element(AnimationPath path, std::uint32_t index, const std::string& place,
                             const Value& channel) const;
    void set_emission(const Value& material, bool is_strength, ChannelTarget& target) const;

    using Elements = std::map<std::uint32_t, std::vector<std::uint32_t>>;  ///< of the file -> of the scene
    const Document& document_;
    const Nodes& nodes_;
    const Materials& materials_;
    const Scene& scene_;
    Elements cameras_, lights_, meshes_;  ///< meshes: the nodes that show them and have no weights of their own
};

}  // namespace rakelight::io::gltf
