// SPDX-License-Identifier: Apache-2.0
// Recomputes normals and tangents of prepare_scene() for posed vertices, with the groups of the bind pose.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/geometry/attributes.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// The stored inputs and result of one group() call.
struct GeneratedAttributes {
    AttributePlan plan;
    std::vector<AttributeMesh> meshes;       ///< inputs of group(); the spans point into the arrays below
    std::size_t computed = 0;                ///< of `meshes`: the others' normals are kept
    std::vector<Mesh> sources;               ///< [meshes]
    std::vector<Block<vec2>> texcoords;      ///< [meshes] of tangents
    std::vector<Block<std::uint8_t>> locks;  ///< [meshes] of kept normals
    std::vector<std::uint32_t> nodes;        ///< [meshes] nodes that place them
    std::vector<std::uint32_t> numbers;      ///< [meshes] meshes of the prepared scene that get the results
    std::vector<bool> in_world;              ///< [meshes] grouped in world space, else in object space
    std::vector<std::uint32_t> islands;      ///< [meshes] result of mesh_islands()
    std::vector<bool> moves;                 ///< [meshes] skinned or morphed
};

/// Recomputes moved meshes, and meshes that touch them, in the posed scene. Meshes of several instances, and meshes
/// whose vertices were split since, keep the normals of the pose.
void recompute_attributes(const GeneratedAttributes& made, Scene& posed, Context& context);

}  // namespace rakelight
