// SPDX-License-Identifier: Apache-2.0
// Normals and tangents that prepare has made, made again of moved vertices: groups and places stay those of the bind pose.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/scene.h>

namespace rakelight {

/// One call of group(), kept.
struct GeneratedAttributes {
    AttributePlan plan;
    std::vector<AttributeMesh> meshes;   ///< as they were grouped; the spans point into `sources`
    std::vector<Mesh> sources;           ///< [meshes]
    std::vector<std::uint32_t> nodes;    ///< [meshes] that place them
    std::vector<std::uint32_t> numbers;  ///< [meshes] that show the results, of the prepared scene
    std::vector<bool> in_world;          ///< [meshes] grouped at its place in the world, else about its own origin
    std::vector<std::uint32_t> islands;  ///< [meshes] of mesh_islands()
    std::vector<bool> moves;             ///< [meshes] follow a skin or have morph targets
};

/// The sums again, where something has moved (and in what touches it), into the meshes of the posed scene. A mesh that
/// several placements show, or whose vertices have been split since, keeps what posing made of its normals.
void recompute_attributes(const GeneratedAttributes& made, Scene& posed, Context& context);

}  // namespace rakelight
