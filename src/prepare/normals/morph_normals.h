// SPDX-License-Identifier: Apache-2.0
// Normals of morph targets: offsets from computed normals to those of the morphed surface.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Normal and tangent offsets of one mesh's targets, [V'] each; empty if unavailable. Targets that turn nothing share
/// their zeros.
struct TargetDirections {
    std::vector<Block<vec3>> normals, tangents;  ///< [targets]
};

/// Whether a target gets normals if its mesh gets new ones: it moves positions, and had normals or the mesh had none.
/// (Targets without normals in a mesh with normals stay without.)
bool wants_normals(const Mesh& mesh, const MorphTarget& target);

/// Targets applied together: at most one per mesh.
struct MorphPose {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> targets;  ///< entry of `numbers`, target of that mesh
};

/// Groups targets by name (and occurrence of the name within a mesh), because they form one movement. Movements in
/// different islands share a pose, because they are independent: a file of many models takes as many poses as its model
/// with the most targets.
///
/// @param islands [numbers] result of geometry::mesh_islands()
std::vector<MorphPose> morph_poses(const Scene& scene, std::span<const std::uint32_t> numbers,
                                   std::span<const std::uint32_t> islands);

/// What group() was called with.
struct MorphInputs {
    std::span<const std::uint32_t> numbers;  ///< [meshes] into Scene::meshes
    std::span<const AttributeMesh> meshes;
    const AttributeOptions& options;
    std::span<const std::size_t> alike;  ///< [the first of `meshes`] first_alike(); others are wanted for their places
};

/// The normals (and tangents, if the target had some and the mesh gets new ones) of each morphed mesh minus those of
/// the unmorphed one. Uses the groups of the plan, so creases do not change in motion. Targets with equal names in
/// different meshes (the parts of a face) move together, so their borders stay closed. Of results that are alike only
/// the first one gets directions, so that a crowd takes as long as one of its members.
///
/// @param base [meshes] result of accumulate(plan, meshes)
std::vector<TargetDirections> target_directions(const Scene& scene, const MorphInputs& in, const AttributePlan& plan,
                                                std::span<const MeshAttributes> base, Context& context);

}  // namespace rakelight
