// SPDX-License-Identifier: Apache-2.0
// Vertices without a normal: those of meshes without normals, and those whose normal is zero or not finite.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "prepare/repair/repair.h"

namespace rakelight {

/// Vertices that triangles use, whose entry of Mesh::normals is no normal.
struct NormalGaps {
    std::vector<std::uint8_t> at{};  ///< [V] 1: a gap; empty: there are none
    std::uint64_t count = 0;
    bool is_all = false;  ///< no used vertex has a normal
};
NormalGaps normal_gaps(std::span<const vec3> normals, std::span<const std::uint32_t> indices);
NormalGaps normal_gaps(const Mesh& mesh);

/// Vertices that triangles use and that have no normal, over all drawn triangle meshes.
std::uint64_t count_missing_normals(const Scene& scene);

/// Whether the mesh has no normals, or gaps in them.
bool lacks_normals(const Mesh& mesh);

/// Drops normals of which all are gaps; said in `findings`, as single gaps are.
NormalGaps drop_if_all_gaps(Mesh& mesh, std::vector<Finding>& findings);
/// Of all drawn triangle meshes; said in the report. Absent: each of them has normals of use, or none.
/// @throws Error bad_file: over the memory budget
std::optional<Scene> without_useless_normals(const Scene& scene, Context& context);

/// [V] AttributeMesh::locked of a mesh's normals: what is a normal is authored.
Block<std::uint8_t> authored_locks(std::span<const vec3> normals);

}  // namespace rakelight
