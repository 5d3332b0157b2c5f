// SPDX-License-Identifier: Apache-2.0
// Skins, morph targets and animations of a scene as glTF JSON.
#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "io/gltf/write/glb_writer_pointers.h"
#include "io/gltf/write/save_data.h"

namespace rakelight::io::gltf {

/// Adds to primitives and nodes what moves them. Nodes of the file have the scene's numbers.
class MotionWriter {
public:
    MotionWriter(OrderedJson& root, const Scene& scene, Context& context);

    /// JOINTS_n and WEIGHTS_n, where a node with a skin shows the mesh.
    void add_influences(OrderedJson& attributes, const Mesh& mesh, std::uint32_t number, NewData& data) const;
    /// "targets"; as many as the primitive of the glTF mesh with the most has, since all must have as many.
    void add_targets(OrderedJson& primitive, const Mesh& mesh, std::size_t count, NewData& data) const;
    /// The number of the file's skin for a node's meshes, whose positions count from `origin`; it is made when it is new.
    std::uint32_t skin_of(std::uint32_t skin, dvec3 origin, NewData& data);
    /// All clips; channels that glTF cannot store, or that move nothing that was written, are left out, and reported.
    /// @param mesh_node  [nodes] the node of the file that shows its meshes, or `no_index`
    /// @return whether KHR_animation_pointer is used
    bool animations(const std::vector<std::size_t>& mesh_node, PointerWriter& pointers, NewData& data);

private:
    bool add_channel(OrderedJson& clip, const AnimationChannel& channel, const std::vector<std::size_t>& mesh_node,
                     NewData& data) const;
    bool add_pointers(OrderedJson& clip, const AnimationChannel& channel, PointerWriter& pointers, NewData& data) const;

    OrderedJson& root_;
    const Scene& scene_;
    Context& context_;
    std::vector<bool> is_skinned_;                                                  ///< [meshes]
    std::map<std::pair<std::uint32_t, std::vector<double>>, std::uint32_t> skins_;  ///< by the scene's skin and origin
};

/// The largest number of morph targets of some meshes.
std::size_t target_count(const Scene& scene, const std::vector<std::uint32_t>& meshes);

}  // namespace rakelight::io::gltf
