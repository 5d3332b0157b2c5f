// SPDX-License-Identifier: Apache-2.0
// From sums in the world to unit vectors in each object's own space.
#pragma once
#include "geometry/vote_sums.h"

namespace rakelight::geometry {

/// A normal of the world in object space, unit. A matrix that flattens has no inverse; its normals lie along the only direction that
/// its cofactor matrix takes anywhere.
dvec3 to_object(const Placement& placement, dvec3 normal);

/// Output vertices whose own sum of normals is zero though faces vote.
using Cancelled = std::vector<std::uint32_t>;

/// Normals go back by the transposed matrix, tangents by the inverse, both then normalized; tangents by Gram-Schmidt against the
/// normal. Where there is no tangent (no texture area, or along the normal): the coordinate axis that is farthest from
/// the normal in the world (x before y before z), made perpendicular to it; w = +1.
/// @param out  [meshes] is replaced
Cancelled finish_vertices(const VoteSums& sums, const Topology& topology, const AttributeInput& input,
                          const AttributeOptions& options, std::vector<MeshAttributes>& out, Context& context);

/// The same into buffers of the caller. @param splits  [meshes] is replaced
Cancelled finish_vertices(const VoteSums& sums, const Topology& topology, const AttributeInput& input,
                          const AttributeOptions& options, std::span<const AttributeBuffers> out,
                          std::vector<SplitAttributes>& splits, Context& context);

}  // namespace rakelight::geometry
