// SPDX-License-Identifier: Apache-2.0
// Normals of morph targets: offsets from new normals to those of the morphed surface.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// The directions of one mesh's targets, [V'] offsets each; empty where none are to be had.
struct TargetDirections {
    std::vector<std::vector<vec3>> normals, tangents;  ///< [targets]
};

/// True if a target gets normals beside new ones of its mesh: it moves positions, and had normals or the mesh had none
/// (a file whose targets keep the normals of their mesh stays so).
bool wants_normals(const Mesh& mesh, const MorphTarget& target);

/// Targets that move at once: at most one of each mesh.
struct MorphPose {
    std::vector<std::pair<std::size_t, std::size_t>> targets;  ///< entry of `numbers`, target of that mesh
};

/// Which targets move together: those of one name (and, for each mesh, that name for the same time), since they are the parts of one
/// movement. Movements in different islands stand in one pose, for neither changes anything for the other: a file of many
/// models takes as many poses as the one with the most targets.
///
/// @param islands  [numbers] as geometry::mesh_islands() gives them
std::vector<MorphPose> morph_poses(const Scene& scene, std::span<const std::uint32_t> numbers,
                                   std::span<const std::uint32_t> islands);

/// The normals (and tangents, where a target had some and the mesh gets new ones) of each morphed mesh less those of
/// the unmorphed one. The groups are the plan's, so what is joined or creased stays so while it moves. Targets of equal
/// names in different meshes (the parts of one face) move together: their borders stay closed.
///
/// @param numbers  [meshes] into scene.meshes; `meshes` as they were given to group() for `plan`
/// @param base     [meshes] what accumulate(plan, meshes) gave
std::vector<TargetDirections> target_directions(const Scene& scene, std::span<const std::uint32_t> numbers,
                                                std::span<const AttributeMesh> meshes, const AttributePlan& plan,
                                                std::span<const MeshAttributes> base, Context& context);

}  // namespace rakelight
