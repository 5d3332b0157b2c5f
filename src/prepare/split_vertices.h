// SPDX-License-Identifier: Apache-2.0
// Splits vertices in all arrays of a mesh.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// [bytes] of one vertex in all arrays of the mesh.
std::uint64_t vertex_bytes(const Mesh& mesh);

/// Appends one vertex for each entry of `source_vertex` [each < V], and replaces the indices by `indices`. The new
/// vertex is a copy in all arrays of the mesh (normals, tangents, texture coordinates, colors, influences and morph
/// targets too). No effect if both are empty. The memory is checked against the budget.
void split_vertices(Mesh& mesh, std::vector<std::uint32_t> indices, std::span<const std::uint32_t> source_vertex,
                    Context& context);

}  // namespace rakelight
