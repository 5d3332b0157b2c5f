// SPDX-License-Identifier: Apache-2.0
// Converts sums in world space to unit vectors in object space.
#pragma once
#include "geometry/sums/vote_sums.h"

namespace rakelight::geometry {

/// A unit normal transformed from world to object space. For singular matrices: the only direction that the cofactor
/// matrix does not map to zero.
dvec3 to_object(const Placement& placement, dvec3 normal);

/// Output vertices with votes but a zero sum of normals.
using Cancelled = std::vector<std::uint32_t>;

/// Normals are transformed back by the transpose, tangents by the inverse; both are normalized, tangents after
/// Gram-Schmidt against the normal. Without a tangent (no texture area, or parallel to the normal): the coordinate axis
/// farthest from the world normal (x before y before z), orthogonalized; w = +1.
/// @param out  [meshes] is replaced
Cancelled finish_vertices(const VoteSums& sums, const Topology& topology, const AttributeInput& input,
                          const AttributeOptions& options, std::vector<MeshAttributes>& out, Context& context);

/// The same into buffers of the caller. @param splits  [meshes] is replaced
Cancelled finish_vertices(const VoteSums& sums, const Topology& topology, const AttributeInput& input,
                          const AttributeOptions& options, std::span<const AttributeBuffers> out,
                          std::vector<SplitAttributes>& splits, Context& context);

}  // namespace rakelight::geometry
